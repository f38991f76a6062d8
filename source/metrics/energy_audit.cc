#include <coapt/metrics/energy_audit.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  template <int dim>
  EnergyAudit<dim>::EnergyAudit(const CoupledSystem<dim> &system,
                                const FluidOperator<dim> &fluid,
                                const SolidOperator<dim> &solid,
                                const CouplingPoints<dim> &points)
    : system(system), fluid(fluid), solid(solid), points(points)
  {
  }



  template <int dim>
  typename EnergyAudit<dim>::Energies
  EnergyAudit<dim>::energies(const double *y) const
  {
    const auto &at              = system.layout();
    const std::vector<double> u = system.local_velocity(y);
    const std::vector<double> X = system.solid_positions(y);
    const std::vector<double> V = system.solid_velocities(y);

    Energies energies;
    energies.fluid_kinetic = fluid.kinetic_energy(y + at.velocity());
    energies.acoustic      = fluid.acoustic_energy(y + at.pressure());
    energies.solid_kinetic = solid.kinetic_energy(V.data());
    energies.elastic       = solid.elastic_energy(X.data());
    energies.multiplier    = points
                            .energy_and_power(system.relaxation(),
                                              u.data(),
                                              V.data(),
                                              y + at.multiplier())
                            .energy;
    return energies;
  }



  template <int dim>
  typename EnergyAudit<dim>::Powers
  EnergyAudit<dim>::powers(const double t, const double *y) const
  {
    const auto &at              = system.layout();
    const std::vector<double> u = system.local_velocity(y);
    const std::vector<double> V = system.solid_velocities(y);
    const FluidPowers flow      = fluid.powers(t, u.data(), y + at.pressure());

    // The impedance is a part of the end: what reaches the lumen is the
    // power of the pressure minus that lost in the impedance.
    Powers powers;
    powers.ends  = flow.ends;
    powers.loads = system.load_power(t, y);
    powers.fluid =
      flow.viscous + flow.hourglass + flow.checkerboard + flow.impedance;
    powers.solid        = solid.viscous_power(V.data());
    const auto coupling = points.energy_and_power(system.relaxation(),
                                                  u.data(),
                                                  V.data(),
                                                  y + at.multiplier());
    powers.slip         = coupling.dissipation;
    powers.multiplier   = coupling.energy;
    powers.stiffness    = system.relaxation().stiffness;
    return powers;
  }



  template <int dim>
  void
  EnergyAudit<dim>::sample(const double t, const double *y)
  {
    const Powers now = powers(t, y);
    if (started)
      {
        const double half = 0.5 * (t - last_time);
        works.ends += half * (last.ends + now.ends);
        works.loads += half * (last.loads + now.loads);
        works.fluid_losses += half * (last.fluid + now.fluid);
        works.solid_losses += half * (last.solid + now.solid);
        works.slip_losses += half * (last.slip + now.slip);
        // The multiplier stays when k changes, and lambda^2/(2 k) with it not.
        works.relaxation += 0.5 *
          (last.multiplier * (last.stiffness / now.stiffness - 1) +
           now.multiplier * (1 - now.stiffness / last.stiffness));
        largest_input = std::max(largest_input, std::abs(works.ends));
      }
    else
      initial = energies(y).total();
    started   = true;
    last_time = t;
    last      = now;
  }



  template <int dim>
  double
  EnergyAudit<dim>::relative_error(const double *y) const
  {
    if (!(largest_input > 0))
      return 0;
    const double input = works.ends + works.loads + works.contact +
      works.adaptation + works.relaxation;
    const double losses =
      works.fluid_losses + works.solid_losses + works.slip_losses;
    const double change = energies(y).total() - initial;
    return std::abs(input - losses - change) / largest_input;
  }



  template class EnergyAudit<2>;
  template class EnergyAudit<3>;
} // namespace coapt
