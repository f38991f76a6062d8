#ifndef coapt_contact_contact_law_h
#define coapt_contact_contact_law_h

#include <coapt/contact/contact_parameters.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  /** A column and a point of another part of the mid-surface. */
  struct ContactPair
  {
    double gap = 0;                         // distance minus thickness, m
    dealii::Tensor<1, 3> normal;            // unit, from column to partner
    dealii::Tensor<1, 3> relative_velocity; // partner minus column, m/s
    double area         = 0;                // of the column, m^2
    double reduced_mass = 0;                // kg
  };

  /** Impulse on the partner (N s); the column receives the opposite. */
  struct ContactImpulse
  {
    double normal = 0; // along the normal, >= 0
    dealii::Tensor<1, 3> tangential;
  };

  /**
   * Impulse of one of two passes over a pair during a time step @p dt (s):
   *
   *   f = A/2 (k (g0 - g) - c v_n) >= 0,   f_t <= mu f against the slip,
   *
   * with clearance g0, damping c = 2 zeta sqrt(k m/A) for reduced mass m, and
   * k the given @p stiffness (Pa/m) but never above factor m/(A dt^2), which
   * keeps the explicit update of the velocity stable for any step and any
   * mesh. Penetration counts up to half a thickness, so that sheets that have
   * crossed are not shot apart. Friction never does more than to stop its half
   * of the slip, so both passes together bring the pair to rest and take
   * energy away only (Wriggers 2006, ch. 5 and 10, for penalty and Coulomb's
   * law).
   */
  inline ContactImpulse
  contact_impulse(const ContactPair &pair,
                  const ContactParameters &parameters,
                  const double stiffness,
                  const double thickness,
                  const double dt)
  {
    ContactImpulse impulse;
    const double penetration = std::min(parameters.clearance - pair.gap,
                                        parameters.clearance + 0.5 * thickness);
    if (penetration <= 0 || !(pair.reduced_mass > 0))
      return impulse;

    const double mass_per_area = pair.reduced_mass / pair.area;
    const double k =
      std::min(stiffness,
               parameters.stiffness_factor * mass_per_area / (dt * dt));
    const double c  = 2 * parameters.damping * std::sqrt(k * mass_per_area);
    const double vn = pair.relative_velocity * pair.normal;
    impulse.normal =
      std::max(0., 0.5 * pair.area * (k * penetration - c * vn) * dt);

    const dealii::Tensor<1, 3> slip = pair.relative_velocity - vn * pair.normal;
    const double speed              = slip.norm();
    if (speed > 0)
      impulse.tangential =
        -std::min(parameters.friction * impulse.normal / speed,
                  0.5 * pair.reduced_mass) *
        slip;
    return impulse;
  }
} // namespace coapt

#endif
