#ifndef coapt_structure_simulation_h
#define coapt_structure_simulation_h

#include <coapt/base/timing.h>
#include <coapt/coupled/valve_structure.h>
#include <coapt/io/recorder.h>
#include <coapt/metrics/structure_monitor.h>
#include <coapt/solid/largest_frequency.h>
#include <coapt/structure/structure_system.h>
#include <coapt/time/central_differences.h>
#include <coapt/time/step_control.h>
#include <coapt/valve_run.h>

#include <vector>

namespace coapt
{
  /**
   * The closure of a valve without fluid, from rest to the end time. The solid
   * alone needs no more than one evaluation a step, so it takes central
   * differences in the place of the Runge-Kutta method of the coupled system.
   */
  class StructureSimulation : public ValveRun
  {
  public:
    /** Builds the valve; throws InputError. Writes nothing. Collective. */
    StructureSimulation(const SimulationParameters &parameters,
                        Log &log,
                        MPI_Comm communicator);

    Summary
    run(const OutputFolder &folder) override;

  private:
    void
    advance(const double until, Recorder &recorder);

    void
    prepare_step(Recorder &recorder);

    void
    update_step_limits();

    /** Throws if the state is not finite, after the last fields that are. */
    void
    check_finite(Recorder &recorder);

    /** Writes the last finite fields and throws. */
    [[noreturn]] void
    stop(Recorder &recorder, const std::string &reason);

    RunCost
    cost() const;

    SimulationParameters parameters;
    Log &log;
    MPI_Comm communicator;
    Timing timing;
    ValveStructure valve;
    StructureSystem system;
    StructureMonitor monitor;
    CentralDifferences integrator;
    StepControl step_control;
    LargestFrequency<3> solid_frequency;

    /** Numbers of the timed sections. */
    struct Sections
    {
      unsigned int limits, monitor, output;
    } sections;

    /** Positions of all nodes, then velocities; the same on every rank. */
    std::vector<double> state, last_finite_state;
    double last_finite_time = 0;
  };
} // namespace coapt

#endif
