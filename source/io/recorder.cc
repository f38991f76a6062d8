#include <deal.II/base/mpi.h>

#include <coapt/base/exceptions.h>
#include <coapt/io/recorder.h>

#include <cstdio>

namespace coapt
{
  namespace
  {
    std::string
    text(const double value, const std::string &unit)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), "%.3g %s", value, unit.c_str());
      return buffer;
    }
  } // namespace



  Recorder::Recorder(const RunParameters &parameters,
                     const OutputFolder &folder,
                     const ValveModel &model,
                     ValveMonitor &monitor,
                     Log &log)
    : folder(folder)
    , model(model)
    , monitor(monitor)
    , log(log)
    , console(parameters.end_time)
    , statistics(folder.file("statistics.csv"), model.communicator)
    , chordae_table(folder.file("chordae.csv"), model.communicator)
    , fields(folder.file("fields"), model.communicator)
    , report(parameters.end_time, model.parameters.mesh.finest_cell())
    , fields_interval(parameters.fields_interval)
  {
  }



  void
  Recorder::record(const double t,
                   const double *y,
                   const RunCost &cost,
                   const std::string &limiter)
  {
    const ValveSample sample = monitor.sample(t, y);
    report.add(sample, monitor);
    statistics.write_row(statistics_row(sample, cost));
    chordae_table.write_row(chordae_row(sample, model.chordae->chordae()));
    log.line(console.line({t,
                           cost.step_length,
                           limiter,
                           sample.outflow,
                           sample.contact_force,
                           cost.fluid_cells,
                           cost.steps}));
    warn(sample);
    if (fields_interval > 0 && t >= next_fields * (1 - 1e-9))
      {
        write_fields(t, y);
        next_fields += fields_interval;
        last_fields = t;
      }
  }



  void
  Recorder::finish(const double t, const double *y)
  {
    if (fields_interval > 0 && t > last_fields)
      write_fields(t, y);
  }



  void
  Recorder::write_fields(const double t, const double *y)
  {
    const auto &at              = model.system->layout();
    const std::vector<double> u = model.system->local_velocity(y);
    fields.write_fluid(t,
                       *model.grid,
                       *model.fluid,
                       u.data(),
                       y + at.pressure(),
                       model.points->solid_volume(*model.fluid));

    LeafletFields leaflet;
    leaflet.X = model.system->solid_positions(y);
    leaflet.V = model.system->solid_velocities(y);
    std::vector<double> jacobian;
    model.solid->cell_results(leaflet.X.data(),
                              leaflet.von_mises,
                              leaflet.max_log_strain,
                              jacobian);
    leaflet.contact_pressure    = monitor.contact_pressure();
    leaflet.coaptation_pressure = monitor.total_traction();
    fields.write_leaflet(t, model.leaflet, leaflet);
    fields.write_chordae(t, *model.chordae, leaflet.X, leaflet.V);
  }



  void
  Recorder::warn(const ValveSample &sample) const
  {
    if (sample.min_gap < -0.5 * model.parameters.valve.thickness)
      log.warn("penetration",
               "the leaflet penetrates itself by " +
                 text(-1e3 * sample.min_gap, "mm") +
                 ", more than half its thickness");
    if (sample.point_spacing > 0.9)
      log.warn("stretched points",
               "coupling points are " + text(sample.point_spacing, "cells") +
                 " apart in the stretched leaflet (above 0.9 it leaks)");
    // Replicated positions: all ranks stop alike.
    if (sample.point_spacing >= 1.4)
      throw NumericalError("coupling points are " +
                           text(sample.point_spacing, "cells") +
                           " apart in the stretched leaflet (1.4 and more is "
                           "unstable)");
    if (sample.path_width < 0.5 * model.parameters.mesh.finest_cell())
      warn_of_unrest(sample);
  }



  void
  Recorder::warn_of_unrest(const ValveSample &sample) const
  {
    if (sample.checkerboard_rms > 10)
      log.warn("checkerboard",
               "alternating pressures away from the leaflet reach " +
                 text(sample.checkerboard_rms, "Pa") + " (rms; above 10 Pa)");
    if (sample.hourglass_rms > 1e-3)
      log.warn("hourglass",
               "alternating velocities away from the leaflet reach " +
                 text(1e3 * sample.hourglass_rms, "mm/s") +
                 " (rms; above 1 mm/s)");
    if (sample.largest_velocity > 1)
      log.warn("jet",
               "velocities reach " + text(sample.largest_velocity, "m/s") +
                 " in a valve that is shut: a gap at an edge or hinge?");
  }



  Summary
  Recorder::write_summary(const RunCost &cost) const
  {
    if (dealii::Utilities::MPI::this_mpi_process(model.communicator) != 0)
      return Summary();
    std::vector<std::string> warnings;
    for (const Log::Warning &warning : log.warnings())
      warnings.push_back(warning.text + " (" + std::to_string(warning.count) +
                         " times)");
    const Summary summary = report.summary(model, monitor, cost, warnings);
    summary.write(folder.file("summary.json"));
    write_closure_maps(model,
                       monitor,
                       report.mean_tractions(),
                       [this](const std::string &name) {
                         return folder.file(name);
                       });
    return summary;
  }
} // namespace coapt
