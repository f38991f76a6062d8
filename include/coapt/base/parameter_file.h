#ifndef coapt_base_parameter_file_h
#define coapt_base_parameter_file_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** What to do about entries and subsections that are not declared. */
  enum class UnknownEntries
  {
    refuse,
    skip
  };

  /**
   * Reads @p file into @p prm, in which everything has been declared.
   *
   * @throws InputError with file, line and reason on one line if the file
   * cannot be read, an entry or subsection is unknown and not skipped (with the
   * declared name that comes nearest), or a value does not fit its pattern.
   */
  void
  read_parameter_file(dealii::ParameterHandler &prm,
                      const std::string &file,
                      const UnknownEntries unknown = UnknownEntries::refuse);
} // namespace coapt

#endif
