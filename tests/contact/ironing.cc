// A punch is pressed into a slab and drawn along it: without steps of the mesh
// in the force.

#include "blocks.h"
#include "tests.h"

using dealii::Point;

namespace
{
  struct Forces
  {
    double mean, oscillation, friction;
  };

  /** A rigid punch with a parabolic end on a slab with @p n elements a unit of
   * length. Forces while it passes two elements. */
  Forces
  iron(const unsigned int n, const double friction)
  {
    const double radius = 0.6, depth = 0.06;
    Blocks<2> blocks;
    blocks.add({{3 * n, n}},
               [](const Point<2> &p) { return Point<2>(3 * p[0], p[1]); });
    const unsigned int first =
      blocks.add({{10 * n, 2}}, [=](const Point<2> &p) {
        const double x = p[0] - 0.5;
        return Point<2>(1.2 + x,
                        1 + x * x / (2 * radius) * (1 - p[1]) + 0.5 * p[1]);
      });
    const auto &points = blocks.mesh.points;
    std::vector<bool> held(points.size(), false);
    for (unsigned int i = 0; i < points.size(); ++i)
      held[i] = i >= first || points[i][1] < 1e-9;

    std::vector<std::array<unsigned int, 2>> facets;
    for (const auto &facet : coapt::outer_facets(blocks.mesh))
      if (facet[0] >= first
            ? points[facet[0]][1] < 1.3
            : std::min(points[facet[0]][1], points[facet[1]][1]) > 1 - 1e-9)
        facets.push_back(facet);

    coapt::ContactParameters parameters;
    parameters.clearance        = 0;
    parameters.friction         = friction;
    parameters.max_stiffness    = 1e15;
    parameters.stiffness_factor = 0.5;
    parameters.search_margin    = 0.1;
    Motion<2> motion(blocks.mesh, held, facets, parameters, 0.2, 0.3, true);

    // With velocities, so that friction notices.
    const auto move = [&](const double x, const double y) {
      const unsigned int n_steps = 10;
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          for (unsigned int i = first; i < points.size(); ++i)
            {
              motion.V[2 * i]     = x / (n_steps * motion.dt);
              motion.V[2 * i + 1] = y / (n_steps * motion.dt);
            }
          motion.step();
        }
      std::fill(motion.V.begin() + 2 * first, motion.V.end(), 0.);
    };
    for (unsigned int step = 0; step < 20; ++step)
      {
        move(0, -depth / 20);
        motion.relax(100);
      }
    // First until friction slides everywhere.
    const unsigned int before = 12 * n / 4, counted = 2 * 12;
    std::vector<double> forces;
    double sum_of_friction = 0;
    for (unsigned int step = 0; step < before + counted; ++step)
      {
        move(1. / (12 * n), 0);
        motion.relax(120);
        if (step < before)
          continue;
        double tangential = 0;
        for (unsigned int i = 0; i < first; ++i)
          if (points[i][1] > 1 - 1e-9)
            tangential -= motion.F[2 * i];
        forces.push_back(motion.result.normal_force);
        sum_of_friction += tangential / counted;
      }

    // About a straight line, since the slab is softer near its ends.
    double mean = 0, slope = 0, squares = 0, oscillation = 0;
    for (const double force : forces)
      mean += force / counted;
    for (unsigned int i = 0; i < counted; ++i)
      {
        const double t = i - 0.5 * (counted - 1);
        slope += t * forces[i];
        squares += t * t;
      }
    slope /= squares;
    for (unsigned int i = 0; i < counted; ++i)
      oscillation = std::max(
        oscillation,
        std::abs(forces[i] - mean - slope * (i - 0.5 * (counted - 1))) / mean);
    return {mean, oscillation, sum_of_friction / mean};
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double friction : {0., 0.2})
    {
      const std::string name = friction > 0 ? ", with friction" : "";
      const Forces coarse = iron(4, friction), middle = iron(8, friction),
                   fine = iron(16, friction);
      check("force oscillates little with two elements in contact" + name,
            coarse.oscillation < 0.04,
            coarse.oscillation);
      check("and hardly with four" + name,
            middle.oscillation < 0.005,
            middle.oscillation);
      check("and eight" + name, fine.oscillation < 0.005, fine.oscillation);
      check("force converges" + name,
            std::abs(fine.mean - middle.mean) <
                0.5 * std::abs(middle.mean - coarse.mean) &&
              std::abs(fine.mean / middle.mean - 1) < 0.05,
            fine.mean);
      check("friction resists the punch" + name,
            friction == 0 ? std::abs(fine.friction) < 1e-3
                          : fine.friction > 0.85 * friction &&
                fine.friction < 1.001 * friction,
            fine.friction);
    }
}
