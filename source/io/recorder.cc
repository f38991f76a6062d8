#include <deal.II/base/mpi.h>

#include <coapt/base/first_rank.h>
#include <coapt/io/recorder.h>
#include <coapt/io/valve_warnings.h>

#include <algorithm>

namespace coapt
{
  Recorder::Recorder(const RunParameters &parameters,
                     const OutputFolder &folder,
                     const ValveStructure &valve,
                     const LeafletMonitor &monitor,
                     const ReportSettings &settings,
                     Log &log)
    : folder(folder)
    , log(log)
    , fields(folder.file("fields"), valve.communicator)
    , valve(valve)
    , monitor(monitor)
    , in_blood(settings.in_blood)
    , console(parameters.end_time)
    , statistics(folder.file("statistics.csv"),
                 valve.communicator,
                 folder.continues())
    , chordae_table(folder.file("chordae.csv"),
                    valve.communicator,
                    folder.continues())
    , report(settings)
    , fields_interval(parameters.fields_interval)
  {
  }



  void
  Recorder::record(const double t,
                   const double *y,
                   const RunCost &cost,
                   const std::string &limiter)
  {
    const ValveSample now = sample(t, y);
    report.add(now, monitor);
    statistics.write_row(statistics_row(now, cost, in_blood));
    chordae_table.write_row(chordae_row(now, valve.chordae->chordae()));
    log.line(console.line({t,
                           cost.step_length,
                           limiter,
                           in_blood ? now.outflow : now.swept_flow,
                           now.contact_force,
                           in_blood ? cost.fluid_cells : cost.solid_tets,
                           cost.steps}));
    warn(now);
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
  Recorder::write_leaflet(const double t,
                          const std::vector<double> &X,
                          const std::vector<double> &V)
  {
    LeafletFields leaflet;
    leaflet.X                   = X;
    leaflet.V                   = V;
    leaflet.cells               = valve.solid->cell_results(X.data());
    leaflet.contact_pressure    = monitor.contact_pressure();
    leaflet.coaptation_pressure = monitor.total_traction();
    fields.write_leaflet(t, valve.leaflet, leaflet);
    fields.write_chordae(t, *valve.chordae, X, V);
  }



  void
  Recorder::warn(const ValveSample &sample) const
  {
    const ModelParameters &parameters = valve.parameters;
    for (const ValveWarning &warning :
         valve_warnings(sample,
                        parameters.valve.thickness,
                        in_blood ? parameters.mesh.finest_cell() : 0.))
      log.warn(warning.key, warning.text);
  }



  Summary
  Recorder::write_summary(const RunCost &cost) const
  {
    if (dealii::Utilities::MPI::this_mpi_process(valve.communicator) != 0)
      return Summary();
    const std::string doubt =
      report.doubt_about_orifice(valve.parameters.fluid.density);
    if (!doubt.empty())
      log.warn("orifice", doubt);
    std::vector<std::string> warnings;
    for (const Log::Warning &warning : log.warnings())
      warnings.push_back(warning.text + " (" + std::to_string(warning.count) +
                         " times)");
    const Summary summary = report.summary(valve, monitor, cost, warnings);
    summary.write(folder.file("summary.json"));
    log.line(report.energy_balance());
    write_closure_maps(valve,
                       monitor,
                       report.mean_tractions(),
                       [this](const std::string &name) {
                         return folder.file(name);
                       });
    return summary;
  }



  ValveRecorder::ValveRecorder(const RunParameters &parameters,
                               const OutputFolder &folder,
                               const ValveModel &model,
                               ValveMonitor &monitor,
                               Log &log)
    : Recorder(parameters,
               folder,
               model,
               monitor,
               {parameters.end_time,
                0.5 * model.parameters.mesh.finest_cell(),
                true},
               log)
    , model(model)
    , monitor(monitor)
  {
    if (parameters.surface_load && is_first_rank(model.communicator))
      surface_load =
        std::make_unique<SurfaceLoadFile>(folder.file("surface_load.csv"),
                                          model.mid_surface(
                                            model.reference_positions()),
                                          folder.continues());
  }



  ValveSample
  ValveRecorder::sample(const double t, const double *y)
  {
    const ValveSample result = monitor.sample(t, y);
    if (surface_load && monitor.load_window() > 0)
      surface_load->write(t - 0.5 * monitor.load_window(),
                          monitor.surface_load());
    return result;
  }



  void
  ValveRecorder::write_fields(const double t, const double *y)
  {
    const auto &at              = model.system->layout();
    const std::vector<double> u = model.system->local_velocity(y);
    fields.write_fluid(t,
                       *model.grid,
                       *model.fluid,
                       u.data(),
                       y + at.pressure(),
                       model.points->solid_volume(*model.fluid));
    write_leaflet(t,
                  model.system->solid_positions(y),
                  model.system->solid_velocities(y));
  }



  StructureRecorder::StructureRecorder(const RunParameters &parameters,
                                       const OutputFolder &folder,
                                       const ValveStructure &valve,
                                       StructureMonitor &monitor,
                                       Log &log)
    : Recorder(parameters,
               folder,
               valve,
               monitor,
               {parameters.end_time,
                // The way is looked for on a lattice of 0.25 mm.
                std::max(0.5 * valve.parameters.contact.clearance, 0.25e-3),
                false},
               log)
    , n_entries(3 * valve.solid->n_nodes())
    , monitor(monitor)
  {
  }



  std::vector<double>
  StructureRecorder::half(const double *y, const unsigned int i) const
  {
    return std::vector<double>(y + i * n_entries, y + (i + 1) * n_entries);
  }



  ValveSample
  StructureRecorder::sample(const double t, const double *y)
  {
    return monitor.sample(t, std::vector<double>(y, y + 2 * n_entries));
  }



  void
  StructureRecorder::write_fields(const double t, const double *y)
  {
    write_leaflet(t, half(y, 0), half(y, 1));
  }
} // namespace coapt
