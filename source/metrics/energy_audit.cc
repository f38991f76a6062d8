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

    // The impedance is a part of the end: what reaches the lumen is the
    // power of the pressure minus that lost in the impedance.
    Powers powers;
    powers.fluid        = fluid.powers(t, u.data(), y + at.pressure());
    powers.driven_sides = system.driving_power(t, y);
    powers.loads        = system.load_power(t, y);
    powers.solid        = solid.viscous_power(V.data());
    const auto coupling = points.energy_and_power(system.relaxation(),
                                                  u.data(),
                                                  V.data(),
                                                  y + at.multiplier());
    powers.slip         = coupling.dissipation;
    powers.film         = system.sink_power(y);
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
        const auto add = [&](double &work, const double a, const double b) {
          work += 0.5 * (t - last_time) * (a + b);
        };
        works.add_fluid(t - last_time, last.fluid, now.fluid);
        add(works.driven_sides, last.driven_sides, now.driven_sides);
        add(works.loads, last.loads, now.loads);
        add(works.solid_losses, last.solid, now.solid);
        add(works.slip_losses, last.slip, now.slip);
        add(works.film_losses, last.film, now.film);
        // The multiplier stays when k changes, and lambda^2/(2 k) with it not.
        works.relaxation += 0.5 *
          (last.multiplier * (last.stiffness / now.stiffness - 1) +
           now.multiplier * (1 - now.stiffness / last.stiffness));
        works.contact = system.work_of_impulse();
        works.motion  = system.work_of_motion();
        largest_input =
          std::max(largest_input,
                   std::abs(works.ends + works.driven_sides + works.motion));
      }
    else
      initial = energies(y).total();
    started   = true;
    last_time = t;
    last      = now;
  }



  template <int dim>
  double
  EnergyAudit<dim>::closure_error(const Energies &stored) const
  {
    return works.input() - works.losses() - (stored.total() - initial);
  }



  template <int dim>
  double
  EnergyAudit<dim>::relative_error(const Energies &stored) const
  {
    return largest_input > 0 ? std::abs(closure_error(stored)) / largest_input
                             : 0.;
  }



  template <int dim>
  std::vector<std::pair<std::string, double>>
  EnergyAudit<dim>::entries(const Works &works, const Energies &energies)
  {
    return {{"work_of_ends_J", works.ends},
            {"work_of_driven_sides_J", works.driven_sides},
            {"work_of_loads_J", works.loads},
            {"work_of_contact_J", works.contact},
            {"work_of_motion_J", works.motion},
            {"work_of_adaptation_J", works.adaptation},
            {"work_of_relaxation_J", works.relaxation},
            {"losses_viscous_J", works.fluid.viscous},
            {"losses_artificial_J", works.fluid.artificial},
            {"losses_hourglass_J", works.fluid.hourglass},
            {"losses_checkerboard_J", works.fluid.checkerboard},
            {"losses_impedance_J", works.fluid.impedance},
            {"losses_solid_J", works.solid_losses},
            {"losses_slip_J", works.slip_losses},
            {"losses_film_J", works.film_losses},
            {"energy_kinetic_fluid_J", energies.fluid_kinetic},
            {"energy_acoustic_J", energies.acoustic},
            {"energy_kinetic_solid_J", energies.solid_kinetic},
            {"energy_elastic_J", energies.elastic},
            {"energy_multiplier_J", energies.multiplier}};
  }



  template class EnergyAudit<2>;
  template class EnergyAudit<3>;
} // namespace coapt
