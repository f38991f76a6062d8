// A fluid node to which more solid is coupled than its own mass, as where
// leaflets overlap or weights of held nodes go to the others: the bound of the
// ratio of masses is that of the integrator.

#include <coapt/immersion/immersion_parameters.h>
#include <coapt/time/explicit_integrator.h>

#include "tests.h"

using namespace coapt;

namespace
{
  /** Largest velocity after 300 steps of the node, whose own mass is 1 and
   * whose coupled mass @p ratio, and the solid, which differ by 1 at first. The
   * ratio of the densities is @p density_ratio. */
  double
  velocity_left(const double ratio, const double density_ratio)
  {
    const ImmersionParameters parameters;
    const double fluid_density = 1000., dt = 1e-6,
                 solid_density = density_ratio * fluid_density;
    const auto coefficients =
      relaxation_coefficients(solid_density,
                              fluid_density,
                              parameters.relaxation_steps * dt,
                              parameters.damping_ratio);
    // velocities of fluid and solid, multiplier
    std::vector<double> y = {0., 1., 0.};
    ExplicitIntegrator integrator(
      MPI_COMM_SELF,
      [&](double, const double *y, double *y_dot) {
        const double slip  = y[1] - y[0],
                     force = y[2] + coefficients.drag * slip;
        y_dot[0]           = ratio / solid_density * force;
        y_dot[1]           = -force / solid_density;
        y_dot[2]           = coefficients.stiffness * slip;
      },
      [](double, double *) {});
    integrator.start(0, y);
    for (unsigned int i = 0; i < 300; ++i)
      integrator.step(dt);
    return std::max(std::abs(y[0]), std::abs(y[1]));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double density_ratio : {1., 10.})
    {
      const double bound =
        ImmersionParameters().largest_mass_ratio(density_ratio);
      // where momentum puts both
      const double total = bound / (1 + bound);
      const double below = velocity_left(bound, density_ratio);
      check("both move alike", std::abs(below - total) < 1e-6, below - total);
      const double above = velocity_left(1.6 * bound, density_ratio);
      check("unstable far above", above > 1e3, above);
    }
}
