// Held nodes that move: interpolation, files, and a valve that is carried along
// without load.

#include <coapt/coupled/prescribed_motion.h>
#include <coapt/geometry/valve_generator.h>

#include <algorithm>
#include <fstream>

#include "integrator.h"
#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::string file = "motion_test.csv";

  void
  interpolation()
  {
    const std::vector<double> times       = {0, 0.1, 0.25, 0.3, 0.5};
    const std::vector<Tensor<1, 3>> given = {Tensor<1, 3>({0, 0, 0}),
                                             Tensor<1, 3>({1, -2, 0}),
                                             Tensor<1, 3>({1, -1, 0}),
                                             Tensor<1, 3>({3, 0, 0}),
                                             Tensor<1, 3>({4, 5, 0})};
    const DisplacementHistory history(times, given);
    double miss = 0, jump = 0, slope = 0, beyond = 0;
    const double e = 1e-7;
    for (unsigned int i = 0; i < times.size(); ++i)
      {
        const double t = times[i];
        miss = std::max(miss, (history.displacement(t) - given[i]).norm());
        jump =
          std::max(jump,
                   (history.velocity(t + e) - history.velocity(t - e)).norm());
      }
    for (double t = 0.0013; t < 0.5; t += 0.01)
      {
        const Tensor<1, 3> differences =
          (history.displacement(t + e) - history.displacement(t - e)) / (2 * e);
        slope  = std::max(slope, (differences - history.velocity(t)).norm());
        beyond = std::max({beyond,
                           history.displacement(t)[0] - 4,
                           -2 - history.displacement(t)[1]});
      }
    check("interpolation, hits the given values", miss < 1e-14, miss);
    check("interpolation, velocity has no jump", jump < 1e-3, jump);
    check("interpolation, velocity is the derivative", slope < 1e-5, slope);
    check("interpolation, does not overshoot", beyond <= 0, beyond);
    check("interpolation, rests before and after",
          history.velocity(-1).norm() + history.velocity(0).norm() +
                history.velocity(0.5).norm() + history.velocity(7).norm() ==
              0 &&
            (history.displacement(7) - given.back()).norm() < 1e-14);
  }

  ModelParameters
  small_valve()
  {
    ModelParameters parameters;
    parameters.valve.n_circumferential = 24;
    parameters.valve.n_radial          = 4;
    parameters.valve.annulus_hold      = AnnulusHold::clamped;
    // At rest without a load: neither prestretch nor taut chordae.
    parameters.valve.circumferential_prestretch = 1;
    parameters.valve.radial_prestretch          = 1;
    parameters.valve.primary_length_factor      = 1.3;
    parameters.valve.secondary_length_factor    = 1.5;
    parameters.ends.pressure_table              = "no_pressure.csv";
    parameters.motion.file                      = file;
    std::ofstream("no_pressure.csv") << "time_s,pressure_Pa\n0,0\n1,0\n";
    return parameters;
  }

  std::string
  refusal(const std::string &content)
  {
    std::ofstream(file) << content;
    Leaflet leaflet = generate_leaflet(small_valve().valve);
    return error_of([&]() { PrescribedMotion(file, leaflet); });
  }

  void
  files()
  {
    const std::string header = "node,time_s,ux_mm,uy_mm,uz_mm\n";
    const auto says = [](const std::string &text, const std::string &part) {
      return text.find(part) != std::string::npos;
    };
    check("files, column missing",
          says(refusal("node,time_s,ux_mm,uy_mm\nannulus,0,0,0\n"),
               "the column uz_mm is missing"));
    check("files, not a number",
          says(refusal(header + "annulus,0,0,zero,0\n"),
               "line 2, column uy_mm: 'zero'"));
    check(
      "files, unknown set",
      says(refusal(header + "anulus,0,0,0,0\n"),
           "line 2: there is no node 'anulus'; there are the sets annulus"));
    check("files, free column",
          says(refusal(header + "5,0,0,0,0\n"), "no node of column 5 is held"));
    check("files, times",
          says(refusal(header + "annulus,0,0,0,0\nannulus,0,1,0,0\n"),
               "line 3: the times of annulus must increase"));
    check("files, start",
          says(refusal(header + "annulus,0,1,0,0\nannulus,1,1,0,0\n"),
               "1.000000 mm at time zero"));
    check("files, named twice",
          says(refusal(header + "annulus,0,0,0,0\n0,0,0,0,0\n"),
               "belongs to another entry"));
  }

  const double duration = 40e-3, settled = 0.2;

  /** Where a rigid motion takes a point at time @p t: a rotation by up to 30
   * degrees about an oblique axis and a shift of up to 5 mm. */
  Point<3>
  rigid_position(const double t, const Point<3> &x)
  {
    const double s     = std::clamp(t / duration, 0., 1.);
    const double rise  = s * s * s * (10 - 15 * s + 6 * s * s);
    const double angle = rise * dealii::numbers::PI / 6;
    const Tensor<1, 3> axis({0.6, 0, 0.8});
    const Tensor<1, 3> shift({3e-3, -4e-3, 0});
    // Rodrigues' formula
    return Point<3>(std::cos(angle) * Tensor<1, 3>(x) +
                    std::sin(angle) * cross_product_3d(axis, Tensor<1, 3>(x)) +
                    (1 - std::cos(angle)) * (axis * x) * axis + rise * shift);
  }

  void
  write_row(std::ostream &out,
            const std::string &node,
            const double t,
            const Point<3> &x)
  {
    const Tensor<1, 3> u = rigid_position(t, x) - x;
    out << node << ',' << t;
    for (unsigned int d = 0; d < 3; ++d)
      out << ',' << 1e3 * u[d];
    out << '\n';
  }

  /** The motion of all held nodes: one in each column, and both tips. */
  void
  write_rigid_motion(const ModelParameters &parameters)
  {
    const Leaflet leaflet = generate_leaflet(parameters.valve);
    std::ofstream out(file);
    out.precision(17);
    out << "node,time_s,ux_mm,uy_mm,uz_mm\n";
    Point<3> left = parameters.valve.papillary_tip;
    left[0] *= -1;
    for (unsigned int k = 0; k <= 80; ++k)
      {
        const double t = duration * k / 80;
        for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
          if (leaflet.pinned[leaflet.columns[c][1]])
            write_row(out,
                      std::to_string(c),
                      t,
                      leaflet.mesh.points[leaflet.columns[c][1]]);
        write_row(out, "papillary_right", t, parameters.valve.papillary_tip);
        write_row(out, "papillary_left", t, left);
      }
  }

  void
  rigid_motion()
  {
    ModelParameters parameters    = small_valve();
    parameters.valve.annulus_hold = AnnulusHold::straps;
    write_rigid_motion(parameters);
    ValveStructure valve(parameters, MPI_COMM_WORLD);
    StructureParameters structure;
    structure.in_blood     = false;
    structure.added_mass   = 0;
    structure.mass_damping = 160; // about critical for the slowest mode
    Timing timing;
    StructureSystem system(valve, structure, timing);
    CentralDifferences integrator = integrator_of(system);

    std::vector<double> state    = valve.reference_positions();
    const auto bound             = valve.solid->step_bound(state.data());
    const double dt              = 1.2 / bound.omega;
    const unsigned int n_entries = state.size();
    state.resize(2 * n_entries, 0.);
    integrator.start(0., state);
    const auto power = [&]() {
      const double *X   = state.data();
      const auto powers = system.powers(integrator.time(), X, X + n_entries);
      return powers.load + powers.chordae - powers.damping;
    };
    double miss = 0, work = 0;
    while (integrator.time() < settled)
      {
        if (integrator.n_steps() % 10 == 0)
          work += 10 * dt * power();
        integrator.step(dt);
        if (integrator.n_steps() % 500 != 0)
          continue;
        for (const unsigned int node : valve.motion.nodes())
          miss = std::max(miss,
                          rigid_position(integrator.time(),
                                         valve.leaflet.mesh.points[node])
                            .distance(Point<3>(state[3 * node],
                                               state[3 * node + 1],
                                               state[3 * node + 2])));
      }
    const std::vector<double> stress =
      valve.solid->cell_results(state.data()).von_mises;
    const double largest = *std::max_element(stress.begin(), stress.end());
    const double energy  = valve.solid->elastic_energy(state.data()) +
      valve.solid->kinetic_energy(state.data() + n_entries);
    double away = 0;
    for (unsigned int n = 0; n < valve.leaflet.mesh.points.size(); ++n)
      away = std::max(away,
                      rigid_position(1., valve.leaflet.mesh.points[n])
                        .distance(Point<3>(state[3 * n],
                                           state[3 * n + 1],
                                           state[3 * n + 2])));
    // The cubics between 81 times miss the path by little.
    check("rigid motion, held nodes follow", miss < 1e-6, miss);
    check("rigid motion, all nodes arrive", away < 1e-5, away);
    check("rigid motion, no stress", largest < 5, largest);
    check("rigid motion, it takes work",
          system.work_of_motion() > 1e-6,
          system.work_of_motion());
    check_relative("rigid motion, energy is balanced",
                   system.work_of_motion() + work,
                   energy,
                   1e-4 * system.work_of_motion() / energy);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  interpolation();
  files();
  rigid_motion();
}
