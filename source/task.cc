#include <coapt/base/exceptions.h>
#include <coapt/base/parameter_file.h>
#include <coapt/biaxial_task.h>
#include <coapt/fit_task.h>
#include <coapt/flow_task.h>
#include <coapt/task.h>
#include <coapt/valve_task.h>

namespace coapt
{
  void
  Task::check_checkpoint(const OutputFolder &)
  {
    // Most tasks have none.
  }



  void
  Task::preview(Log &, MPI_Comm)
  {
    throw InputError("this task has no geometry to preview");
  }



  std::unique_ptr<Task>
  make_task(const std::string &name)
  {
    if (name == "valve")
      return std::make_unique<ValveTask>();
    if (name == "flow")
      return std::make_unique<FlowTask>(FlowContents::nothing);
    if (name == "immersed")
      return std::make_unique<FlowTask>(FlowContents::bodies);
    if (name == "biaxial")
      return std::make_unique<BiaxialTask>();
    if (name == "fit")
      return std::make_unique<FitTask>();
    throw InputError("unknown task '" + name +
                     "'; there are valve, flow, immersed, biaxial and "
                     "fit");
  }



  void
  declare_task(dealii::ParameterHandler &prm, const std::string &name)
  {
    prm.declare_entry("Task",
                      name,
                      dealii::Patterns::Selection(
                        "valve|flow|immersed|biaxial|fit"),
                      "What to compute: the closure of a valve, the flow of a "
                      "fluid alone in a box, or one with elastic bodies in "
                      "it, the biaxial test of a sheet, or a material fitted "
                      "to measurements. It decides which parameters there "
                      "are.");
  }



  std::string
  task_of_file(const std::string &file)
  {
    dealii::ParameterHandler prm;
    declare_task(prm, "valve");
    read_parameter_file(prm, file, UnknownEntries::skip);
    return prm.get("Task");
  }
} // namespace coapt
