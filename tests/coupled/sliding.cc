// Plates in a channel in 3D whose side edges slide along walls on which the
// fluid rests: they are not held by them. A loose one moves as a piston, a
// clamped one bends as it does in vacuum, at its sides as in its middle. A
// rigid one that shuts the channel is tight, and leaks without the multiplier;
// moved along, it takes the fluid with it.

#include <coapt/base/first_rank.h>

#include "coupled_case.h"

using namespace coapt;
using dealii::Point;

namespace
{
  const double cell = 1e-3, length = 10e-3, width = 5e-3, height = 6e-3;
  const double thickness = 1e-3;

  /** A plate of height @p top across a channel without friction. Fluid rests
   * on the walls beside its side edges, and slips along the other two. */
  CoupledSetup<3>
  plate(const double top, const double pressure, const double impedance)
  {
    CoupledSetup<3> s;
    s.upper           = Point<3>(length, width, height);
    s.cells           = {{static_cast<unsigned int>(std::lround(length / cell)),
                          static_cast<unsigned int>(std::lround(width / cell)),
                          static_cast<unsigned int>(std::lround(height / cell))}};
    s.boundaries.type = {{FluidBoundary::pressure_end,
                          FluidBoundary::pressure_end,
                          FluidBoundary::no_slip,
                          FluidBoundary::no_slip,
                          FluidBoundary::slip,
                          FluidBoundary::slip}};
    s.boundaries.pressure[0]  = [=](double) { return pressure; };
    s.boundaries.pressure[1]  = [](double) { return 0.; };
    s.boundaries.impedance[0] = s.boundaries.impedance[1] = impedance;

    s.block = make_block<3>({{2, 5, 6}}, [=](const Point<3> &r) {
      return Point<3>(4.13e-3 + thickness * r[0], width * r[1], top * r[2]);
    });
    s.pinned.assign(s.block.unit.size(), false);
    s.spacing                  = 0.8 * cell;
    s.solid.material           = "neo-Hookean";
    s.solid.neo_hookean.mu     = 300e3;
    s.solid.neo_hookean.lambda = 1.5e6;
    return s;
  }

  /** How far the upper edge has moved at a side wall and between them (m). */
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

  /** A loose plate, without viscosity. The fluid between the nodes that are
   * free moves with it against the impedance Z of the ends:
   * m v' = p - 2 Z v. */
  void
  piston()
  {
    const double p = 200, Z = 1000, end = 10e-3;
    CoupledSetup<3> s            = plate(height, p, Z);
    s.fluid.viscosity            = 0;
    s.fluid.artificial_viscosity = 0;
    s.fluid.convection           = false;
    CoupledCase<3> c(s);
    const double dt = 0.6 * c.smaller_limit();
    while (c.integrator.time() < end)
      c.step(dt);
    const Edge edge = upper_edge(c.block, c.system.solid_positions(c.y.data()));

    const double m =
      1060 * (length + thickness * width / (width - cell)); // kg/m^2
    const double time = m / (2 * Z), t = c.integrator.time();
    const double expected =
      p / (2 * Z) * (t - time * (1 - std::exp(-t / time)));
    check_relative("piston, middle", edge.middle, expected, 0.03);
    check_relative("piston, side", edge.side, edge.middle, 0.02);
  }

