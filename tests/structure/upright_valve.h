#ifndef coapt_tests_structure_upright_valve_h
#define coapt_tests_structure_upright_valve_h

#include <coapt/metrics/structure_monitor.h>

#include <cmath>
#include <functional>
#include <vector>

#include "small_valve.h"

/** Shape of upright_valve(): semi-axes and height, of the leaflet and of the
 * root above it (m). */
constexpr double upright_a = 17.5e-3, upright_b = 14e-3, upright_height = 15e-3,
                 upright_root = 1.25e-3;

/** Its columns around, at multiples of ten degrees, and its rows below that of
 * the annulus. */
constexpr unsigned int upright_around = 36, upright_rows = 6;

/** A small valve whose leaflets are an upright elliptic tube of neo-Hookean
 * tissue without prestretch. */
inline coapt::ModelParameters
upright_valve()
{
  coapt::ModelParameters parameters = small_valve("0,0\n1,0\n");
  coapt::ValveParameters &valve     = parameters.valve;
  valve.annulus_semi_axis_x         = upright_a;
  valve.annulus_semi_axis_y         = upright_b;
  valve.saddle_height               = 0;
  valve.anterior_height = valve.posterior_height = valve.commissure_height =
    upright_height;
  valve.anterior_cone_angle        = valve.posterior_cone_angle =
    valve.commissure_cone_angle    = 0;
  valve.root_length                = upright_root;
  valve.circumferential_prestretch = valve.radial_prestretch = 1;
  valve.quadratic                                            = false;
  valve.n_circumferential                                    = upright_around;
  valve.n_radial                                             = upright_rows;
  parameters.solid.material                                  = "neo-Hookean";
  return parameters;
}

/** A valve without fluid and what observes it. */
struct ObservedValve
{
  explicit ObservedValve(const coapt::ModelParameters &parameters)
    : valve(parameters, MPI_COMM_WORLD)
    , system(valve, dry(), timing)
    , monitor(valve, system)
  {
  }

  ObservedValve(const ObservedValve &) = delete;

  using Map = std::function<dealii::Point<3>(const dealii::Point<3> &)>;

  /** The state in which each node is where @p position puts that of the mesh,
   * with the velocity that @p velocity gives for it. */
  std::vector<double>
  state(
    const Map &position,
    const Map &velocity = [](const auto &) { return dealii::Point<3>(); }) const
  {
    std::vector<double> result;
    for (const Map &map : {position, velocity})
      for (const dealii::Point<3> &x : valve.leaflet.mesh.points)
        for (unsigned int d = 0; d < 3; ++d)
          result.push_back(map(x)[d]);
    return result;
  }

  /** Observes a state, and contact in it. */
  coapt::ValveSample
  sample(const double t, const std::vector<double> &state)
  {
    system.finish_step(state.data(), state.data() + state.size() / 2, 1e-6);
    return monitor.sample(t, state);
  }

  coapt::ValveStructure valve;
  coapt::Timing timing;
  coapt::StructureSystem system;
  coapt::StructureMonitor monitor;

private:
  static coapt::StructureParameters
  dry()
  {
    coapt::StructureParameters parameters;
    parameters.in_blood = false;
    return parameters;
  }
};

#endif
