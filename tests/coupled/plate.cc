// An elastic plate that shuts a channel under 16 kPa: it seals, it bends as it
// does in vacuum, and it leaks where it must leak.

#include "coupled_case.h"

using namespace coapt;

namespace
{
  /** Deflection of the plate's middle in vacuum (m), with the nodes within
   * @p clamped of the walls held. */
  double
  dry_deflection(const Plate &plate, const double clamped, const double dt)
  {
    const CoupledSetup<2> s = plate.setup();
    const SolidOperator<2> solid(s.block.mesh, s.solid, {}, {}, MPI_COMM_SELF);
    const auto held = s.block.nodes_where([&](const dealii::Point<2> &r) {
      const double y = r[1] * plate.height;
      return std::min(y, plate.height - y) < clamped + 1e-9;
    });
    const auto X =
      dry_equilibrium(s.block, solid, held, plate.pressure, 400, dt, 50e-3);
    return mid_deflection(s.block, X);
  }

  /** Walls along which the fluid slips, so that it can turn with the plate
   * where this is clamped. */
  void
  slip_walls()
  {
    Plate plate;
    plate.wall = FluidBoundary::slip;
    CoupledCase<2> c(plate.setup());
    const double dt          = 0.5 * c.smaller_limit();
    const PlateResult result = run_plate(c, plate, dt, 40e-3, 50e-3);
    check("slip walls, leak at 50 ms",
          std::abs(result.leak) < 0.05e-3,
          result.leak);
    check("slip walls, at rest", result.wobble < 10e-6, result.wobble);
    const double dry = dry_deflection(plate, 0, 0.8 * dt);
    check_relative("slip walls, deflection as in vacuum",
                   result.deflection,
                   dry,
                   0.01);
  }

  /** Walls on which the fluid rests. */
  void
  no_slip_walls()
  {
    double stiffening[2];
    for (const int i : {0, 1})
      {
        Plate plate;
        plate.cell = i == 0 ? 1e-3 : 0.5e-3;
        CoupledCase<2> c(plate.setup());
        const double dt          = 0.5 * c.smaller_limit();
        const PlateResult result = run_plate(c, plate, dt, 35e-3, 40e-3);
        const std::string name =
          "no-slip walls, " + std::string(i == 0 ? "1" : "0.5") + " mm, ";
        check(name + "leak", std::abs(result.leak) < 0.1e-3, result.leak);
        // The fluid that the plate drives along a wall is that of the first
        // free nodes, which cannot turn: the plate is clamped up to there.
        const double dry = dry_deflection(plate, 0, 0.8 * dt);
        check(name + "deflection between clamped at the wall and a cell away",
              result.deflection < dry &&
                result.deflection > dry_deflection(plate, plate.cell, 0.8 * dt),
              result.deflection);
        stiffening[i] = 1 - result.deflection / dry;
      }
    check("no-slip walls, stiffening of first order",
          stiffening[1] < 0.6 * stiffening[0],
          stiffening[1] / stiffening[0]);
  }

  /** A rigid straight plate in a short channel without friction. */
  Plate
  rigid_plate()
  {
    Plate plate;
    plate.length = 20e-3;
    plate.height = 6e-3;
    plate.x      = 10.13e-3;
    plate.tilt   = 0;
    plate.bow    = 0;
    plate.ramp   = 5e-3;
    plate.rigid  = true;
    plate.wall   = FluidBoundary::slip;
    return plate;
  }

  void
  drag_only()
  {
    const Plate plate = rigid_plate();
    for (const bool multiplier : {false, true})
      {
        CoupledCase<2> c(plate.setup());
        RelaxationCoefficients k =
          relaxation_coefficients(1060, 1060, 20e-6, 0.5);
        if (!multiplier)
          k.stiffness = 0;
        while (c.integrator.time() < 15e-3)
          c.step(10e-6, &k);
        const double velocity = c.flow(1) / plate.height;
        // Darcy's law for the plate, and the impedance of both ends.
        const double expected = plate.pressure /
          (k.drag * plate.thickness + 2 * plate.impedance * 1060 * 50);
        if (multiplier)
          check("drag and multiplier, tight",
                std::abs(velocity) < 1e-4 * expected,
                velocity);
        else
          check_relative("drag only, leak", velocity, expected, 0.03);
      }
  }

  /** Volume that has passed through the plate until the multiplier carries
   * the pressure, over the area of the channel (m). */
  double
  leaked(const double tau)
  {
    const Plate plate = rigid_plate();
    CoupledCase<2> c(plate.setup());
    const RelaxationCoefficients k =
      relaxation_coefficients(1060, 1060, tau, 0.5);
    double volume = 0;
    while (c.integrator.time() < 15e-3)
      {
        c.step(10e-6, &k);
        volume += 10e-6 * c.flow(1);
      }
    return volume / plate.height;
  }

  void
  relaxation_time()
  {
    const double a = leaked(20e-6), b = leaked(40e-6), c = leaked(80e-6);
    // Differences, since the fluid within the plate is compressed too.
    const double order = std::log2((c - b) / (b - a));
    check("slip, second order in the relaxation time",
          order > 1.9 && order < 2.1,
          order);
    const double factor =
      (c - b) / (16e3 / 1e-3 * (6400e-12 - 1600e-12) / 1060);
    check("slip over (p/th) tau^2/rho", factor > 0.9 && factor < 1.5, factor);
  }

  /** Leak (m/s) past the lower end of the plate, which is held @p gap cells
   * above a wall of the given kind. */
  double
  leak_past_hinge(const FluidBoundary wall, const double gap)
  {
    Plate plate;
    plate.wall = wall;
    plate.gap  = gap * plate.cell;
    CoupledCase<2> c(plate.setup());
    const double dt = 0.5 * c.smaller_limit();
    return run_plate(c, plate, dt, 30e-3, 40e-3).leak;
  }

  /** A path is shut only where each of its nodes is held by the plate or the
   * wall. Nodes on the wall itself are held if the fluid rests there, so that
   * a cell more is tight. */
  void
  hinge()
  {
    struct Case
    {
      FluidBoundary wall;
      double gap; // cells
      double least, largest;
    };
    const double tight = 0.1e-3;
    for (const Case &c : {Case{FluidBoundary::slip, 0, -tight, tight},
                          Case{FluidBoundary::slip, 0.5, -tight, tight},
                          Case{FluidBoundary::slip, 1, 0.1, 0.17},
                          Case{FluidBoundary::slip, 2, 0.22, 0.34},
                          Case{FluidBoundary::no_slip, 0, -tight, tight},
                          Case{FluidBoundary::no_slip, 0.5, -tight, tight},
                          Case{FluidBoundary::no_slip, 1, -tight, tight},
                          Case{FluidBoundary::no_slip, 2, 0.16, 0.26}})
      {
        const double leak = leak_past_hinge(c.wall, c.gap);
        check("hinge " + std::to_string(static_cast<int>(10 * c.gap)) +
                " tenths of a cell from a " +
                (c.wall == FluidBoundary::slip ? "slip" : "no-slip") +
                " wall, " + (c.largest > tight ? "leaks" : "tight"),
              leak > c.least && leak < c.largest,
              leak);
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  slip_walls();
  no_slip_walls();
  drag_only();
  relaxation_time();
  hinge();
}
