// Flow of a fluid through a moving surface.

#include <coapt/metrics/surface_flux.h>

#include "metrics/linear_flow.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const LinearFlow fluid;
  const auto velocity = fluid.local_velocity();

  // A plate about z = 2 from (0.5, 1) to (3.5, 2), tilted about its diagonal,
  // with its area vectors to -z.
  std::vector<Point<3>> points                       = {{0.5, 1, 2},
                                                        {3.5, 1, 2.1},
                                                        {3.5, 2, 2},
                                                        {0.5, 2, 1.9}};
  std::vector<std::array<unsigned int, 3>> triangles = {{{0, 2, 1}},
                                                        {{0, 3, 2}}};
  std::vector<Tensor<1, 3>> at_rest(4), with_fluid(4);
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      with_fluid[i][d] = LinearFlow::linear_flow(points[i], d);
  const auto flux = [&](const std::vector<Tensor<1, 3>> &velocities) {
    return flux_through_surface(
      fluid.op, velocity, points, velocities, triangles, MPI_COMM_WORLD);
  };

  double exact = 0;
  for (const auto &[a, b, c] : triangles)
    {
      const Point<3> center((points[a] + (points[b] - points[a]) / 3. +
                             (points[c] - points[a]) / 3.));
      const Tensor<1, 3> u({0., 0.3, 1 + 0.5 * center[0] - 0.25 * center[1]});
      exact -= 0.5 *
        cross_product_3d(points[b] - points[a], points[c] - points[a]) * u;
    }
  check("flow to the atrium is positive", exact > 0, exact);
  check_relative("flow through a plate at rest", flux(at_rest), exact, 1e-12);
  check("none through one that moves with the fluid",
        std::abs(flux(with_fluid)) < 1e-12,
        flux(with_fluid));

  triangles.push_back({{4, 5, 6}});
  points.insert(points.end(), {{9, 9, 9}, {10, 9, 9}, {9, 10, 9}});
  at_rest.resize(7);
  check_relative("nothing flows outside of the box",
                 flux(at_rest),
                 exact,
                 1e-12);
}
