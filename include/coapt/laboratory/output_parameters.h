#ifndef coapt_laboratory_output_parameters_h
#define coapt_laboratory_output_parameters_h

#include <coapt/base/run_parameters.h>

namespace coapt
{
  /** Declares where the results of a task without time go: the entries Folder
   * and Overwrite of the subsection "Output". */
  void
  declare_output(dealii::ParameterHandler &prm);

  /** Reads them into @p run. @throws InputError if there is no folder. */
  void
  parse_output(dealii::ParameterHandler &prm, RunParameters &run);

  /** Writes @p text into the file @p path. @throws std::runtime_error if that
   * cannot be done. */
  void
  write_text(const std::string &path, const std::string &text);
} // namespace coapt

#endif
