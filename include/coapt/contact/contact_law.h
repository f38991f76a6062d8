#ifndef coapt_contact_contact_law_h
#define coapt_contact_contact_law_h

#include <coapt/contact/pressure_law.h>

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
   * The history of friction of a column: how far its partner has moved along
   * the surface since it began to stick (m). It is carried by the column and
   * turned with the normal, so it does not notice when the partner goes from
   * one facet to the next.
   */
  struct ElasticSlip
  {
    dealii::Tensor<1, 3> slip;
    dealii::Tensor<1, 3> normal; // zero before the first contact

    /** Turns the slip into the plane of the new @p unit_normal. */
    void
    turn(const dealii::Tensor<1, 3> &unit_normal)
    {
      const double length = slip.norm();
      slip -= (slip * unit_normal) * unit_normal;
      const double rest = slip.norm();
      if (rest > 0)
        slip *= length / rest;
      normal = unit_normal;
    }
  };

  /**
   * Impulse of one of two passes over a pair during a time step @p dt (s):
   *
   *   f = A/2 (p(g0 - g) - c v_n) >= 0
   *
   * with clearance g0, the pressure law p, and damping c = 2 zeta
   * sqrt(k m/A) for reduced mass m and the slope k of the law, which never
   * exceeds the given @p stiffness (Pa/m) nor factor m/(A dt^2): this keeps
   * the explicit update of the velocity stable for any step and any mesh.
   * Penetration counts up to half a thickness, so that sheets that have
   * crossed are not shot apart.
   *
   * Friction is Coulomb's law, regularised by a spring of the stiffness
   * r k A/2 on the slip s since sticking began, with the same damping; where
   * the force would exceed mu f it is cut to that, and s with it (return
   * mapping; Wriggers 2006, ch. 5 and 10). @p history is brought up to date.
   */
  inline ContactImpulse
  contact_impulse(const ContactPair &pair,
                  const ContactParameters &parameters,
                  const PressureLaw &law,
                  const double stiffness,
                  const double thickness,
                  const double dt,
                  ElasticSlip &history)
  {
    ContactImpulse impulse;
    const double penetration = std::min(parameters.clearance - pair.gap,
                                        parameters.clearance + 0.5 * thickness);
    if (penetration <= 0 || !(pair.reduced_mass > 0))
      return impulse;

    const double mass_per_area = pair.reduced_mass / pair.area;
    const double largest =
      std::min(stiffness,
               parameters.stiffness_factor * mass_per_area / (dt * dt));
    const auto value = law(penetration, largest);
    const double c =
      2 * parameters.damping * std::sqrt(value.slope * mass_per_area);
    const double vn    = pair.relative_velocity * pair.normal;
    const double force = std::max(0., value.pressure - c * vn);
    impulse.normal     = 0.5 * pair.area * force * dt;

    // Per area, as the pressure.
    const dealii::Tensor<1, 3> velocity =
      pair.relative_velocity - vn * pair.normal;
    const double spring = parameters.stick_stiffness * value.slope;
    const double dashpot =
      2 * parameters.damping * std::sqrt(spring * mass_per_area);
    history.turn(pair.normal);
    history.slip += dt * velocity;
    dealii::Tensor<1, 3> shear = spring * history.slip + dashpot * velocity;
    const double magnitude = shear.norm(), bound = parameters.friction * force;
    if (magnitude > bound)
      {
        shear *= bound / magnitude;
        history.slip = shear / spring;
      }
    impulse.tangential = -0.5 * pair.area * dt * shear;
    return impulse;
  }
} // namespace coapt

#endif
