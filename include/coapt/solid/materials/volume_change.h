#ifndef coapt_solid_materials_volume_change_h
#define coapt_solid_materials_volume_change_h

#include <coapt/solid/batch.h>

namespace coapt
{
  /**
   * Below this ratio of volumes all functions of J are continued by their
   * tangent (their energies by a parabola), so that a crushed or inverted
   * cell has a finite restoring force.
   */
  constexpr double smallest_jacobian = 0.1;

  /**
   * The factor J^(-2/3) that makes a quadratic invariant of the deformation
   * gradient independent of the volume, and its derivative with respect to J.
   */
  template <typename Number>
  struct IsochoricFactor
  {
    explicit IsochoricFactor(const Number &J)
    {
      const Number bounded = at_least(J, smallest_jacobian);
      const Number root    = cube_root(bounded);
      value                = 1. / (root * root);
      derivative           = (-2. / 3.) * value / bounded;
      value += derivative * (J - bounded);
    }

    Number value, derivative;
  };

  /**
   * Volumetric energy K/2 [(J^2 - 1)/2 - ln J] per reference volume (thesis
   * of Khaledian, 2023, equation 5.4, with K = 2/D).
   */
  struct VolumetricEnergy
  {
    double bulk_modulus; ///< K (Pa)

    /** Energy density (Pa) at the ratio of volumes @p J. */
    template <typename Number>
    Number
    energy(const Number &J) const
    {
      const Number b      = at_least(J, smallest_jacobian);
      const Number excess = J - b;
      return bulk_modulus / 2 * ((b * b - 1.) / 2. - logarithm(b)) +
        (pressure(b) + tangent(b) * excess / 2.) * excess;
    }

    /** Derivative of the energy, K/2 (J - 1/J) (Pa), positive in tension. */
    template <typename Number>
    Number
    pressure(const Number &J) const
    {
      const Number b       = at_least(J, smallest_jacobian);
      const Number inverse = 1. / b;
      return bulk_modulus / 2 *
        (b - inverse + (1. + inverse * inverse) * (J - b));
    }

    /** Second derivative of the energy, K/2 (1 + 1/J^2) (Pa). */
    template <typename Number>
    Number
    tangent(const Number &J) const
    {
      const Number b = at_least(J, smallest_jacobian);
      return bulk_modulus / 2 * (1. + 1. / (b * b));
    }

    /**
     * Bound of the second derivative of the energy to the spatial gradient L
     * of unit norm (Pa): energy'' J^2 (tr L)^2 + energy' J ((tr L)^2 -
     * tr(L L)), the second term of which is between -1 and 2 times energy' J.
     */
    template <typename Number>
    Number
    stiffness(const Number &J) const
    {
      const Number b = at_least(J, smallest_jacobian);
      const Number p = pressure(J);
      return (tangent(J) * b + (p < 0 ? -p : 2. * p)) * b;
    }
  };
} // namespace coapt

#endif