  /** A plate that is held below and ends clear of the upper wall, under a
   * pressure on one of its faces. In the end nothing flows. */
  void
  flap()
  {
    const double p    = 2000;
    CoupledSetup<3> s = plate(0.7 * height, 0, 5000);
    s.pinned = s.block.nodes_where([](const auto &r) { return r[2] < 1e-9; });
    CoupledCase<3> c(s);
    const FollowerPressure<3> pressure(s.block);
    c.system.add_load(
      [&](const double t, const double *X, const double *, double *F) {
        // the loads of all ranks are summed up
        if (is_first_rank(MPI_COMM_WORLD))
          pressure.add(p * smooth_ramp(t, 10e-3), X, F);
      });
    const double dt = 0.6 * c.smaller_limit();
    while (c.integrator.time() < 40e-3)
      c.step(dt);
    const Edge wet = upper_edge(c.block, c.system.solid_positions(c.y.data()));
    const SolidOperator<3> whole(c.block.mesh, s.solid, {}, {}, MPI_COMM_SELF);
    const Edge dry =
      upper_edge(c.block,
                 dry_equilibrium(c.block, whole, s.pinned, p, 600, dt, 40e-3));
    check("flap, bends", dry.middle > 0.2e-3, dry.middle);
    // Linear interpolation in the four cells along its height stiffens it.
    check_relative("flap, middle as in vacuum", wet.middle, dry.middle, 0.1);
    check_relative("flap, side as its middle",
                   wet.side / dry.side,
                   wet.middle / dry.middle,
                   0.01);
  }

  /** Flow (m/s) through a rigid plate that shuts the channel, all of whose
   * walls slip, after @p end (s), with the coefficients @p k. */
  double
  velocity_through(const double pressure,
                   const double impedance,
                   const RelaxationCoefficients &k,
                   const double end)
  {
    CoupledSetup<3> s    = plate(height, pressure, impedance);
    s.boundaries.type[2] = s.boundaries.type[3] = FluidBoundary::slip;
    s.pinned.assign(s.pinned.size(), true);
    CoupledCase<3> c(s);
    while (c.integrator.time() < end)
      c.step(10e-6, &k);
    return c.flow(1) / (width * height);
  }

  void
  rigid()
  {
    const double p = 16e3, Z = 15900;
    RelaxationCoefficients k = relaxation_coefficients(1060, 1060, 20e-6, 0.5);
    const double tight       = velocity_through(p, Z, k, 8e-3);
    k.stiffness              = 0;
    // Darcy's law for the plate, and the impedance of both ends.
    const double expected = p / (k.drag * thickness + 2 * Z);
    check_relative("rigid, drag only, leak",
                   velocity_through(p, Z, k, 8e-3),
                   expected,
                   0.03);
    check("rigid, drag and multiplier, tight",
          std::abs(tight) < 1e-4 * expected,
          tight);
  }

  /** A rigid plate that shuts the channel is moved along it: the fluid goes
   * with it, and the work is what the fluid gains and the ends take. */
  void
  moved()
  {
    const double Z = 5300, speed = 0.2, end = 4e-3, dt = 10e-6;
    CoupledSetup<3> s    = plate(height, 0, Z);
    s.boundaries.type[2] = s.boundaries.type[3] = FluidBoundary::slip;
    s.fluid.viscosity = s.fluid.artificial_viscosity = 0;
    s.pinned.assign(s.pinned.size(), true);
    CoupledCase<3> c(s);
    const auto velocity = [=](const double t) {
      return speed * smooth_ramp(t, end);
    };
    // smooth_ramp() integrated
    const auto way = [=](const double t) {
      const double x = t / end;
      return speed * end * x * x * x * x * (2.5 + x * (x - 3));
    };
    const auto &points = c.block.mesh.points;
    c.system.set_motion([&](const double t, double *X, double *V) {
      for (unsigned int n = 0; n < points.size(); ++n)
        {
          X[3 * n] = points[n][0] + way(t);
          V[3 * n] = velocity(t);
        }
    });
    double lost = 0; // at both ends
    while (c.integrator.time() < end - 0.5 * dt)
      {
        lost += 2 * Z * width * height * dt *
          std::pow(velocity(c.integrator.time()), 2);
        c.step(dt);
      }
    const std::vector<double> X = c.system.solid_positions(c.y.data());
    check_relative("moved, plate arrives", X[0] - points[0][0], way(end), 1e-9);
    check_relative("moved, fluid goes with it",
                   c.flow(1),
                   speed * width * height,
                   0.01);
    check_relative("moved, work",
                   c.system.work_of_motion(),
                   c.energy() + lost,
                   0.02);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  piston();
  flap();
  rigid();
  moved();
}
