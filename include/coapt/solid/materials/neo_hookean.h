#ifndef coapt_solid_materials_neo_hookean_h
#define coapt_solid_materials_neo_hookean_h

#include <coapt/solid/materials/material_defaults.h>
#include <coapt/solid/materials/volume_change.h>
#include <coapt/solid/small_matrix.h>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Compressible neo-Hookean solid in plane strain or 3D (Simo and Pister,
   * 1984)
   *   W = mu/2 (F:F - dim - 2 ln J) + lambda/2 (ln J)^2.
   * Stresses are per reference area (Pa), energies per reference volume (Pa).
   */
  struct NeoHookean : MaterialDefaults
  {
    static constexpr const char *name = "neo-Hookean";

    double mu     = 4544;   ///< shear modulus (Pa)
    double lambda = 908800; ///< first Lame parameter (Pa)

    /** Declares the parameters in a subsection of their own. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError if a parameter is outside of its range. */
    void
    check() const;

    /** Energy density at the deformation gradient @p F; no fibres. */
    template <int dim, typename Number>
    Number
    energy(const SmallMatrix<dim, Number> &F, const Number *) const
    {
      const Number J      = determinant(F, cofactors(F));
      const Number b      = at_least(J, smallest_jacobian);
      const Number log_b  = logarithm(b);
      const Number excess = J - b;
      return mu / 2 * (square_norm(F) - double(dim)) +
        (lambda / 2 * log_b - mu) * log_b +
        (pressure(b) + tangent(b) * excess / 2.) * excess;
    }

    /** First Piola-Kirchhoff stress, the derivative of energy() to @p F. */
    template <int dim, typename Number>
    SmallMatrix<dim, Number>
    first_piola(const SmallMatrix<dim, Number> &F, const Number *) const
    {
      const SmallMatrix<dim, Number> C = cofactors(F);
      const Number p                   = pressure(determinant(F, C));
      SmallMatrix<dim, Number> P;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          P[i][j] = mu * F[i][j] + p * C[i][j];
      return P;
    }

    /**
     * Bound of the element's stiffness as for HolzapfelGasserOgden: the
     * largest curvatures of F:F, of the energy as a function of J, and of J
     * as a function of F, each in its own norm of the gradients.
     */
    template <int dim, typename Number>
    Number
    stiffness_bound(const SmallMatrix<dim, Number> &F,
                    const Number *,
                    const Number (&gradients)[dim + 1][dim]) const
    {
      const SmallMatrix<dim, Number> C = cofactors(F);
      const Number J                   = determinant(F, C);
      Number reference{}, area{};
      for (int a = 0; a <= dim; ++a)
        {
          Number g[dim];
          multiply(C, gradients[a], g);
          for (int i = 0; i < dim; ++i)
            {
              reference += gradients[a][i] * gradients[a][i];
              area += g[i] * g[i];
            }
        }
      const Number p         = pressure(J);
      const Number curvature = p < 0 ? -p : (dim - 1.) * p;
      return mu * reference +
        (tangent(J) + curvature / at_least(J, smallest_jacobian)) * area;
    }

  private:
    /** Derivative of the part of the energy that depends on J only. */
    template <typename Number>
    Number
    pressure(const Number &J) const
    {
      const Number b = at_least(J, smallest_jacobian);
      return (lambda * logarithm(b) - mu) / b + tangent(b) * (J - b);
    }

    /** Derivative of pressure(). */
    template <typename Number>
    Number
    tangent(const Number &J) const
    {
      const Number b = at_least(J, smallest_jacobian);
      return (lambda + mu - lambda * logarithm(b)) / (b * b);
    }
  };
} // namespace coapt

#endif
