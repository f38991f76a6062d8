#ifndef coapt_base_parameter_file_h
#define coapt_base_parameter_file_h

#include <coapt/base/exceptions.h>

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

  /** Calls @p action and puts the name of the parameter @p file before the
   * message of an InputError that it throws. */
  template <typename Action>
  void
  with_file_name(const std::string &file, const Action &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
  }
} // namespace coapt

#endif
