// Blocks with different meshes under uniform pressure: so is that of contact.

#include "blocks.h"
#include "tests.h"

namespace
{
  /** Two blocks on top of each other, the lower one with rollers below. */
  template <int dim>
  void
  patch(const std::string &name,
        const std::array<unsigned int, dim> &n_lower,
        const std::array<unsigned int, dim> &n_upper)
  {
    using Point = dealii::Point<dim>;
    Blocks<dim> blocks;
    // Nodes within the surface of contact are moved, too.
    const auto shaken = [](Point p) {
      double bump = 1;
      for (unsigned int d = 0; d + 1 < dim; ++d)
        bump *= std::sin(M_PI * p[d]);
      for (unsigned int d = 0; d + 1 < dim; ++d)
        p[d] += 0.04 * bump * std::cos(2. + d + 2 * p[dim - 1]);
      return p;
    };
    blocks.add(n_lower, [&](const Point &p) {
      Point q    = shaken(p);
      q[dim - 1] = 0.5 * p[dim - 1];
      return q;
    });
    blocks.add(n_upper, [&](const Point &p) {
      Point q    = shaken(p);
      q[dim - 1] = 0.5 + 0.5 * p[dim - 1];
      return q;
    });

    coapt::ContactParameters parameters;
    parameters.clearance        = 0;
    parameters.friction         = 0;
    parameters.max_stiffness    = 1e15;
    parameters.stiffness_factor = 0.5;
    parameters.search_margin    = 0.1;
    const auto &points          = blocks.mesh.points;
    Motion<dim> motion(blocks.mesh,
                       std::vector<bool>(points.size(), false),
                       coapt::outer_facets(blocks.mesh),
                       parameters,
                       0.2,
                       0.3,
                       true);
    // The other sides are free and flush.
    motion.constrain = [&](std::vector<double> &V) {
      for (unsigned int n = 0; n < points.size(); ++n)
        {
          if (points[n][dim - 1] < 1e-9)
            V[dim * n + dim - 1] = 0;
          for (unsigned int d = 0; d + 1 < dim; ++d)
            if (points[n][d] < 1e-9)
              V[dim * n + d] = 0;
        }
    };

    const double pressure = 5e3;
    Point down;
    down[dim - 1] = -1;
    motion.load(pressure, down, [](const Point &p) {
      return p[dim - 1] > 1 - 1e-9;
    });
    motion.relax(4000);
    check_relative(name + ": force of contact",
                   motion.result.normal_force,
                   pressure,
                   1e-4);
    double least = 1e300, largest = 0;
    for (unsigned int n = 0; n < points.size(); ++n)
      if (std::abs(points[n][dim - 1] - 0.5) < 1e-9)
        {
          const double p = motion.contact.pressure()[n];
          least          = std::min(least, p);
          largest        = std::max(largest, p);
        }
    check(name + ": uniform pressure",
          largest / least - 1 < 1e-6,
          largest / least - 1);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  patch<2>("edges", {{5, 3}}, {{7, 4}});
  patch<2>("many edges", {{16, 8}}, {{12, 6}});
  patch<3>("triangles", {{3, 3, 2}}, {{4, 4, 2}});
}
