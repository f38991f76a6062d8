#ifndef coapt_io_command_line_h
#define coapt_io_command_line_h

#include <string>

namespace coapt
{
  /** What the program's exit code means. */
  enum ExitCode : int
  {
    success           = 0,
    numerical_failure = 1,
    bad_input         = 2
  };

  /** What the user asks for on the command line. */
  struct CommandLine
  {
    enum class Action
    {
      run,
      check,
      preview,
      write_defaults,
      write_json,
      version,
      help
    };

    Action action = Action::help;

    /** The parameter file, for run, check and preview. */
    std::string file;

    /** The task whose defaults are wanted. */
    std::string task = "valve";

    /**
     * Reads the arguments of main().
     *
     * @throws InputError for an unknown option, and if the parameter file is
     * missing or there is more than one.
     */
    static CommandLine
    parse(const int argc, const char *const *argv);

    /** How to call the program, some lines. */
    static std::string
    usage();
  };
} // namespace coapt

#endif
