#include <deal.II/base/mpi.h>

#include <coapt/base/all_finite.h>
#include <coapt/base/exceptions.h>
#include <coapt/structure_simulation.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  namespace
  {
    /** Longest stable step of central differences (Belytschko, Liu, Moran,
     * section 6.6). */
    double
    central_difference_limit(const double omega, const double xi)
    {
      return 2 / omega * (std::sqrt(1 + xi * xi) - xi);
    }

    /** The model with leaflets as heavy as with the blood that moves with
     * them. */
    ModelParameters
    with_added_mass(const SimulationParameters &parameters)
    {
      ModelParameters model = parameters.model;
      model.solid.density *= 1 + parameters.structure.added_mass;
      return model;
    }
  } // namespace



  StructureSimulation::StructureSimulation(
    const SimulationParameters &parameters,
    Log &log,
    MPI_Comm communicator)
    : parameters(parameters)
    , log(log)
    , communicator(communicator)
    , valve(with_added_mass(parameters), communicator)
    , system(valve, parameters.structure, timing)
    , monitor(valve, system)
    , integrator([this](const double t,
                        const double *X,
                        const double *V,
                        double *A) { system.acceleration(t, X, V, A); },
                 system.mass_damping,
                 [this](const double t, double *X, double *V, const double dt) {
                   system.move_held_nodes(t, X, V, dt);
                   system.finish_step(X, V, dt);
                 })
    , step_control(parameters.step)
    , solid_frequency(*valve.solid,
                      valve.leaflet.mesh,
                      valve.leaflet.pinned,
                      communicator)
    , sections({timing.section("Step limits"),
                timing.section("Energy"),
                timing.section("Output")})
    , state(valve.reference_positions())
  {
    state.resize(2 * state.size(), 0.);
  }



  Summary
  StructureSimulation::run(const OutputFolder &folder)
  {
    StructureRecorder recorder(parameters.run, folder, valve, monitor, log);
    const auto record = [&]() {
      const auto scope = timing.scope(sections.output);
      recorder.record(integrator.time(),
                      state.data(),
                      cost(),
                      step_control.limiter());
    };

    update_step_limits();
    integrator.start(0., state);
    record();
    while (!parameters.run.is_over(integrator.time(), integrator.n_steps()))
      {
        advance(std::min(parameters.run.end_time,
                         integrator.time() + parameters.run.output_interval),
                recorder);
        check_finite(recorder);
        record();
      }
    recorder.finish(integrator.time(), state.data());
    const Summary summary = recorder.write_summary(cost());
    log.line(timing.summary(communicator));
    return summary;
  }



  void
  StructureSimulation::advance(const double until, Recorder &recorder)
  {
    while (integrator.time() < until * (1 - 1e-12) &&
           !parameters.run.is_over(integrator.time(), integrator.n_steps()))
      {
        prepare_step(recorder);
        const double dt = step_control.step(until - integrator.time());
        try
          {
            integrator.step(dt);
          }
        catch (const NumericalError &error)
          {
            // Positions, where contact finds out, are the same on all ranks.
            stop(recorder, error.what());
          }
      }
  }



  void
  StructureSimulation::prepare_step(Recorder &recorder)
  {
    if (integrator.n_steps() % parameters.step.interval == 0)
      {
        check_finite(recorder);
        try
          {
            update_step_limits();
          }
        catch (const NumericalError &error)
          {
            // Values that are still finite, but not their powers.
            stop(recorder, std::string(error.what()) + ", which is not finite");
          }
      }
    if (integrator.n_steps() % parameters.step.sampling == 0)
      {
        const auto scope = timing.scope(sections.monitor);
        monitor.accumulate(integrator.time(), state);
      }
  }



  void
  StructureSimulation::update_step_limits()
  {
    const auto scope = timing.scope(sections.limits);
    const auto solid = solid_frequency.update(state.data());
    // Where chordae hold the tissue, both are stiff.
    const double chordae = valve.chordae->max_frequency();
    step_control.update(
      {{"solid",
        central_difference_limit(std::hypot(solid.omega, chordae), solid.xi)},
       {"chordae",
        central_difference_limit(chordae, valve.chordae->damping_ratio())},
       {"contact", valve.contact_step_limit()}});
  }



  void
  StructureSimulation::check_finite(Recorder &recorder)
  {
    if (all_finite(state, communicator))
      {
        last_finite_state = state;
        last_finite_time  = integrator.time();
        return;
      }
    stop(recorder, "the leaflets' positions are not finite");
  }



  void
  StructureSimulation::stop(Recorder &recorder, const std::string &reason)
  {
    if (!last_finite_state.empty())
      recorder.write_fields(last_finite_time, last_finite_state.data());
    throw NumericalError(
      reason + " at t = " + std::to_string(integrator.time()) +
      " s; the step was limited by the " + step_control.limiter());
  }



  RunCost
  StructureSimulation::cost() const
  {
    RunCost cost;
    cost.solid_tets   = valve.leaflet.mesh.n_elements();
    cost.steps        = integrator.n_steps();
    cost.evaluations  = integrator.n_steps();
    cost.wall_seconds = timing.wall_time();
    cost.ranks        = dealii::Utilities::MPI::n_mpi_processes(communicator);
    cost.step_length  = step_control.step(1.);
    return cost;
  }
} // namespace coapt
