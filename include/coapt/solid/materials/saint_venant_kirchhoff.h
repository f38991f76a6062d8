#ifndef coapt_solid_materials_saint_venant_kirchhoff_h
#define coapt_solid_materials_saint_venant_kirchhoff_h

#include <coapt/solid/materials/material_defaults.h>
#include <coapt/solid/small_matrix.h>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Linear law between the second Piola-Kirchhoff stress and the strain of
   * Green and Lagrange, E = (F^T F - 1)/2 (Turek and Hron, 2006),
   *   W = lambda/2 (tr E)^2 + mu E:E,
   * in plane strain or 3D. It has no energy barrier against inversion: it is
   * for large rotations with small strains. Stresses are per reference area
   * (Pa), energies per reference volume (Pa).
   */
  struct SaintVenantKirchhoff : MaterialDefaults
  {
    static constexpr const char *name = "St Venant-Kirchhoff";

    double mu     = 5e5; ///< shear modulus (Pa)
    double lambda = 2e6; ///< first Lame parameter (Pa)

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
      const SmallMatrix<dim, Number> E = strain(F);
      const Number sum                 = trace(E);
      return lambda / 2 * sum * sum + mu * square_norm(E);
    }

    /** First Piola-Kirchhoff stress F S, the derivative of energy() to F. */
    template <int dim, typename Number>
    SmallMatrix<dim, Number>
    first_piola(const SmallMatrix<dim, Number> &F, const Number *) const
    {
      const SmallMatrix<dim, Number> S = second_piola(F);
      SmallMatrix<dim, Number> P{};
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          for (int k = 0; k < dim; ++k)
            P[i][j] += F[i][k] * S[k][j];
      return P;
    }

    /**
     * Bound of the element's stiffness as for HolzapfelGasserOgden: with
     * w = F^T u, the strain of u (x) g is at most |w||g| in norm, its trace
     * w.g, and the stress adds S : (g (x) g) |u|^2. Norms of C and S are
     * bounded by sums of rows.
     */
    template <int dim, typename Number>
    Number
    stiffness_bound(const SmallMatrix<dim, Number> &F,
                    const Number *,
                    const Number (&gradients)[dim + 1][dim]) const
    {
      Number reference{};
      for (int a = 0; a <= dim; ++a)
        for (int i = 0; i < dim; ++i)
          reference += gradients[a][i] * gradients[a][i];
      return ((lambda + 2 * mu) * row_sum(right_cauchy_green(F)) +
              row_sum(second_piola(F))) *
        reference;
    }

  private:
    template <int dim, typename Number>
    static SmallMatrix<dim, Number>
    strain(const SmallMatrix<dim, Number> &F)
    {
      SmallMatrix<dim, Number> E = right_cauchy_green(F);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          E[i][j] = 0.5 * (E[i][j] - (i == j ? 1. : 0.));
      return E;
    }

    template <int dim, typename Number>
    static Number
    trace(const SmallMatrix<dim, Number> &A)
    {
      Number sum = A[0][0];
      for (int i = 1; i < dim; ++i)
        sum += A[i][i];
      return sum;
    }

    template <int dim, typename Number>
    SmallMatrix<dim, Number>
    second_piola(const SmallMatrix<dim, Number> &F) const
    {
      SmallMatrix<dim, Number> S = strain(F);
      const Number volumetric    = lambda * trace(S);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          {
            S[i][j] = 2 * mu * S[i][j];
            if (i == j)
              S[i][j] += volumetric;
          }
      return S;
    }

    /** The largest sum of absolute values of a row, which bounds the
     * spectral norm of a symmetric matrix. */
    template <int dim, typename Number>
    static Number
    row_sum(const SmallMatrix<dim, Number> &A)
    {
      Number result{};
      for (int i = 0; i < dim; ++i)
        {
          Number sum{};
          for (int j = 0; j < dim; ++j)
            sum += absolute(A[i][j]);
          result = larger(result, sum);
        }
      return result;
    }
  };
} // namespace coapt

#endif
