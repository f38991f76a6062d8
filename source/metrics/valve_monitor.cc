#include <deal.II/base/mpi.h>

#include <deal.II/numerics/rtree.h>

#include <coapt/geometry/vertex_normals.h>
#include <coapt/metrics/coaptation_traction.h>
#include <coapt/metrics/loads.h>
#include <coapt/metrics/surface_flux.h>
#include <coapt/metrics/valve_monitor.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    CoaptationSettings
    settings_for(const ModelParameters &parameters)
    {
      CoaptationSettings settings;
      const double h         = parameters.mesh.finest_cell();
      settings.filter_radius = 2 * h;
      settings.belt_radius   = std::max(settings.belt_radius, 2 * h);
      // Fluid trapped between the leaflets holds them up to 1.2 cells apart.
      settings.gap_limit = std::max(parameters.contact.clearance, 1.5 * h);
      return settings;
    }
  } // namespace



  ValveMonitor::ValveMonitor(ValveModel &model,
                             const std::vector<Plane> &planes)
    : LeafletMonitor(model,
                     settings_for(model.parameters),
                     std::max(2e-3,
                              model.parameters.contact.clearance +
                                2 * model.parameters.mesh.finest_cell()))
    , model(model)
    , planes(planes)
    , audit(*model.system, *model.fluid, *model.solid, *model.points)
    , column_load(model.leaflet.columns.size())
  {
  }



  void
  ValveMonitor::accumulate(const double t, const double *y)
  {
    const std::vector<double> X = model.system->solid_positions(y);
    const std::vector<double> u = model.system->local_velocity(y);
    const double outflow = model.fluid->flux(ValveModel::atrial_end, u.data());
    if (started)
      outflow_volume += 0.5 * (t - last_time) * (last_outflow + outflow);
    accumulate_motion(t, X, model.system->solid_velocities(y));
    largest_outflow = std::max(largest_outflow, outflow);
    started         = true;
    last_time       = t;
    last_outflow    = outflow;
    audit.sample(t, y);
  }



  double
  ValveMonitor::stored_energy(const double *y) const
  {
    return audit.energies(y).total();
  }



  void
  ValveMonitor::note_adaptation(const double energy_before, const double *y)
  {
    audit.add_adaptation(stored_energy(y) - energy_before);
  }



  std::vector<double>
  ValveMonitor::ventricular_pressure(const double *y,
                                     const std::vector<double> &X) const
  {
    // Sampled two cells behind the ventricular face, where neither the
    // coupling nor the fictitious fluid inside the leaflet is felt.
    const auto &leaflet    = model.leaflet;
    const double *pressure = y + model.system->layout().pressure();
    const double distance  = 2 * model.parameters.mesh.finest_cell();
    const unsigned int n   = leaflet.columns.size();
    std::vector<double> sums(2 * n, 0.);
    for (unsigned int c = 0; c < n; ++c)
      {
        Point<3> inner, outer;
        for (unsigned int d = 0; d < 3; ++d)
          {
            inner[d] = X[3 * leaflet.columns[c].front() + d];
            outer[d] = X[3 * leaflet.columns[c].back() + d];
          }
        const Point<3> x =
          outer + distance * (outer - inner) / inner.distance(outer);
        const int cell = model.fluid->locate(x);
        if (cell >= 0 && cell < int(model.fluid->n_owned_cells()) &&
            model.fluid->is_active_cell(cell))
          {
            sums[c]     = pressure[cell];
            sums[n + c] = 1;
          }
      }
    dealii::Utilities::MPI::sum(sums, model.communicator, sums);

    double mean        = 0;
    unsigned int count = 0;
    for (unsigned int c = 0; c < n; ++c)
      if (sums[n + c] > 0)
        {
          mean += sums[c];
          ++count;
        }
    mean = count > 0 ? mean / count : 0.;
    for (unsigned int c = 0; c < n; ++c)
      if (sums[n + c] == 0)
        sums[c] = mean;
    sums.resize(n);
    return sums;
  }



  std::vector<double>
  ValveMonitor::mean_load()
  {
    window                   = model.contact->accumulated_time();
    std::vector<double> load = model.system->take_coupling_impulse();
    for (double &entry : load)
      entry = window > 0 ? entry / window : 0.;
    return load;
  }



  void
  ValveMonitor::measure_tractions(const double *y,
                                  const std::vector<double> &X,
                                  const std::vector<double> &load)
  {
    const auto &state             = model.contact->state();
    const std::vector<double> p_v = ventricular_pressure(y, X);
    const std::vector<Tensor<1, 3>> normals =
      vertex_normals(surface_points, model.surface);

    for (unsigned int c = 0; c < model.leaflet.columns.size(); ++c)
      {
        column_contact_pressure[c] = 0;
        column_traction[c]         = 0;
        column_load[c]             = Tensor<1, 3>();
        if (!(window > 0))
          continue;
        Tensor<1, 3> force;
        for (const unsigned int node : model.leaflet.columns[c])
          for (unsigned int d = 0; d < 3; ++d)
            force[d] += load[3 * node + d];
        column_load[c] = force / state.reference_area[c];
        if (state.normals[c].norm_square() == 0)
          continue;
        column_contact_pressure[c] = state.pressure_impulse[c] / window;
        column_traction[c] = coaptation_traction(column_contact_pressure[c],
                                                 p_v[c],
                                                 force,
                                                 normals[c],
                                                 state.normals[c],
                                                 state.current_area[c]);
      }
    model.contact->clear_accumulators();
  }



  void
  ValveMonitor::measure_noise(const double *y, ValveSample &sample) const
  {
    const auto &at                     = model.system->layout();
    const std::vector<double> u        = model.system->local_velocity(y);
    const std::vector<double> V        = model.system->solid_velocities(y);
    const dealii::RTree<Point<3>> tree = dealii::pack_rtree(surface_points);
    const MeshParameters &mesh         = model.parameters.mesh;
    const double distance =
      model.parameters.valve.thickness + 2 * mesh.cell_size(mesh.level_apart());
    const auto far = [&](const Point<3> &x) {
      std::vector<Point<3>> nearest;
      tree.query(boost::geometry::index::nearest(x, 1),
                 std::back_inserter(nearest));
      return x.distance(nearest[0]) > distance;
    };
    sample.hourglass_rms = model.fluid->hourglass_rms(u.data(), far);
    sample.checkerboard_rms =
      model.fluid->checkerboard_rms(y + at.pressure(), far);
    sample.largest_velocity =
      model.fluid->largest_velocity(y + at.velocity()).speed;
    sample.slip_rms = model.points
                        ->energy_and_power(model.system->relaxation(),
                                           u.data(),
                                           V.data(),
                                           y + at.multiplier())
                        .slip_rms;
  }



  void
  ValveMonitor::measure_flow(const std::vector<double> &u,
                             const std::vector<Tensor<1, 3>> &velocities,
                             ValveSample &sample) const
  {
    sample.inflow  = -model.fluid->flux(ValveModel::ventricular_end, u.data());
    sample.outflow = model.fluid->flux(ValveModel::atrial_end, u.data());
    for (const Plane &plane : planes)
      sample.plane_flow.push_back(
        flux_through_plane(*model.fluid, u, plane, model.communicator));

    // Where leaflets lie side by side, they part ventricle and film, not
    // ventricle and atrium.
    const std::vector<bool> apposed = coaptation().apposed(gaps());
    std::vector<std::array<unsigned int, 3>> parting;
    for (const auto &[a, b, c] : model.surface)
      if (!apposed[a] && !apposed[b] && !apposed[c])
        parting.push_back({{a, b, c}});
    sample.tissue_flow = flux_through_surface(
      *model.fluid, u, surface_points, velocities, parting, model.communicator);
    sample.reynolds = reynolds_number(sample.outflow,
                                      M_PI * model.lumen.semi_axis_x() *
                                        model.lumen.semi_axis_y(),
                                      model.fluid->parameters().density,
                                      model.fluid->parameters().viscosity);
  }



  ValveSample
  ValveMonitor::sample(const double t, const double *y)
  {
    const std::vector<double> X = model.system->solid_positions(y);
    const std::vector<double> V = model.system->solid_velocities(y);
    if (t > last_time || !started)
      accumulate(t, y);

    ValveSample sample;
    sample.time           = t;
    sample.pressure       = model.ventricular_pressure(t);
    sample.peak_outflow   = largest_outflow;
    sample.outflow_volume = outflow_volume;
    sample.drained_volume = model.film ? model.film->drained_volume() : 0.;
    measure_noise(y, sample);
    measure_flow(model.system->local_velocity(y), mid_velocities(V), sample);
    const std::vector<double> load = mean_load();
    measure_solid(t, X, V, load, sample);
    sample.point_spacing = model.point_spacing(X);

    measure_tractions(y, X, load);
    measure_coaptation(sample);

    sample.works         = audit.work();
    sample.energies      = audit.energies(y);
    sample.energy_error  = audit.relative_error(sample.energies);
    sample.closure_error = audit.closure_error(sample.energies);
    return sample;
  }
} // namespace coapt
