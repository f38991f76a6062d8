#include <coapt/base/exceptions.h>
#include <coapt/simulation.h>
#include <coapt/structure_simulation.h>
#include <coapt/valve_run.h>

namespace coapt
{
  void
  SimulationParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    RunParameters::declare_parameters(prm);
    RunParameters::declare_checkpoints(prm);
    StepParameters::declare_parameters(prm);
    StructureParameters::declare_parameters(prm);
    ModelParameters::declare_parameters(prm);
  }



  void
  SimulationParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    run.parse_parameters(prm);
    run.parse_checkpoints(prm);
    step.parse_parameters(prm);
    structure.parse_parameters(prm);
    model.parse_parameters(prm);
    if (structure.in_blood && model.import.is_wanted)
      throw InputError("Valve/Source = imported needs Structure/Fluid = none; "
                       "blood flows around generated valves only");
    if (structure.in_blood)
      model.contact.check_damping();
  }



  std::unique_ptr<ValveRun>
  make_valve_run(const SimulationParameters &parameters,
                 Log &log,
                 MPI_Comm communicator)
  {
    if (parameters.structure.in_blood)
      return std::make_unique<Simulation>(parameters, log, communicator);
    return std::make_unique<StructureSimulation>(parameters, log, communicator);
  }
} // namespace coapt
