// The books of energy of made-up states of a channel: blood and a body in it
// move as one, whose works and losses are known.

#include <coapt/metrics/energy_audit.h>

#include "../coupled/coupled_case.h"

using namespace coapt;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Plate plate;
  plate.wall             = FluidBoundary::slip;
  const double impedance = 2e5, duration = plate.ramp;
  CoupledSetup<2> setup         = plate.setup();
  setup.boundaries.impedance[0] = setup.boundaries.impedance[1] = impedance;
  CoupledCase<2> c(setup);
  EnergyAudit<2> audit(c.system, c.fluid, c.solid, c.points);

  // From 0.1 to 0.3 m/s, while the pressure rises from zero.
  const double before = 0.1, after = 0.3;
  c.system.begin_step(1e-6);
  for (const double speed : {before, after})
    {
      c.set_velocity(
        [&](const auto &, const int d) { return d == 0 ? speed : 0.; });
      audit.sample(speed == before ? 0. : duration, c.y.data());
    }

  const auto works    = audit.work();
  const auto energies = audit.energies(c.y.data());
  const double blood  = setup.fluid.density * plate.length * plate.height,
               body   = setup.solid.density * plate.thickness * plate.height;
  check_relative("kinetic energy of the blood",
                 energies.fluid_kinetic,
                 0.5 * blood * after * after,
                 1e-9);
  check_relative("kinetic energy of the body",
                 energies.solid_kinetic,
                 0.5 * body * after * after,
                 1e-9);

  const double work = 0.5 * duration * plate.pressure * after * plate.height;
  const double lost = 0.5 * duration * 2 * impedance * plate.height *
    (before * before + after * after);
  check_relative("work of the pressure at the ends", works.ends, work, 1e-9);
  check_relative("loss in the impedance of both ends",
                 works.fluid.impedance,
                 lost,
                 1e-9);
  check_relative("nothing else is put in", works.input(), work, 1e-9);
  check_relative("nothing else is lost", works.losses(), lost, 1e-9);

  const double left =
    work - lost - 0.5 * (blood + body) * (after * after - before * before);
  check_relative("what is left over",
                 audit.closure_error(energies),
                 left,
                 1e-9);
  check_relative("relative to the work of the ends",
                 audit.relative_error(energies),
                 std::abs(left) / work,
                 1e-9);
  audit.add_adaptation(-left);
  check("closed by the work of an adaptation",
        std::abs(audit.closure_error(energies)) < 1e-9 * work,
        audit.closure_error(energies));

  const auto entries = EnergyAudit<2>::entries(audit.work(), energies);
  double sum         = 0;
  for (const auto &[name, value] : entries)
    sum += name.compare(0, 4, "work") == 0 ? value : -value;
  check_relative("entries of the table: works less losses and energies",
                 sum,
                 -0.5 * (blood + body) * before * before,
                 1e-9);
}
