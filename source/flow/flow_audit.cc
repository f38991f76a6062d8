#include <coapt/flow/flow_audit.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  template <int dim>
  FlowAudit<dim>::FlowAudit(const FlowModel<dim> &model) : model(model)
  {
  }



  template <int dim>
  typename FlowAudit<dim>::Energies
  FlowAudit<dim>::energies(const double *y) const
  {
    Energies energies;
    energies.fluid_kinetic = model.fluid().kinetic_energy(y);
    energies.acoustic      = model.fluid().acoustic_energy(model.pressure(y));
    return energies;
  }



  template <int dim>
  typename FlowAudit<dim>::Powers
  FlowAudit<dim>::powers(const double t, const double *y) const
  {
    Powers powers;
    powers.fluid = model.fluid().powers(t,
                                        model.local_velocity(y).data(),
                                        model.pressure(y));
    powers.driven_sides =
      model.fluid().driving_power(t, y, model.nodal_forces(t, y).data());
    return powers;
  }



  template <int dim>
  void
  FlowAudit<dim>::sample(const double t, const double *y)
  {
    const Powers now = powers(t, y);
    if (started)
      {
        works.add_fluid(t - last_time, last.fluid, now.fluid);
        works.driven_sides +=
          0.5 * (t - last_time) * (last.driven_sides + now.driven_sides);
        scale = std::max(scale, std::abs(works.input()));
      }
    else
      scale = initial = energies(y).total();
    started   = true;
    last_time = t;
    last      = now;
  }



  template <int dim>
  double
  FlowAudit<dim>::closure_error(const Energies &stored) const
  {
    return works.input() - works.losses() - (stored.total() - initial);
  }



  template <int dim>
  double
  FlowAudit<dim>::relative_error(const Energies &stored) const
  {
    return scale > 0 ? std::abs(closure_error(stored)) / scale : 0.;
  }

  template class FlowAudit<2>;
  template class FlowAudit<3>;
} // namespace coapt
