#include <coapt/base/exceptions.h>
#include <coapt/io/command_line.h>

#include <map>
#include <vector>

namespace coapt
{
  CommandLine
  CommandLine::parse(const int argc, const char *const *argv)
  {
    static const std::map<std::string, Action> options = {
      {"--check", Action::check},
      {"--preview", Action::preview},
      {"--write-defaults", Action::write_defaults},
      {"--write-json", Action::write_json},
      {"--version", Action::version},
      {"--help", Action::help},
      {"-h", Action::help}};

    CommandLine result;
    result.action = Action::run;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i)
      {
        const std::string argument = argv[i];
        const auto option          = options.find(argument);
        if (option != options.end())
          result.action = option->second;
        else if (argument.front() == '-')
          throw InputError("unknown option '" + argument + "'; try --help");
        else
          files.push_back(argument);
      }

    const bool needs_file = result.action == Action::run ||
      result.action == Action::check || result.action == Action::preview;
    const bool takes_task = result.action == Action::write_defaults ||
      result.action == Action::write_json;
    if (takes_task && files.size() == 1)
      {
        result.task = files.front();
        files.clear();
      }
    if (files.size() != (needs_file ? 1 : 0))
      throw InputError(
        std::to_string(files.size()) + " parameter file(s) given, " +
        (needs_file ? "one is" : "none is") + " expected; try --help");
    if (needs_file)
      result.file = files.front();
    return result;
  }



  std::string
  CommandLine::usage()
  {
    return "coapt FILE.prm           runs a parameter file\n"
           "coapt --check FILE.prm   checks a parameter file and all that it "
           "names, and runs nothing\n"
           "coapt --preview FILE.prm writes the valve for a look at it into "
           "geometry/ of the output folder\n"
           "coapt --write-defaults [TASK]\n"
           "                         prints all parameters of a task (valve, "
           "flow, immersed,\n"
           "                         biaxial or fit) with their defaults and "
           "documentation\n"
           "coapt --write-json [TASK]\n"
           "                         the same for other programs, with the "
           "values that are allowed\n"
           "coapt --version          prints the versions of program and "
           "libraries\n"
           "coapt --help             prints this\n"
           "\n"
           "Parallel: mpirun -np N coapt FILE.prm\n"
           "Exit code: 0 success, 1 numerical failure, 2 bad input";
  }
} // namespace coapt
