#include <deal.II/base/mpi.h>

#include <coapt/geometry/boundary_faces.h>
#include <coapt/geometry/outline.h>
#include <coapt/metrics/bulging_volume.h>
#include <coapt/metrics/distribution.h>
#include <coapt/metrics/fold_crest.h>
#include <coapt/metrics/leaflet_monitor.h>
#include <coapt/metrics/loads.h>
#include <coapt/metrics/swept_volume.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  LeafletMonitor::LeafletMonitor(ValveStructure &valve,
                                 const CoaptationSettings &settings,
                                 const double widest)
    : peaks(valve.chordae->chordae())
    , column_contact_pressure(valve.leaflet.columns.size(), 0.)
    , column_traction(valve.leaflet.columns.size(), 0.)
    , valve(valve)
    , belt(valve.leaflet, settings)
    , past_edge(valve.leaflet)
    , history(valve.leaflet.columns.size(),
              valve.parameters.contact.clearance,
              valve.parameters.valve.thickness)
    , widest(widest)
  {
    for (const auto &face : boundary_faces<3>(valve.leaflet.mesh.cells))
      outer_faces.push_back(face.nodes);
  }



  void
  LeafletMonitor::accumulate_motion(const double t,
                                    const std::vector<double> &X,
                                    const std::vector<double> &V)
  {
    const std::vector<Point<3>> points = valve.mid_surface(X);
    if (!surface_points.empty())
      total_swept += swept_volume(surface_points, points, valve.surface);
    surface_points = points;
    peaks.update(t, valve.chordae->tensions(t, X.data(), V.data()));
    const auto &contact = valve.contact->state();
    history.update(t,
                   {contact.gap,
                    contact.normals,
                    points,
                    mid_velocities(V),
                    valve.contact->spins(points, V.data())});
  }



  std::vector<Tensor<1, 3>>
  LeafletMonitor::mid_velocities(const std::vector<double> &V) const
  {
    std::vector<Tensor<1, 3>> result;
    for (const Point<3> &v : valve.mid_surface(V))
      result.push_back(v);
    return result;
  }



  std::vector<Point<3>>
  LeafletMonitor::annulus() const
  {
    std::vector<Point<3>> result;
    for (const unsigned int column : valve.leaflet.annulus_columns)
      result.push_back(surface_points[column]);
    return result;
  }



  std::array<double, n_regions>
  LeafletMonitor::bulging_by_region() const
  {
    // Two triangles for each quadrilateral, in their order.
    std::vector<Region> regions;
    for (const Region region : valve.leaflet.quad_region)
      regions.insert(regions.end(), 2, region);
    return coapt::bulging_by_region(annulus(),
                                    surface_points,
                                    valve.surface,
                                    regions);
  }



  double
  LeafletMonitor::bulging_by_distance() const
  {
    return coapt::bulging_by_distance(annulus(), surface_points, valve.surface);
  }



  std::function<bool(const Point<3> &)>
  LeafletMonitor::in_lumen() const
  {
    if (!valve.imported)
      return [this](const Point<3> &x) { return valve.lumen.inside(x); };
    const auto outline = std::make_shared<const Outline>(annulus());
    return [outline](const Point<3> &x) { return outline->inside(x); };
  }



  Tensor<1, 3>
  LeafletMonitor::annulus_force(const std::vector<double> &X,
                                const std::vector<double> &V,
                                const std::vector<double> &load) const
  {
    std::vector<double> force(X.size(), 0.);
    valve.solid->add_forces(X.data(), V.data(), force.data());
    dealii::Utilities::MPI::sum(force, valve.communicator, force);
    return force_on_supports(valve.leaflet.pinned, force) +
      force_on_supports(valve.leaflet.pinned, load);
  }



  WidestPath
  LeafletMonitor::find_widest_path() const
  {
    Point<3> lower = valve.lumen.lower(), upper = valve.lumen.upper();
    double bottom = surface_points[0][2], top = bottom;
    for (const Point<3> &point : surface_points)
      {
        bottom = std::min(bottom, point[2]);
        top    = std::max(top, point[2]);
      }
    const double margin = 3 * valve.parameters.valve.thickness;
    lower[2]            = bottom - margin;
    upper[2]            = top + margin;
    return widest_path(surface_points,
                       valve.surface,
                       valve.parameters.valve.thickness,
                       in_lumen(),
                       lower,
                       upper,
                       0.25e-3,
                       widest,
                       valve.communicator);
  }



  void
  LeafletMonitor::measure_displacements(const std::vector<double> &X,
                                        ValveSample &sample) const
  {
    const auto displacement = [&](const unsigned int node) {
      return valve.leaflet.mesh.points[node].distance(
        Point<3>(X[3 * node], X[3 * node + 1], X[3 * node + 2]));
    };
    for (const auto &column : valve.leaflet.columns)
      for (const unsigned int node : column)
        sample.displacement = std::max(sample.displacement, displacement(node));
    for (const auto &[name, nodes] : valve.leaflet.held_sets)
      for (const unsigned int node : nodes)
        sample.held_displacement[name] =
          std::max(sample.held_displacement[name], displacement(node));
  }



  void
  LeafletMonitor::measure_distortion(ValveSample &sample) const
  {
    const std::vector<double> &stretch = cells.smallest_stretch;
    const double threshold = valve.parameters.solid.distortion_threshold;
    sample.distorted_cells =
      std::count_if(stretch.begin(), stretch.end(), [&](const double value) {
        return value < threshold;
      });
    const auto least        = std::min_element(stretch.begin(), stretch.end());
    sample.smallest_stretch = *least;
    const auto &mesh        = valve.leaflet.mesh;
    for (const unsigned int node : mesh.cells[least - stretch.begin()])
      sample.crushed_place += mesh.points[node] / 4.;
  }



  void
  LeafletMonitor::measure_solid(const double t,
                                const std::vector<double> &X,
                                const std::vector<double> &V,
                                const std::vector<double> &load,
                                ValveSample &sample)
  {
    const std::vector<double> tensions =
      valve.chordae->tensions(t, X.data(), V.data());
    sample.chordae_tension = peaks.class_tensions(tensions);
    sample.chorda_tension  = tensions;

    cells                              = valve.solid->cell_results(X.data());
    const std::vector<double> &volumes = valve.solid->cell_volumes();
    sample.mean_stress    = weighted_mean(cells.von_mises, volumes);
    sample.mean_principal = weighted_mean(cells.principal_stress, volumes);
    sample.mean_strain    = weighted_mean(cells.largest_strain, volumes);
    measure_distortion(sample);

    sample.swept_flow =
      swept_rate(surface_points, mid_velocities(V), valve.surface);
    sample.swept_volume = total_swept;

    sample.bulging_volume =
      bulging_volume(annulus(), surface_points, valve.surface);
    sample.annulus_force = annulus_force(X, V, load);
    measure_displacements(X, sample);

    std::vector<Point<3>> nodes;
    for (unsigned int i = 0; i < X.size(); i += 3)
      nodes.emplace_back(X[i], X[i + 1], X[i + 2]);
    sample.orifice = seen_orifice(nodes, outer_faces, in_lumen());

    sample.path = find_widest_path();
    // Surfaces touch where contact holds them apart, at the clearance.
    sample.path_gap = sample.path.width;
    sample.path_width =
      std::max(0., sample.path.width - valve.parameters.contact.clearance);
    sample.min_gap = valve.last_contact.min_gap;
  }



  CoaptationResult
  LeafletMonitor::coaptation(const std::vector<double> &contact_pressure,
                             const std::vector<double> &total_traction) const
  {
    return belt.evaluate(coaptation_gaps(),
                         contact_pressure,
                         total_traction,
                         valve.contact->state().current_area);
  }



  std::vector<double>
  LeafletMonitor::gaps() const
  {
    const auto &state = valve.contact->state();
    return gaps_with_fold_crests(state.gap,
                                 state.normals,
                                 surface_points,
                                 valve.leaflet.thickness,
                                 belt.gap_limit());
  }



  std::vector<double>
  LeafletMonitor::coaptation_gaps() const
  {
    std::vector<double> result = gaps();
    const std::vector<bool> past =
      past_edge(surface_points, valve.contact->state().partner);
    for (unsigned int c = 0; c < result.size(); ++c)
      if (past[c])
        result[c] = MidSurfaceContact::no_gap;
    return result;
  }



  void
  LeafletMonitor::measure_coaptation(ValveSample &sample) const
  {
    sample.coaptation    = coaptation(column_contact_pressure, column_traction);
    sample.contact_force = sample.coaptation.contact_force;
    sample.coaptation_force    = sample.coaptation.force;
    sample.coaptation_area     = sample.coaptation.area;
    sample.coaptation_pressure = sample.coaptation.max_traction;
  }
} // namespace coapt
