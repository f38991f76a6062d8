#ifndef coapt_solid_materials_tense_fibres_h
#define coapt_solid_materials_tense_fibres_h

#include <coapt/solid/materials/material_defaults.h>
#include <coapt/solid/small_matrix.h>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Fibres e under tension and nothing else,
   *   W = mu/2 |F e|^2,  P = mu F e (x) e,
   * which are at rest only where a fluid holds them (the ring of Roy, Heltai
   * and Costanzo, 2015). In plane strain or 3D; without resistance to shear
   * and to changes of volume. Stresses are per reference area (Pa), energies
   * per reference volume (Pa).
   */
  struct TenseFibres : MaterialDefaults
  {
    static constexpr const char *name = "tense fibres";
    static constexpr bool has_fibres  = true;

    double mu = 1; ///< tension at no stretch (Pa)

    /** Declares the parameters in a subsection of their own. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError if a parameter is outside of its range. */
    void
    check() const;

    /** Energy density at the deformation gradient @p F. */
    template <int dim, typename Number>
    Number
    energy(const SmallMatrix<dim, Number> &F, const Number *fibre) const
    {
      Number Fe[dim], sum{};
      multiply(F, fibre, Fe);
      for (int i = 0; i < dim; ++i)
        sum += Fe[i] * Fe[i];
      return mu / 2 * sum;
    }

    /** First Piola-Kirchhoff stress, the derivative of energy() to @p F. */
    template <int dim, typename Number>
    SmallMatrix<dim, Number>
    first_piola(const SmallMatrix<dim, Number> &F, const Number *fibre) const
    {
      Number Fe[dim];
      multiply(F, fibre, Fe);
      SmallMatrix<dim, Number> P;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          P[i][j] = mu * Fe[i] * fibre[j];
      return P;
    }

    /** Bound of the element's stiffness as for HolzapfelGasserOgden. */
    template <int dim, typename Number>
    Number
    stiffness_bound(const SmallMatrix<dim, Number> &,
                    const Number *fibre,
                    const Number (&gradients)[dim + 1][dim]) const
    {
      Number sum{};
      for (int a = 0; a <= dim; ++a)
        {
          Number along{};
          for (int i = 0; i < dim; ++i)
            along += fibre[i] * gradients[a][i];
          sum += along * along;
        }
      return mu * sum;
    }
  };
} // namespace coapt

#endif
