// A flap that shuts a channel in 3D and slides along the walls on which the
// fluid rests: it bends as it does in vacuum, at its sides as in the middle,
// and seals.

#include "coupled_case.h"

using namespace coapt;
using dealii::Point;

namespace
{
  const double pressure = 1000, height = 6e-3;

  /** A flap of 1 mm held at the wall z = 0; fluid rests on the walls beside
   * its side edges, and slips along those that it is held at and ends at. */
  CoupledSetup<3>
  flap()
  {
    CoupledSetup<3> s;
    s.upper                  = Point<3>(10e-3, 5e-3, height);
    s.cells                  = {{10, 5, 6}};
    s.boundaries.type        = {{FluidBoundary::pressure_end,
                                 FluidBoundary::pressure_end,
                                 FluidBoundary::no_slip,
                                 FluidBoundary::no_slip,
                                 FluidBoundary::slip,
                                 FluidBoundary::slip}};
    s.boundaries.pressure[0] = [](const double t) {
      return pressure * smooth_ramp(t, 8e-3);
    };
    s.boundaries.pressure[1]  = [](double) { return 0.; };
    s.boundaries.impedance[0] = s.boundaries.impedance[1] =
      0.1 * s.fluid.density * s.fluid.sound_speed;

    s.block   = make_block<3>({{2, 5, 6}}, [](const Point<3> &r) {
      return Point<3>(4.13e-3 + 1e-3 * r[0], 5e-3 * r[1], height * r[2]);
    });
    s.pinned  = s.block.nodes_where([](const auto &r) { return r[2] < 1e-9; });
    s.spacing = 0.8e-3;
    s.solid.material           = "neo-Hookean";
    s.solid.neo_hookean.mu     = 300e3;
    s.solid.neo_hookean.lambda = 1.5e6;
    return s;
  }

  /** How far the upper edge has moved at a side wall and in the middle (m). */
  struct Edge
  {
    double side = 0, middle = 0;
  };

  Edge
  upper_edge(const Block<3> &block, const std::vector<double> &X)
  {
    Edge edge;
    for (unsigned int n = 0; n < block.unit.size(); ++n)
      if (block.unit[n][2] > 1 - 1e-9 && block.unit[n][0] == 0)
        {
          const double moved = X[3 * n] - block.mesh.points[n][0];
          if (block.unit[n][1] < 1e-9)
            edge.side = moved;
          if (std::abs(block.unit[n][1] - 0.4) < 1e-9)
            edge.middle = moved;
        }
    return edge;
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const CoupledSetup<3> setup = flap();
  CoupledCase<3> c(setup);
  const double dt = 0.6 * c.smaller_limit();
  while (c.integrator.time() < 40e-3)
    c.step(dt);
  const Edge wet = upper_edge(c.block, c.system.solid_positions(c.y.data()));
  const Edge dry = upper_edge(
    c.block,
    dry_equilibrium(c.block, c.solid, setup.pinned, pressure, 600, dt, 40e-3));
  check("vacuum, the flap bends", dry.middle > 0.5e-3, dry.middle);
  check_relative("middle bends as in vacuum", wet.middle, dry.middle, 0.03);
  check_relative("side bends as in vacuum", wet.side, dry.side, 0.03);
  const double leak = c.flow(1) / (5e-3 * height);
  check("leak past the edges", std::abs(leak) < 0.3e-3, leak);
}
