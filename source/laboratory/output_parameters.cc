#include <coapt/base/exceptions.h>
#include <coapt/laboratory/output_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <stdexcept>

namespace coapt
{
  using namespace dealii;

  void
  declare_output(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.declare_entry("Folder",
                      RunParameters().output_folder,
                      Patterns::FileName(Patterns::FileName::output),
                      "Folder for all results, relative to the folder in "
                      "which the program is started. Created if necessary.");
    prm.declare_entry("Overwrite",
                      "false",
                      Patterns::Bool(),
                      "Whether results of an earlier run in the folder may "
                      "be overwritten.");
    prm.leave_subsection();
  }



  void
  parse_output(ParameterHandler &prm, RunParameters &run)
  {
    prm.enter_subsection("Output");
    run.output_folder = prm.get("Folder");
    run.overwrite     = prm.get_bool("Overwrite");
    prm.leave_subsection();
    if (run.output_folder.empty())
      throw InputError("Output/Folder is empty, a folder's name is needed");
  }



  void
  write_text(const std::string &path, const std::string &text)
  {
    std::ofstream file(path);
    file << text;
    if (!file.flush())
      throw std::runtime_error(path + ": cannot be written");
  }
} // namespace coapt
