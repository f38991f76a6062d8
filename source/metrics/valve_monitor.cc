#include <deal.II/base/mpi.h>

#include <deal.II/numerics/rtree.h>

#include <coapt/metrics/bulging_volume.h>
#include <coapt/metrics/loads.h>
#include <coapt/metrics/surface_flux.h>
#include <coapt/metrics/swept_volume.h>
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
      settings.filter_radius = std::max(settings.filter_radius, 2 * h);
      // Fluid trapped between the leaflets holds them up to 1.2 cells apart.
      settings.gap_limit = std::max(parameters.contact.clearance, 1.5 * h);
      return settings;
    }
  } // namespace



  ValveMonitor::ValveMonitor(ValveModel &model)
    : model(model)
    , audit(*model.system, *model.fluid, *model.solid, *model.points)
    , peaks(model.chordae->chordae())
    , belt(model.leaflet, settings_for(model.parameters))
    , history(model.leaflet.columns.size(),
              model.parameters.contact.clearance,
              model.parameters.valve.thickness)
    , outer_faces(boundary_faces(model.leaflet.mesh.cells))
    , column_contact_pressure(model.leaflet.columns.size(), 0.)
    , column_traction(model.leaflet.columns.size(), 0.)
  {
    model.on_contact_work(
      [this](const double work) { audit.add_contact_work(work); });
  }



  void
  ValveMonitor::accumulate(const double t, const double *y)
  {
    const std::vector<double> X = model.system->solid_positions(y);
    const std::vector<double> u = model.system->local_velocity(y);
    const double outflow = model.fluid->flux(ValveModel::atrial_end, u.data());
    const std::vector<Point<3>> points = model.mid_surface(X);
    if (started)
      {
        outflow_volume += 0.5 * (t - last_time) * (last_outflow + outflow);
        total_swept += swept_volume(surface_points, points, model.surface);
      }
    peaks.update(t,
                 model.chordae->tensions(
                   t, X.data(), model.system->solid_velocities(y).data()));
    const auto &contact = model.contact->state();
    history.update(t,
                   {contact.gap, contact.normals, points, mid_velocities(y)});
    largest_outflow = std::max(largest_outflow, outflow);
    started         = true;
    last_time       = t;
    last_outflow    = outflow;
    surface_points  = points;
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



  void
  ValveMonitor::measure_tractions(const double *y, const std::vector<double> &X)
  {
    const std::vector<double> impulse = model.system->take_coupling_impulse();
    const double window               = model.contact->accumulated_time();
    const auto &state                 = model.contact->state();
    const std::vector<double> p_v     = ventricular_pressure(y, X);

    for (unsigned int c = 0; c < model.leaflet.columns.size(); ++c)
      {
        column_contact_pressure[c] = 0;
        column_traction[c]         = 0;
        if (!(window > 0) || state.normals[c].norm_square() == 0)
          continue;
        Tensor<1, 3> force;
        for (const unsigned int node : model.leaflet.columns[c])
          for (unsigned int d = 0; d < 3; ++d)
            force[d] += impulse[3 * node + d] / window;
        column_contact_pressure[c] = state.pressure_impulse[c] / window;
        column_traction[c]         = column_contact_pressure[c] + p_v[c] -
          force * state.normals[c] / state.current_area[c];
      }
    model.contact->clear_accumulators();
  }



  CoaptationResult
  ValveMonitor::coaptation(const std::vector<double> &contact_pressure,
                           const std::vector<double> &total_traction) const
  {
    const auto &state = model.contact->state();
    return belt.evaluate(state.gap,
                         contact_pressure,
                         total_traction,
                         state.current_area);
  }



  void
  ValveMonitor::measure_noise(const double *y, ValveSample &sample) const
  {
    const auto &at                     = model.system->layout();
    const std::vector<double> u        = model.system->local_velocity(y);
    const std::vector<double> V        = model.system->solid_velocities(y);
    const dealii::RTree<Point<3>> tree = dealii::pack_rtree(surface_points);
    const double distance              = model.parameters.valve.thickness +
      2 * model.parameters.mesh.finest_cell();
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
    sample.swept_flow = swept_rate(surface_points, velocities, model.surface);

    // Where leaflets lie side by side, they part ventricle and film, not
    // ventricle and atrium.
    const std::vector<bool> apposed = belt.apposed(model.contact->state().gap);
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



  void
  ValveMonitor::measure_support(const std::vector<double> &X,
                                const std::vector<double> &V,
                                ValveSample &sample) const
  {
    std::vector<double> force(X.size(), 0.);
    model.solid->add_forces(X.data(), V.data(), force.data());
    dealii::Utilities::MPI::sum(force, model.communicator, force);
    sample.annulus_force =
      force_on_supports(model.leaflet.pinned, force).norm();
  }



  std::vector<Tensor<1, 3>>
  ValveMonitor::mid_velocities(const double *y) const
  {
    std::vector<Tensor<1, 3>> result;
    for (const Point<3> &v :
         model.mid_surface(model.system->solid_velocities(y)))
      result.push_back(v);
    return result;
  }



  std::vector<Point<3>>
  ValveMonitor::annulus() const
  {
    std::vector<Point<3>> result;
    for (const unsigned int column : model.leaflet.annulus_columns)
      result.push_back(surface_points[column]);
    return result;
  }



  std::array<double, 4>
  ValveMonitor::bulging_by_region() const
  {
    // Two triangles for each quadrilateral, in their order.
    std::array<std::vector<std::array<unsigned int, 3>>, 4> parts;
    for (unsigned int i = 0; i < model.surface.size(); ++i)
      parts[static_cast<unsigned int>(model.leaflet.quad_region[i / 2])]
        .push_back(model.surface[i]);
    std::array<double, 4> result;
    for (unsigned int i = 0; i < 4; ++i)
      result[i] = bulging_volume(annulus(), surface_points, parts[i]);
    return result;
  }



  void
  ValveMonitor::measure_solid(const double t,
                              const std::vector<double> &X,
                              const std::vector<double> &V,
                              ValveSample &sample)
  {
    const std::vector<double> tensions =
      model.chordae->tensions(t, X.data(), V.data());
    sample.chordae_tension = peaks.class_tensions(tensions);
    sample.chorda_tension  = tensions;

    sample.point_spacing = model.point_spacing(X);

    std::vector<double> jacobian;
    model.solid->cell_results(X.data(), stress, strain, jacobian);
    double volume = 0;
    for (unsigned int c = 0; c < stress.size(); ++c)
      {
        const double weight = model.solid->cell_volumes()[c];
        volume += weight;
        sample.mean_stress += weight * stress[c];
        sample.mean_strain += weight * strain[c];
      }
    sample.mean_stress /= volume;
    sample.mean_strain /= volume;

    sample.bulging_volume =
      bulging_volume(annulus(), surface_points, model.surface);
    measure_support(X, V, sample);

    std::vector<Point<3>> nodes;
    for (unsigned int i = 0; i < X.size(); i += 3)
      nodes.emplace_back(X[i], X[i + 1], X[i + 2]);
    sample.orifice =
      seen_orifice(nodes, outer_faces, [this](const Point<3> &x) {
        return model.lumen.inside(x);
      });

    Point<3> lower = model.lumen.lower(), upper = model.lumen.upper();
    double bottom = surface_points[0][2], top = bottom;
    for (const Point<3> &point : surface_points)
      {
        bottom = std::min(bottom, point[2]);
        top    = std::max(top, point[2]);
      }
    const double margin = 3 * model.parameters.valve.thickness;
    lower[2]            = bottom - margin;
    upper[2]            = top + margin;
    sample.path         = widest_path(
      surface_points,
      model.surface,
      model.parameters.valve.thickness,
      [this](const Point<3> &x) { return model.lumen.inside(x); },
      lower,
      upper,
      0.25e-3,
      std::max(2e-3,
               model.parameters.contact.clearance +
                 2 * model.parameters.mesh.finest_cell()),
      model.communicator);
    // Surfaces touch where contact holds them apart, at the clearance.
    sample.path_gap = sample.path.width;
    sample.path_width =
      std::max(0., sample.path.width - model.parameters.contact.clearance);
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
    sample.outflow_volume = outflow_volume;
    sample.swept_volume   = total_swept;
    measure_noise(y, sample);
    measure_flow(model.system->local_velocity(y), mid_velocities(y), sample);
    measure_solid(t, X, V, sample);

    measure_tractions(y, X);
    sample.coaptation    = coaptation(column_contact_pressure, column_traction);
    sample.contact_force = sample.coaptation.contact_force;
    sample.coaptation_force    = sample.coaptation.force;
    sample.coaptation_area     = sample.coaptation.area;
    sample.coaptation_pressure = sample.coaptation.max_traction;
    sample.min_gap             = model.last_contact.min_gap;

    sample.energy_error = audit.relative_error(y);
    sample.works        = audit.work();
    sample.energies     = audit.energies(y);
    return sample;
  }
} // namespace coapt
