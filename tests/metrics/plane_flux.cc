// Flow of a fluid through planes that cut its cells.

#include <coapt/metrics/plane_flux.h>

#include "metrics/linear_flow.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  LinearFlow fluid;
  const auto flux = [&](const Point<3> &point, const Tensor<1, 3> &normal) {
    return flux_through_plane(fluid.op,
                              fluid.local_velocity(),
                              {point, normal},
                              MPI_COMM_WORLD);
  };

  // mean of u_z over the box: 1 + 0.5 * 2 - 0.25 * 2
  const Tensor<1, 3> up({0., 0., 1.});
  check_relative("across cells", flux({2, 2, 1.3}, up), 24., 1e-12);
  check_relative("along faces of cells", flux({0, 0, 2}, up), 24., 1e-12);
  check_relative("along faces of small cells only",
                 flux({0, 0, 1.5}, 2. * up),
                 24.,
                 1e-12);
  check_relative("against the normal", flux({1, 1, 0.1}, -up), -24., 1e-12);
  check("outside of the box", flux({0, 0, 4.1}, up) == 0);

  // z = 2 + (x - 2)/4 + (y - 2)/2: area vector (-1/4, -1/2, 1) an area of the
  // projection; u_y = 0.3.
  check_relative("oblique",
                 flux({2, 2, 2}, Tensor<1, 3>({-0.25, -0.5, 1.})),
                 24. - 16 * 0.5 * 0.3,
                 1e-12);

  // In a divergence-free flow all planes between the same edges carry as much.
  fluid.set_velocity([](const Point<3> &x,
                        const int d) { return d == 2 ? x[0] * x[1] : 0.; },
                     false);
  check_relative("bilinear flow, oblique",
                 flux({2, 2, 2}, Tensor<1, 3>({0.3, -0.2, 1.})),
                 64.,
                 1e-12);
}
