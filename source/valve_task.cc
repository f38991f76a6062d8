#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/base/parameter_file.h>
#include <coapt/coupled/valve_model.h>
#include <coapt/geometry/valve_generator.h>
#include <coapt/valve_task.h>

#include <filesystem>

namespace coapt
{
  void
  ValveTask::declare_parameters(dealii::ParameterHandler &prm) const
  {
    SimulationParameters::declare_parameters(prm);
    VariedParameters::declare_parameters(prm);
  }



  const RunParameters &
  ValveTask::read(const std::string &file, dealii::ParameterHandler &prm)
  {
    this->prm = &prm;
    read_parameter_file(prm, file);
    with_file_name(file, [&]() {
      parameters.parse_parameters(prm);
      varied.parse_parameters(prm);
      if (varied.n_runs() == 0 && !parameters.structure.in_blood &&
          parameters.run.resume != Resume::never)
        throw InputError("Output/Resume = false is needed with Structure/Fluid "
                         "= none; only a valve in blood has checkpoints");
    });
    parameters.model.folder =
      std::filesystem::path(file).parent_path().string();
    return parameters.run;
  }



  void
  ValveTask::build(Log &log, MPI_Comm communicator)
  {
    if (varied.n_runs() == 0)
      {
        simulation = make_valve_run(parameters, log, communicator);
        return;
      }
    study =
      std::make_unique<ValveStudy>(parameters, varied, *prm, log, communicator);
  }



  void
  ValveTask::check_checkpoint(const OutputFolder &folder)
  {
    if (study)
      study->check_checkpoint(folder);
    else
      simulation->check_checkpoint(folder);
  }



  void
  ValveTask::run(const OutputFolder &folder)
  {
    if (study)
      study->run(folder);
    else
      simulation->run(folder);
  }



  void
  ValveTask::preview(Log &log, MPI_Comm communicator)
  {
    if (!parameters.structure.in_blood)
      return write_preview(ValveStructure(parameters.model, communicator), log);
    Timing timing;
    ValveModel model(parameters.model, timing, communicator);
    model.state_at_rest(); // distributes the points that are checked
    model.check_resolution(log);
    write_preview(model, log);
  }



  void
  ValveTask::write_preview(const ValveStructure &valve, Log &log) const
  {
    const std::string folder = parameters.run.output_folder + "/geometry";
    on_first_rank(valve.communicator, [&]() -> std::string {
      write_valve_preview(folder, valve.leaflet, valve.chordae->chordae());
      return "";
    });
    log.line("The valve is in " + folder);
  }
} // namespace coapt
