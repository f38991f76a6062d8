#ifndef coapt_base_exceptions_h
#define coapt_base_exceptions_h

#include <stdexcept>
#include <string>

namespace coapt
{
  /**
   * The input is wrong: a parameter, a file, a mesh. The message is one line
   * that says what was found, what is allowed, and where. Ends the program
   * with exit code 2.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The computation failed: a non-finite state, an integrator that gave up.
   * Ends the program with exit code 1.
   */
  class NumericalError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace coapt

#endif
