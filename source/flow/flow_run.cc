#include <coapt/base/all_finite.h>
#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/flow/flow_run.h>
#include <coapt/flow/number_lists.h>
#include <coapt/flow/signal.h>
#include <coapt/io/console.h>
#include <coapt/io/energy_table.h>
#include <coapt/solid/stability.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    bool
    is_energy(const std::string &name)
    {
      const std::string unit = "_J";
      return name.size() > unit.size() &&
        name.compare(name.size() - unit.size(), unit.size(), unit) == 0;
    }

    /** Whether no figures are made of what has this name. */
    bool
    is_in_statistics_only(const std::string &name)
    {
      return name == "largest_velocity_m_per_s" || is_energy(name);
    }

    StepParameters
    step_parameters(const FlowParameters &parameters)
    {
      StepParameters result;
      result.safety   = parameters.step_safety;
      result.max_step = std::numeric_limits<double>::max();
      return result;
    }
  } // namespace



  template <int dim>
  FlowRun<dim>::FlowRun(const FlowParameters &parameters,
                        const unsigned int level,
                        const std::string &label,
                        const std::vector<ReferenceValue<dim>> &reference,
                        Log &log,
                        MPI_Comm communicator)
    : parameters(parameters)
    , label(label)
    , reference(reference)
    , log(log)
    , model(parameters, level, communicator)
    , bodies(parameters.immersed
               ? std::make_unique<ImmersedBodies<dim>>(parameters, model)
               : nullptr)
    , audit(model)
    , obstacle_force(model)
    , integrator(
        communicator,
        [this](const double t, const double *y, double *y_dot) {
          if (bodies)
            bodies->rhs(t, y, y_dot);
          else
            model.rhs(t, y, y_dot);
        },
        [this](const double t, double *y) {
          if (bodies)
            bodies->finish_step(t, y);
        })
    , step_control(step_parameters(parameters))
    , state(bodies ? bodies->initial_state() : model.initial_state())
    , start(std::chrono::steady_clock::now())
  {
    if (parameters.immersed)
      warn_if_unstable(parameters.immersed->solid, log);
    for (const auto &coordinates : parameters.pressure_points)
      pressure_points.push_back(to_point<dim>(coordinates));
    if (!all_finite(state, model.communicator))
      throw InputError("Flow/Initial velocity or Initial pressure is not "
                       "finite everywhere");
    update_step_limits();
    // points outside the box are found out here
    sample();
    deviation();
  }



  template <int dim>
  FlowResult
  FlowRun<dim>::run(const OutputFolder &folder)
  {
    Files files{{folder.file("statistics.csv"),
                 model.communicator,
                 folder.continues()},
                {model, folder.file("fields")}};
    CheckpointFolder checkpoints(folder.file(""),
                                 parameters.run.checkpoint_interval,
                                 folder.continues(),
                                 model.communicator);
    const RunParameters &to = parameters.run;
    n_cells                 = model.fluid().n_active_cells();
    if (folder.continues())
      load(folder.checkpoint(), files);
    else
      {
        if (bodies)
          bodies->begin_step(
            step_control.step(std::min(to.end_time, to.output_interval)));
        integrator.start(0., state);
        record(folder, files);
      }
    while (!is_over())
      {
        const double until =
          std::min(to.end_time, integrator.time() + to.output_interval);
        while (integrator.time() < until * (1 - 1e-12) && !is_over())
          advance(until - integrator.time());
        check_finite();
        record(folder, files);
        report_progress(model.fluid().largest_velocity(state.data()).speed);
        if (checkpoints.is_due())
          save(checkpoints, files);
      }
    write_profiles(folder);
    log_energy();
    return result();
  }



  template <int dim>
  bool
  FlowRun<dim>::is_over() const
  {
    return parameters.run.is_over(integrator.time(), integrator.n_steps());
  }



  template <int dim>
  void
  FlowRun<dim>::record(const OutputFolder &folder, Files &files)
  {
    const double t = integrator.time();
    times.push_back(t);
    rows.push_back(sample());
    if (bodies)
      add_bodies(rows.back());
    else
      add_energy(rows.back());
    Row row = rows.back();
    row.insert(row.begin(), {"time_s", t});
    files.statistics.write_row(row);
    if (parameters.largest_errors)
      errors.take_larger(flow_errors(model, t, state.data()));
    else if (is_over())
      errors = flow_errors(model, t, state.data());
    const double interval = parameters.run.fields_interval;
    if (interval > 0 && (t >= files.next_fields * (1 - 1e-9) || is_over()))
      {
        files.fields.write(t, state.data());
        if (bodies)
          bodies->write_fields(folder.file("fields"), t, state.data());
        files.next_fields += interval;
      }
  }



  template <int dim>
  void
  FlowRun<dim>::advance(const double time_left)
  {
    const unsigned int steps_between_limits = 20;
    const unsigned int steps_between_audits = 10;
    if (!bodies)
      {
        integrator.step(step_control.step(time_left));
        if (integrator.n_steps() % steps_between_audits == 0)
          audit.sample(integrator.time(), state.data());
        return;
      }
    if (integrator.n_steps() % steps_between_limits == 0)
      update_step_limits();
    const double dt = step_control.step(time_left);
    bodies->begin_step(dt);
    integrator.step(dt);
    if (bodies->follow(integrator.time(), state))
      integrator.start(integrator.time(), state);
  }



  template <int dim>
  void
  FlowRun<dim>::update_step_limits()
  {
    if (bodies)
      step_control.update(bodies->step_limits(state.data()));
    else
      step_control.update({{"fluid", model.fluid().max_stable_step()}});
  }



  template <int dim>
  void
  FlowRun<dim>::add_bodies(Row &row)
  {
    bodies->warn(state.data(), log);
    const Row own = bodies->sample(integrator.time(), state.data());
    row.insert(row.end(), own.begin(), own.end());
    if (!model.obstacle() || parameters.reference_speed > 0)
      return;
    const auto total =
      obstacle_force.force(integrator.time(), state.data()) + bodies->force();
    row.emplace_back("total_drag_N", total[0]);
    row.emplace_back("total_lift_N", total[1]);
  }



  template <int dim>
  void
  FlowRun<dim>::add_energy(Row &row)
  {
    const double *y = state.data();
    audit.sample(integrator.time(), y);
    const auto energies = audit.energies(y);
    const Row books     = EnergyAudit<dim>::entries(audit.work(), energies);
    row.insert(row.end(), books.begin(), books.end());
    row.emplace_back("closure_error_J", audit.closure_error(energies));
    row.emplace_back("energy_error_relative", audit.relative_error(energies));
  }



  template <int dim>
  void
  FlowRun<dim>::log_energy()
  {
    Row books;
    double error = 0;
    for (const auto &entry : rows.back())
      if (is_energy(entry.first))
        books.push_back(entry);
      else if (entry.first == "energy_error_relative")
        error = entry.second;
    log.line(label + ":\n" + energy_table(books, error));
  }



  template <int dim>
  typename FlowRun<dim>::Row
  FlowRun<dim>::sample() const
  {
    const FluidOperator<dim> &fluid = model.fluid();
    Row row                         = {
                              {"largest_velocity_m_per_s", fluid.largest_velocity(state.data()).speed}};
    if (model.obstacle())
      add_forces(row);
    if (parameters.tube_radius > 0)
      row.emplace_back("flow_m3_per_s",
                       fluid.flux(2 * dim - 1,
                                  model.local_velocity(state.data()).data()));
    if (parameters.records_dissipation)
      add_dissipation(row);
    if (!pressure_points.empty())
      {
        const auto samples = sample_flow(model, state.data(), pressure_points);
        for (unsigned int i = 0; i < pressure_points.size(); ++i)
          row.emplace_back("pressure_" + std::to_string(i + 1) + "_Pa",
                           samples.pressure[i]);
        if (pressure_points.size() > 1)
          row.emplace_back("pressure_difference_Pa",
                           samples.pressure[0] - samples.pressure[1]);
      }
    return row;
  }



  template <int dim>
  void
  FlowRun<dim>::add_forces(Row &row) const
  {
    const auto force = obstacle_force.force(integrator.time(), state.data());
    const double U   = parameters.reference_speed;
    if (U == 0)
      {
        row.emplace_back("drag_N", force[0]);
        row.emplace_back("lift_N", force[1]);
        return;
      }
    const double width =
      dim == 2 ? 1. : parameters.upper[2] - parameters.lower[2];
    const double scale = 0.5 * parameters.fluid.density * U * U * 2 *
      parameters.obstacle_radius * width;
    row.emplace_back("drag_coefficient", force[0] / scale);
    row.emplace_back("lift_coefficient", force[1] / scale);
  }



  template <int dim>
  void
  FlowRun<dim>::add_dissipation(Row &row) const
  {
    const FluidPowers powers =
      model.fluid().powers(integrator.time(),
                           model.local_velocity(state.data()).data(),
                           model.pressure(state.data()));
    row.emplace_back("dissipation_W",
                     powers.viscous + powers.artificial + powers.hourglass +
                       powers.checkerboard);
    row.emplace_back("viscosity_W", powers.viscous);
    row.emplace_back("artificial_viscosity_W", powers.artificial);
    row.emplace_back("hourglass_W", powers.hourglass);
    row.emplace_back("checkerboard_W", powers.checkerboard);
  }



  template <int dim>
  void
  FlowRun<dim>::check_finite() const
  {
    if (!all_finite(state, model.communicator))
      throw NumericalError(label + ": the state is not finite at t = " +
                           std::to_string(integrator.time()) + " s");
  }



  template <int dim>
  void
  FlowRun<dim>::report_progress(const double largest_velocity)
  {
    const auto now   = std::chrono::steady_clock::now();
    const double end = parameters.run.end_time, t = integrator.time();
    if (std::chrono::duration<double>(now - last_line).count() < 1)
      return;
    last_line = now;
    char text[256];
    std::snprintf(text,
                  sizeof(text),
                  "%s: %8.4g / %.4g s  dt %9.3g s  largest velocity %.4g m/s  "
                  "%u cells  %.0f steps/s  ETA %s",
                  label.c_str(),
                  t,
                  end,
                  step_control.step(1e9),
                  largest_velocity,
                  n_cells,
                  integrator.n_steps() / wall_time(),
                  Console::duration(wall_time() * (end - t) / t).c_str());
    log.line(text);
  }



  template <int dim>
  void
  FlowRun<dim>::write_profiles(const OutputFolder &folder) const
  {
    for (unsigned int k = 0; k < parameters.profiles.size(); ++k)
      {
        const FlowParameters::Line &line = parameters.profiles[k];
        std::vector<Point<dim>> points;
        for (unsigned int i = 0; i < line.n_points; ++i)
          {
            const double s = i / (line.n_points - 1.);
            points.emplace_back((1 - s) * to_point<dim>(line.begin) +
                                s * to_point<dim>(line.end));
          }
        const auto samples = sample_flow(model, state.data(), points);
        const std::string file =
          folder.file("profile_" + std::to_string(k + 1) + ".csv");
        Statistics table(file, model.communicator);
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            std::vector<Statistics::Entry> row;
            for (unsigned int d = 0; d < dim; ++d)
              row.emplace_back(std::string(1, "xyz"[d]) + "_m", points[i][d]);
            for (unsigned int d = 0; d < dim; ++d)
              row.emplace_back(std::string(1, "uvw"[d]) + "_m_per_s",
                               samples.velocity[i][d]);
            row.emplace_back("pressure_Pa", samples.pressure[i]);
            table.write_row(row);
          }
      }
  }



  template <int dim>
  double
  FlowRun<dim>::deviation() const
  {
    std::vector<Point<dim>> points;
    for (const ReferenceValue<dim> &value : reference)
      points.push_back(value.point);
    const auto samples = sample_flow(model, state.data(), points);
    double largest     = 0;
    for (unsigned int i = 0; i < reference.size(); ++i)
      largest = std::max(largest,
                         std::abs(samples.velocity[i][reference[i].component] -
                                  reference[i].value));
    return largest;
  }



  template <int dim>
  FlowResult
  FlowRun<dim>::result() const
  {
    FlowResult result;
    result.cells        = n_cells;
    result.cell_size    = model.cell_size();
    result.steps        = integrator.n_steps();
    result.wall_seconds = wall_time();
    result.errors       = errors;
    if (!reference.empty())
      result.figures.emplace_back("deviation_m_per_s", deviation());
    for (unsigned int k = 0; k < rows[0].size(); ++k)
      {
        if (is_in_statistics_only(rows[0][k].first))
          continue;
        std::vector<double> values;
        for (const Row &row : rows)
          values.push_back(row[k].second);
        const SignalFigures figures =
          signal_figures(times, values, parameters.figures_from);
        const std::string name = rows[0][k].first;
        result.figures.emplace_back(name + "_mean", figures.mean);
        result.figures.emplace_back(name + "_min", figures.least);
        result.figures.emplace_back(name + "_max", figures.largest);
        result.figures.emplace_back(name + "_frequency_Hz", figures.frequency);
      }
    return result;
  }



  template <int dim>
  double
  FlowRun<dim>::wall_time() const
  {
    return earlier_wall +
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();
  }

  template class FlowRun<2>;
  template class FlowRun<3>;
} // namespace coapt
