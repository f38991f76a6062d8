// A punch is pressed into a slab and drawn along it: without steps of the mesh
// in the force.

#include "blocks.h"
#include "tests.h"

using dealii::Point;

namespace
{
  constexpr unsigned int steps_an_element = 12;

  struct Forces
  {
    double mean, oscillation, friction;
  };

  /** A rigid punch with a parabolic end on a slab with @p n elements a unit of
   * length. */
  struct Punch
  {
    Punch(const unsigned int n, const double friction) : n(n)
    {
      const double radius = 0.6;
      Blocks<2> blocks;
      blocks.add({{3 * n, n}},
                 [](const Point<2> &p) { return Point<2>(3 * p[0], p[1]); });
      first              = blocks.add({{10 * n, 2}}, [=](const Point<2> &p) {
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
      motion                      = std::make_unique<Motion<2>>(
        blocks.mesh, held, facets, parameters, 0.2, 0.3, true);
    }

    // With velocities, so that friction notices.
    void
    move(const double x, const double y)
    {
      const unsigned int n_steps = 10;
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          for (unsigned int i = 2 * first; i < motion->V.size(); ++i)
            motion->V[i] = (i % 2 == 0 ? x : y) / (n_steps * motion->dt);
          motion->step();
        }
      std::fill(motion->V.begin() + 2 * first, motion->V.end(), 0.);
    }

    void
    press(const double depth)
    {
      const unsigned int n_steps = std::lround(depth / 0.0025);
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          move(0, -depth / n_steps);
          motion->relax(100);
        }
    }

    void
    slide(const double direction)
    {
      move(direction / (steps_an_element * n), 0);
      motion->relax(120);
    }

    /** Forces while it passes two elements. */
    Forces
    iron(const double direction)
    {
      const unsigned int counted = 2 * steps_an_element;
      std::vector<double> forces;
      double friction = 0;
      for (unsigned int step = 0; step < counted; ++step)
        {
          slide(direction);
          for (unsigned int i = 0; i < first; ++i)
            if (motion->mesh.points[i][1] > 1 - 1e-9)
              friction -= motion->F[2 * i] / counted;
          forces.push_back(motion->result.normal_force);
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
        oscillation = std::max(oscillation,
                               std::abs(forces[i] - mean -
                                        slope * (i - 0.5 * (counted - 1))) /
                                 mean);
      return {mean, oscillation, friction / mean};
    }

    const unsigned int n;
    unsigned int first; // node of the punch
    std::unique_ptr<Motion<2>> motion;
  };

  // Each end of the contact adds an oscillation of the period of the elements,
  // and their sum goes with the cosine of pi times the number of elements in
  // the contact: at some depths it vanishes by chance. The largest of depths
  // over which that number changes by one is what the mesh does.
  double
  largest_oscillation(const unsigned int n)
  {
    Punch punch(n, 0);
    punch.press(0.045);
    double largest = 0, direction = 1;
    for (unsigned int i = 0; i < 6; ++i, direction *= -1)
      {
        punch.press(0.005);
        largest = std::max(largest, punch.iron(direction).oscillation);
      }
    return largest;
  }

  Forces
  with_friction(const unsigned int n, const double friction)
  {
    Punch punch(n, friction);
    punch.press(0.06);
    // First until friction slides everywhere.
    for (unsigned int step = 0; step < steps_an_element * n / 4; ++step)
      punch.slide(1);
    return punch.iron(1);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  double coarser = 0;
  for (const unsigned int n : {4, 8, 16})
    {
      const double oscillation = largest_oscillation(n);
      check("force oscillates little, with fewer elements more: " +
              std::to_string(n / 2) + " in the contact",
            n == 4 ? oscillation < 0.05 : oscillation < 0.4 * coarser,
            oscillation);
      coarser = oscillation;
    }
  check("and hardly at last", coarser < 0.005, coarser);

  const double mu     = 0.2;
  const Forces coarse = with_friction(4, mu), middle = with_friction(8, mu),
               fine = with_friction(16, mu);
  check("force converges, with friction",
        std::abs(fine.mean - middle.mean) <
            0.5 * std::abs(middle.mean - coarse.mean) &&
          std::abs(fine.mean / middle.mean - 1) < 0.05,
        fine.mean);
  check("and hardly oscillates", fine.oscillation < 0.005, fine.oscillation);
  check("friction resists the punch",
        fine.friction > 0.85 * mu && fine.friction < 1.001 * mu,
        fine.friction);
}
