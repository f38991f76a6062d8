#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/geometry/valve_generator.h>
#include <coapt/valve_task.h>

namespace coapt
{
  void
  ValveTask::declare_parameters(dealii::ParameterHandler &prm) const
  {
    SimulationParameters::declare_parameters(prm);
  }



  const RunParameters &
  ValveTask::read(const std::string &file, dealii::ParameterHandler &prm)
  {
    parameters.read(file, prm);
    return parameters.run;
  }



  void
  ValveTask::build(Log &log, MPI_Comm communicator)
  {
    simulation = std::make_unique<Simulation>(parameters, log, communicator);
  }



  void
  ValveTask::run(const OutputFolder &folder)
  {
    simulation->run(folder);
  }



  void
  ValveTask::preview(Log &log, MPI_Comm communicator)
  {
    Timing timing;
    ValveModel model(parameters.model, timing, communicator);
    model.state_at_rest(); // distributes the points that are checked
    model.check_resolution(log);
    const std::string folder = parameters.run.output_folder + "/geometry";
    on_first_rank(communicator, [&]() -> std::string {
      try
        {
          write_valve_preview(folder, model.leaflet, model.chordae->chordae());
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    });
    log.line("The valve is in " + folder);
  }
} // namespace coapt
