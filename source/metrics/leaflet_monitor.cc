#include <coapt/metrics/bulging_volume.h>
#include <coapt/metrics/leaflet_monitor.h>
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
    , widest(widest)
  {
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
    return widest_path(
      surface_points,
      valve.surface,
      valve.parameters.valve.thickness,
      [this](const Point<3> &x) { return valve.lumen.inside(x); },
      lower,
      upper,
      0.25e-3,
      widest,
      valve.communicator);
  }



  void
  LeafletMonitor::measure_solid(const double t,
                                const std::vector<double> &X,
                                const std::vector<double> &V,
                                ValveSample &sample) const
  {
    const std::vector<double> tensions =
      valve.chordae->tensions(t, X.data(), V.data());
    sample.chordae_tension = peaks.class_tensions(tensions);

    std::vector<double> stress, strain, jacobian;
    valve.solid->cell_results(X.data(), stress, strain, jacobian);
    double volume = 0;
    for (unsigned int c = 0; c < stress.size(); ++c)
      {
        const double weight = valve.solid->cell_volumes()[c];
        volume += weight;
        sample.mean_stress += weight * stress[c];
        sample.mean_strain += weight * strain[c];
      }
    sample.mean_stress /= volume;
    sample.mean_strain /= volume;

    std::vector<Tensor<1, 3>> velocities;
    for (const Point<3> &v : valve.mid_surface(V))
      velocities.push_back(v);
    sample.swept_flow   = swept_rate(surface_points, velocities, valve.surface);
    sample.swept_volume = total_swept;

    std::vector<Point<3>> annulus;
    for (const unsigned int column : valve.leaflet.annulus_columns)
      annulus.push_back(surface_points[column]);
    sample.bulging_volume =
      bulging_volume(annulus, surface_points, valve.surface);

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
    const auto &state = valve.contact->state();
    return belt.evaluate(state.gap,
                         contact_pressure,
                         total_traction,
                         state.current_area);
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
