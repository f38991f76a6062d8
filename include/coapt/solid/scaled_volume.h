#ifndef coapt_solid_scaled_volume_h
#define coapt_solid_scaled_volume_h

#include <coapt/solid/materials/volume_change.h>
#include <coapt/solid/small_matrix.h>

namespace coapt
{
  /**
   * A deformation gradient F that is scaled, r F with r = (A/J)^(1/dim), so
   * that its ratio of volumes is a mean A instead of J = det F, and what the
   * energy W(r F) means for F and A (de Souza Neto, Andrade Pires and Owen,
   * 2005, with another mean):
   *   dW = (r P - q/J cof F) : dF + q/A dA,   q = P : (r F)/dim.
   * Ratios below smallest_jacobian count as that.
   */
  template <int dim, typename Number>
  struct ScaledVolume
  {
    ScaledVolume(const SmallMatrix<dim, Number> &F, const Number &mean)
      : cofactor(cofactors(F)), J(determinant(F, cofactor)), mean(mean)
    {
      const Number ratio =
        at_least(mean, smallest_jacobian) / at_least(J, smallest_jacobian);
      if constexpr (dim == 2)
        factor = square_root(ratio);
      else
        factor = cube_root(ratio);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          gradient[i][j] = factor * F[i][j];
    }

    /** Turns the stress @p P = dW/d(r F) into the partial derivative to F, and
     * returns that to the mean. */
    Number
    pull_back(SmallMatrix<dim, Number> &P) const
    {
      Number q{};
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          q += P[i][j] * gradient[i][j] / double(dim);
      const Number own = J < smallest_jacobian ? Number{} : q / J;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          P[i][j] = factor * P[i][j] - own * cofactor[i][j];
      return mean < smallest_jacobian ? Number{} : q / mean;
    }

    SmallMatrix<dim, Number> cofactor;
    Number J, mean, factor;
    SmallMatrix<dim, Number> gradient; // r F
  };
} // namespace coapt

#endif
