#include <deal.II/base/mpi.h>

#include <coapt/base/exceptions.h>
#include <coapt/base/parameter_file.h>
#include <coapt/simulation.h>
#include <coapt/time/stability_limit.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace coapt
{
  void
  SimulationParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    RunParameters::declare_parameters(prm);
    StepParameters::declare_parameters(prm);
    ModelParameters::declare_parameters(prm);
  }



  void
  SimulationParameters::read(const std::string &file,
                             dealii::ParameterHandler &prm)
  {
    read_parameter_file(prm, file);
    try
      {
        run.parse_parameters(prm);
        step.parse_parameters(prm);
        model.parse_parameters(prm);
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
    model.folder = std::filesystem::path(file).parent_path().string();
  }



  Simulation::Simulation(const SimulationParameters &parameters,
                         Log &log,
                         MPI_Comm communicator)
    : parameters(parameters)
    , log(log)
    , communicator(communicator)
    , model(parameters.model, timing, communicator)
    , monitor(model)
    , integrator(
        communicator,
        [this](const double t, const double *y, double *y_dot) {
          model.system->rhs(t, y, y_dot);
        },
        [this](const double t, double *y) { model.system->finish_step(t, y); })
    , step_control(parameters.step)
    , state(model.state_at_rest())
  {
  }



  void
  Simulation::run()
  {
    update_step_limits();
    model.system->begin_step(step_control.step(parameters.run.end_time));
    integrator.start(0., state);
    record();
    while (integrator.time() < parameters.run.end_time)
      {
        advance(std::min(parameters.run.end_time,
                         integrator.time() + parameters.run.output_interval));
        record();
      }
    log.line(timing.summary(communicator));
  }



  void
  Simulation::advance(const double until)
  {
    while (integrator.time() < until * (1 - 1e-12))
      {
        if (integrator.n_steps() % parameters.step.interval == 0)
          {
            update_step_limits();
            check_finite();
            if (model.band_is_used_up(state))
              adapt();
          }
        if (integrator.n_steps() % parameters.step.sampling == 0)
          {
            const auto scope = timing.scope(timing.section("Flow and energy"));
            monitor.accumulate(integrator.time(), state.data());
          }
        if (model.system->points_have_left())
          {
            model.system->redistribute_points(state);
            integrator.start(integrator.time(), state);
          }
        const double dt = step_control.step(until - integrator.time());
        model.system->begin_step(dt);
        const auto scope = timing.scope(timing.section("Integrator"));
        integrator.step(dt);
      }
  }



  void
  Simulation::adapt()
  {
    const auto scope    = timing.scope(timing.section("Adaptation"));
    const double before = monitor.stored_energy(state.data());
    if (model.follow_leaflet(state))
      {
        monitor.note_adaptation(before, state.data());
        integrator.start(integrator.time(), state);
      }
  }



  void
  Simulation::update_step_limits()
  {
    const auto scope            = timing.scope(timing.section("Step limits"));
    const std::vector<double> X = model.system->solid_positions(state.data());
    const auto solid            = model.solid->step_bound(X.data());
    const double h              = model.parameters.valve.thickness;
    const double rho            = model.parameters.solid.density;
    step_control.update(
      {{"fluid", model.fluid->max_stable_step()},
       {"solid", kinnmark_gray_limit(solid.xi) / solid.omega},
       {"chordae", kinnmark_gray_limit(0.) / model.chordae->max_frequency()},
       {"coupling",
        model.parameters.coupling.max_relaxation_time /
          model.parameters.coupling.relaxation_steps / parameters.step.safety},
       {"contact",
        std::sqrt(model.parameters.contact.stiffness_factor * rho * h /
                  model.parameters.contact.max_stiffness)}});
  }



  void
  Simulation::check_finite()
  {
    bool finite = true;
    for (const double value : state)
      finite = finite && std::isfinite(value);
    if (dealii::Utilities::MPI::min(finite ? 1 : 0, communicator) == 0)
      throw NumericalError(
        "the state is not finite at t = " + std::to_string(integrator.time()) +
        " s; the step was limited by the " + step_control.limiter());
  }



  void
  Simulation::record()
  {
    const auto scope    = timing.scope(timing.section("Output"));
    const ValveSample s = monitor.sample(integrator.time(), state.data());
    const unsigned int cells =
      dealii::Utilities::MPI::sum(model.fluid->n_owned_cells(), communicator);
    char line[1000];
    std::snprintf(
      line,
      sizeof(line),
      "%6.2f ms dt %.2f us (%s) p %.0f Q %.1f/%.1f swept %.1f mL/s V %.2f/%.2f mL | F %.2f (c %.2f) N A %.0f mm2 pmax %.1f kPa gap %.2f width %.2f mm at (%.1f %.1f %.1f) bulge %.2f mL | ch %.2f %.2f %.2f %.2f | umax %.2f slip %.4f hg %.4f cb %.1f | stress %.1f strain %.3f | Eerr %.4f W %.4f E %.4f | cells %u steps %lu wall %.0f belt %d/%d gap %u ant %.1f post %.1f mm",
      1e3 * s.time,
      1e6 * step_control.step(1.),
      step_control.limiter().c_str(),
      s.pressure,
      1e6 * s.inflow,
      1e6 * s.outflow,
      1e6 * s.swept_flow,
      1e6 * s.outflow_volume,
      1e6 * s.swept_volume,
      s.coaptation_force,
      s.contact_force,
      1e6 * s.coaptation_area,
      1e-3 * s.coaptation_pressure,
      1e3 * s.min_gap,
      1e3 * s.path_width,
      1e3 * s.path.position[0],
      1e3 * s.path.position[1],
      1e3 * s.path.position[2],
      1e6 * s.bulging_volume,
      s.chordae_tension[0],
      s.chordae_tension[1],
      s.chordae_tension[2],
      s.chordae_tension[3],
      s.largest_velocity,
      s.slip_rms,
      s.hourglass_rms,
      s.checkerboard_rms,
      1e-3 * s.mean_stress,
      s.mean_strain,
      s.energy_error,
      s.work_of_ends,
      s.stored_energy,
      cells,
      integrator.n_steps(),
      timing.wall_time(),
      int(s.coaptation.anterior.continuous),
      int(s.coaptation.posterior.continuous),
      s.coaptation.longest_gap,
      1e3 * s.coaptation.anterior.mean_height,
      1e3 * s.coaptation.posterior.mean_height);
    log.line(line);
  }
} // namespace coapt
