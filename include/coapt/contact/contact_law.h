#ifndef coapt_contact_contact_law_h
#define coapt_contact_contact_law_h

#include <coapt/contact/pressure_law.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  /** How two surfaces answer to an approach by the law of contact. */
  struct ContactResponse
  {
    double pressure = 0; // Pa, >= 0
    double slope    = 0; // of the law, Pa/m
  };

  /**
   * Pressure between surfaces during a time step @p dt (s):
   *
   *   p = p(g0 - g) - c v_n >= 0
   *
   * with @p gap g and clearance g0 (m), the pressure law p(.), the normal
   * velocity v_n at which the surfaces part (@p opening, m/s), and damping
   * c = 2 zeta sqrt(k m) for the reduced mass m of both sides (@p areal_mass,
   * kg/m^2) and the slope k of the law, which never exceeds the given
   * @p stiffness (Pa/m) nor factor m/dt^2: this keeps the explicit update of
   * the velocity stable for any step and any mesh. Penetration below the
   * surface counts up to @p depth (m), so that bodies that have crossed are not
   * shot apart.
   */
  inline ContactResponse
  contact_pressure(const double gap,
                   const double opening,
                   const double areal_mass,
                   const ContactParameters &parameters,
                   const PressureLaw &law,
                   const double stiffness,
                   const double depth,
                   const double dt)
  {
    const double penetration =
      std::min(parameters.clearance - gap, parameters.clearance + depth);
    if (penetration <= 0 || !(areal_mass > 0))
      return {};
    const double largest =
      std::min(stiffness, parameters.stiffness_factor * areal_mass / (dt * dt));
    const auto value = law(penetration, largest);
    const double c =
      2 * parameters.damping * std::sqrt(value.slope * areal_mass);
    return {std::max(0., value.pressure - c * opening), value.slope};
  }



  /**
   * The history of friction of a point of a surface: how far its partner has
   * moved along the surface since it began to stick (m). It is carried by the
   * point and turned with the normal, so it does not notice when the partner
   * goes from one facet to the next.
   */
  template <int dim>
  struct ElasticSlip
  {
    dealii::Tensor<1, dim> slip;
    dealii::Tensor<1, dim> normal; // zero before the first contact

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &slip &normal;
    }

    /** Turns it by the vector @p angle (rad), with which the surfaces have spun
     * since, about the normal above all: turn() would not notice that. */
    void
    spin(const dealii::Tensor<1, 3> &angle)
    {
      static_assert(dim == 3, "In 2D nothing spins about the normal.");
      const double length = slip.norm();
      slip +=
        cross_product_3d(angle, slip + 0.5 * cross_product_3d(angle, slip));
      const double turned = slip.norm();
      if (turned > 0)
        slip *= length / turned;
    }

    /** Turns the slip into the plane of the new @p unit_normal. */
    void
    turn(const dealii::Tensor<1, dim> &unit_normal)
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
   * Shear (Pa) that pulls a point after its partner, which moves along the
   * surface with the @p unit_normal at @p velocity (m/s): Coulomb's law,
   * regularised by a spring of the stiffness r k on the slip s since sticking
   * began, with the damping of contact_pressure() and the same bound by
   * @p areal_mass; where it would exceed mu p
   * it is cut to that, and s with it (return mapping; Wriggers 2006, ch. 5 and
   * 10). @p history is brought up to date.
   */
  template <int dim>
  dealii::Tensor<1, dim>
  contact_shear(const ContactResponse &response,
                const dealii::Tensor<1, dim> &unit_normal,
                const dealii::Tensor<1, dim> &velocity,
                const double areal_mass,
                const ContactParameters &parameters,
                const double dt,
                ElasticSlip<dim> &history)
  {
    const double spring =
      std::min(parameters.stick_stiffness * response.slope,
               parameters.stiffness_factor * areal_mass / (dt * dt));
    const double dashpot =
      2 * parameters.damping * std::sqrt(spring * areal_mass);
    history.turn(unit_normal);
    history.slip += dt * velocity;
    dealii::Tensor<1, dim> shear = spring * history.slip + dashpot * velocity;
    const double magnitude       = shear.norm();
    const double bound           = parameters.friction * response.pressure;
    if (magnitude > bound)
      {
        shear *= bound / magnitude;
        history.slip = shear / spring;
      }
    return shear;
  }
} // namespace coapt

#endif
