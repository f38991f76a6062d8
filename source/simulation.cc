#include <deal.II/base/mpi.h>

#include <coapt/base/all_finite.h>
#include <coapt/base/exceptions.h>
#include <coapt/simulation.h>
#include <coapt/time/stability_limit.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  namespace
  {
    std::vector<Plane>
    planes(const RunParameters &run)
    {
      std::vector<Plane> result;
      for (const auto &[x, y, z, nx, ny, nz] : run.flow_planes)
        result.push_back(
          {dealii::Point<3>(x, y, z), dealii::Tensor<1, 3>({nx, ny, nz})});
      return result;
    }
  } // namespace



  Simulation::Simulation(const SimulationParameters &parameters,
                         Log &log,
                         MPI_Comm communicator)
    : parameters(parameters)
    , log(log)
    , communicator(communicator)
    , model(parameters.model, timing, communicator)
    , monitor(model, planes(parameters.run))
    , integrator(
        communicator,
        [this](const double t, const double *y, double *y_dot) {
          model.system->rhs(t, y, y_dot);
        },
        [this](const double t, double *y) { finish_step(t, y); })
    , step_control(parameters.step)
    , solid_frequency(*model.solid,
                      model.leaflet.mesh,
                      model.leaflet.pinned,
                      communicator)
    , sections({timing.section("Adaptation"),
                timing.section("Step limits"),
                timing.section("Flow and energy"),
                timing.section("Output"),
                timing.section("Integrator")})
    , state(model.state_at_rest())
  {
    model.check_resolution(log);
  }



  Summary
  Simulation::run(const OutputFolder &folder)
  {
    ValveRecorder recorder(parameters.run, folder, model, monitor, log);
    const auto record = [&]() {
      const auto scope = timing.scope(sections.output);
      recorder.record(integrator.time(),
                      state.data(),
                      cost(),
                      step_control.limiter());
    };

    CheckpointFolder checkpoints(folder.file(""),
                                 parameters.run.checkpoint_interval,
                                 folder.continues(),
                                 communicator);
    if (folder.continues())
      load(folder.checkpoint(), recorder);
    else
      {
        begin();
        record();
        // so that a run can always go on that is started again and again
        if (parameters.run.resume == Resume::if_possible &&
            parameters.run.checkpoint_interval > 0)
          save(checkpoints, recorder);
      }
    while (!is_over())
      {
        advance(std::min(parameters.run.end_time,
                         integrator.time() + parameters.run.output_interval),
                recorder);
        check_finite(recorder);
        record();
        if (checkpoints.is_due() || (checkpoints.is_due_at_end() && is_over()))
          save(checkpoints, recorder);
      }
    recorder.finish(integrator.time(), state.data());
    const Summary summary = recorder.write_summary(cost());
    log.line(model.division());
    log.line(timing.summary(communicator));
    return summary;
  }



  void
  Simulation::begin()
  {
    update_step_limits();
    model.system->begin_step(step_control.step(
      std::min(parameters.run.end_time, parameters.run.output_interval)));
    integrator.start(0., state);
  }



  bool
  Simulation::is_over() const
  {
    return parameters.run.is_over(integrator.time(), integrator.n_steps());
  }



  void
  Simulation::advance(const double until, Recorder &recorder)
  {
    while (integrator.time() < until * (1 - 1e-12) && !is_over())
      {
        prepare_step(recorder);
        const double dt  = step_control.step(until - integrator.time());
        const auto scope = timing.scope(sections.integrator);
        model.system->begin_step(dt);
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
  Simulation::finish_step(const double t, double *y)
  {
    try
      {
        model.system->finish_step(t, y);
      }
    catch (const NumericalError &)
      {
        // The integrator goes back to the state before.
        failed_state.assign(y, y + state.size());
        throw;
      }
  }



  void
  Simulation::prepare_step(Recorder &recorder)
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
        if (model.band_is_used_up(state) || flow_adaptation_is_due())
          adapt();
      }
    if (integrator.n_steps() % parameters.step.sampling == 0)
      {
        const auto scope = timing.scope(sections.monitor);
        monitor.accumulate(integrator.time(), state.data());
      }
    if (model.system->points_have_left())
      {
        model.system->redistribute_points(state);
        integrator.start(integrator.time(), state);
      }
  }



  bool
  Simulation::flow_adaptation_is_due() const
  {
    const MeshParameters &mesh = parameters.model.mesh;
    return mesh.follows_flow() &&
      integrator.time() > last_adaptation + mesh.flow_interval;
  }



  void
  Simulation::adapt()
  {
    const auto scope    = timing.scope(sections.adaptation);
    const double before = monitor.stored_energy(state.data());
    last_adaptation     = integrator.time();
    if (model.adapt(state, log))
      {
        monitor.note_adaptation(before, state.data());
        integrator.start(integrator.time(), state);
        last_finite_state = state;
        last_finite_time  = integrator.time();
      }
  }



  void
  Simulation::update_step_limits()
  {
    const auto scope            = timing.scope(sections.limits);
    const std::vector<double> X = model.system->solid_positions(state.data());
    const auto solid            = solid_frequency.update(X.data());
    step_control.update(
      {{"fluid", model.fluid->max_stable_step()},
       {"solid", kinnmark_gray_limit(solid.xi) / solid.omega},
       {"chordae",
        kinnmark_gray_limit(model.chordae->damping_ratio()) /
          model.chordae->max_frequency()},
       {"coupling",
        model.largest_relaxation_time(integrator.time()) /
          model.parameters.coupling.relaxation_steps / parameters.step.safety},
       {"contact", model.contact_step_limit()}});
  }



  void
  Simulation::check_finite(Recorder &recorder)
  {
    if (all_finite(state, communicator))
      {
        last_finite_state = state;
        last_finite_time  = integrator.time();
        return;
      }

    stop(recorder, "the state is not finite");
  }



  void
  Simulation::stop(Recorder &recorder, const std::string &reason)
  {
    // The copy may be of before a redistribution of points, which changes the
    // length of the multiplier alone; that is in no field.
    if (!last_finite_state.empty())
      recorder.write_fields(last_finite_time, last_finite_state.data());
    throw NumericalError(
      reason + " at t = " + std::to_string(integrator.time()) + " s (" +
      model.name_not_finite(failed_state.empty() ? state : failed_state) +
      "); the step was limited by the " + step_control.limiter());
  }



  RunCost
  Simulation::cost() const
  {
    RunCost cost;
    cost.fluid_cells     = model.n_active_cells();
    cost.solid_tets      = model.leaflet.mesh.n_elements();
    cost.coupling_points = model.points->n_active();
    cost.steps           = integrator.n_steps();
    cost.evaluations     = integrator.n_evaluations();
    cost.wall_seconds    = earlier_wall + timing.wall_time();
    cost.ranks       = dealii::Utilities::MPI::n_mpi_processes(communicator);
    cost.step_length = step_control.step(1.);
    return cost;
  }
} // namespace coapt
