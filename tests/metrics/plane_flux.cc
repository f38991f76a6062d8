// Flow of a fluid through planes that cut its cells.

#include <coapt/metrics/closure_volumes.h>
#include <coapt/metrics/plane_flux.h>
#include <coapt/metrics/surface_flux.h>
#include <coapt/metrics/swept_volume.h>

#include "metrics/linear_flow.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** A plate of 3 m^2 in the flow, at z = 2, that is faster than the fluid by
   * @p excess (m/s): flow through the plane above it without what it sweeps,
   * and flow through the plate. */
  std::array<double, 2>
  past_moving_plate(const LinearFlow &fluid, const double excess)
  {
    const std::vector<Point<3>> points                       = {{0.5, 1, 2},
                                                                {3.5, 1, 2},
                                                                {3.5, 2, 2},
                                                                {0.5, 2, 2}};
    const std::vector<std::array<unsigned int, 3>> triangles = {{{0, 2, 1}},
                                                                {{0, 3, 2}}};
    std::vector<Tensor<1, 3>> velocities(4);
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        velocities[i][d] =
          LinearFlow::linear_flow(points[i], d) + (d == 2 ? excess : 0.);
    const std::vector<double> u = fluid.local_velocity();
    ValveSample sample;
    sample.plane_flow = {flux_through_plane(
      fluid.op, u, {{2, 2, 3}, Tensor<1, 3>({0., 0., 1.})}, MPI_COMM_WORLD)};
    sample.swept_flow = swept_rate(points, velocities, triangles);
    return {{plane_flow_less_swept(sample, 0),
             flux_through_surface(
               fluid.op, u, points, velocities, triangles, MPI_COMM_WORLD)}};
  }
} // namespace



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

  // mean of u_z over the plate: 1 + 0.5 * 2 - 0.25 * 1.5 = 1.625
  const auto with_fluid = past_moving_plate(fluid, 0),
             faster     = past_moving_plate(fluid, 2);
  check_relative("beside a plate that moves with the fluid",
                 with_fluid[0],
                 24. - 3 * 1.625,
                 1e-12);
  check("and none through it", std::abs(with_fluid[1]) < 1e-12, with_fluid[1]);
  check_relative("less past one that is faster",
                 faster[0],
                 24. - 3 * 3.625,
                 1e-12);
  check_relative("by what flows back through it",
                 faster[0] - with_fluid[0],
                 faster[1],
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
