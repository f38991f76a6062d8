// A valve at rest under pressure: the annulus and the chordae carry the load.

#include <coapt/metrics/structure_monitor.h>
#include <coapt/structure/pressure_load.h>

#include "integrator.h"
#include "small_valve.h"
#include "tests.h"

using namespace coapt;
using dealii::Tensor;

namespace
{
  const double settled = 0.15;

  /** Brings a valve to rest; returns positions and velocities. */
  std::vector<double>
  state_at_rest(const ValveStructure &valve, StructureSystem &system)
  {
    CentralDifferences integrator = integrator_of(system);
    std::vector<double> state     = valve.reference_positions();
    const double omega            = valve.solid->step_bound(state.data()).omega;
    const double dt = 0.8 / std::hypot(omega, valve.chordae->max_frequency());
    state.resize(2 * state.size(), 0.);
    integrator.start(0., state);
    while (integrator.time() < settled)
      integrator.step(dt);
    return state;
  }

  /** Sum of the forces on all nodes. */
  Tensor<1, 3>
  total(const std::vector<double> &F)
  {
    Tensor<1, 3> sum;
    for (unsigned int i = 0; i < F.size(); ++i)
      sum[i % 3] += F[i];
    return sum;
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  StructureParameters structure;
  structure.in_blood     = false;
  structure.added_mass   = 0;
  structure.mass_damping = 160; // about critical for the slowest mode
  ValveStructure valve(small_valve("0,0\n0.02,500\n1,500\n"), MPI_COMM_WORLD);
  Timing timing;
  StructureSystem system(valve, structure, timing);
  const std::vector<double> state = state_at_rest(valve, system);
  const double *X                 = state.data();
  const std::vector<double> still(state.size() / 2, 0.);

  std::vector<double> pressure(still.size(), 0.), pull(still.size(), 0.);
  PressureLoad(valve.leaflet)
    .add_forces(valve.ventricular_pressure(settled), X, pressure.data(), 0, 1);
  valve.chordae->add_forces(settled, X, still.data(), pull.data(), 0, 1);
  const Tensor<1, 3> load = total(pressure), chordae = total(pull);
  StructureMonitor monitor(valve, system);
  const Tensor<1, 3> annulus = monitor.sample(settled, state).annulus_force;

  check("the load pushes towards the atrium", load[2] > 0.1, load[2]);
  check("the chordae hold a part of it",
        chordae[2] < -0.2 * load[2],
        chordae[2]);
  check("the annulus holds another part",
        annulus[2] > 0.1 * load[2],
        annulus[2]);
  for (unsigned int d = 0; d < 3; ++d)
    check(std::string("annulus and chordae hold the load along ") + "xyz"[d],
          std::abs(load[d] + chordae[d] - annulus[d]) < 1e-3 * load.norm(),
          load[d] + chordae[d] - annulus[d]);
}
