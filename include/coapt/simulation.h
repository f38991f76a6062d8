#ifndef coapt_simulation_h
#define coapt_simulation_h

#include <coapt/base/timing.h>
#include <coapt/coupled/valve_model.h>
#include <coapt/io/checkpoint_folder.h>
#include <coapt/io/recorder.h>
#include <coapt/metrics/valve_monitor.h>
#include <coapt/solid/largest_frequency.h>
#include <coapt/time/explicit_integrator.h>
#include <coapt/time/step_control.h>
#include <coapt/valve_run.h>

#include <string>
#include <vector>

namespace coapt
{
  /** The closure of a valve in blood, from rest or from a checkpoint to the end
   * time. */
  class Simulation : public ValveRun
  {
  public:
    /** Builds the valve and warns of what may go wrong; throws InputError.
     * Writes nothing. Collective. */
    Simulation(const SimulationParameters &parameters,
               Log &log,
               MPI_Comm communicator);

    void
    check_checkpoint(const OutputFolder &folder) override;

    /** Runs to the end time and writes into @p folder; throws
     * NumericalError. Returns the figures of the run, on the first rank.
     * Collective. */
    Summary
    run(const OutputFolder &folder) override;

  private:
    bool
    is_over() const;

    void
    advance(const double until, Recorder &recorder);

    void
    finish_step(const double t, double *y);

    void
    prepare_step(Recorder &recorder);

    bool
    flow_adaptation_is_due() const;

    void
    adapt();

    void
    update_step_limits();

    void
    check_finite(Recorder &recorder);

    /** Writes the last finite fields and throws. */
    [[noreturn]] void
    stop(Recorder &recorder, const std::string &reason);

    RunCost
    cost() const;

    /** Starts from rest. */
    void
    begin();

    /** Writes a checkpoint. */
    void
    save(CheckpointFolder &checkpoints, ValveRecorder &recorder);

    /** Goes on from the checkpoint in @p folder. */
    void
    load(const std::string &folder, ValveRecorder &recorder);

    /** Saves or restores what is the same on all ranks. */
    template <class Archive>
    void
    serialize(Archive &archive, ValveRecorder &recorder);

    /** Numbers of the timed sections. */
    struct Sections
    {
      unsigned int adaptation, limits, monitor, output, integrator;
    };

    SimulationParameters parameters;
    Log &log;
    MPI_Comm communicator;
    Timing timing;
    ValveModel model;
    ValveMonitor monitor;
    ExplicitIntegrator integrator;
    StepControl step_control;
    LargestFrequency<3> solid_frequency;
    Sections sections;
    std::vector<double> state;
    std::vector<double> last_finite_state, failed_state;
    double last_finite_time = 0;
    double last_adaptation  = 0;
    double earlier_wall     = 0; // s, of the runs that this one continues
  };
} // namespace coapt

#endif
