#ifndef coapt_solid_materials_holzapfel_gasser_ogden_h
#define coapt_solid_materials_holzapfel_gasser_ogden_h

#include <coapt/solid/materials/material_defaults.h>
#include <coapt/solid/materials/node_gradients.h>
#include <coapt/solid/materials/volume_change.h>
#include <coapt/solid/small_matrix.h>

#include <array>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Fibre-reinforced leaflet tissue with dispersed fibre families (Gasser,
   * Ogden and Holzapfel, 2006; thesis of Khaledian, 2023, equations 5.4-5.6)
   *   W = C10 (I1 - 3) + K1/(2 K2) sum_f [exp(K2 <E_f>^2) - 1]
   *       + volumetric energy,
   *   E_f = kappa (I1 - 3) + (1 - 3 kappa) (I4_f - 1)
   * with the isochoric invariants I1 and I4 and the positive part <E>: fibres
   * carry no compression. The families lie in the tangent plane of the leaflet,
   * at given angles to the fibre direction of the cell. The stress dW/dE is
   * continued by its tangent beyond E = exponential_limit, lest a brief
   * overshoot demand an absurdly small time step. Stresses are per reference
   * area (Pa), energies per reference volume (Pa).
   */
  struct HolzapfelGasserOgden : MaterialDefaults
  {
    static constexpr const char *name = "HGO";
    static constexpr bool is_spatial  = true;
    static constexpr bool has_fibres  = true;

    double C10               = 2272; ///< matrix stiffness (Pa)
    double K1                = 4000; ///< fibre stiffness (Pa)
    double K2                = 150;  ///< fibre exponent
    double kappa             = 0.25; ///< dispersion, 0 (none) to 1/3
    double exponential_limit = 0.25; ///< value of E
    double bulk_factor       = 200;  ///< bulk modulus over 2 C10

    /** Cosine and sine of the angle of each family to the fibre direction. */
    std::vector<std::array<double, 2>> families = {{{1., 0.}}};

    /** Declares the parameters in a subsection of their own. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError if kappa is outside [0, 1/3]. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError if a parameter is outside of its range. */
    void
    check() const;

    /** Bulk modulus (Pa). */
    double
    bulk_modulus() const
    {
      return bulk_factor * 2 * C10;
    }

    /** Whether a family is not along the fibre direction, so that cells need
     * their normal, too. */
    bool
    needs_normal() const
    {
      for (const auto &family : families)
        if (family[1] != 0)
          return true;
      return false;
    }

    /** Largest E of a family over the limit of the exponential. */
    double
    strain_ratio(const SmallMatrix<3, double> &F, const double *fibre) const
    {
      const State<double> s(F);
      double largest = 0;
      for (const auto &family : families)
        largest =
          larger(largest, Fibres<double>(*this, s, F, fibre, family).E());
      return largest / exponential_limit;
    }

    /**
     * Energy density at the elastic deformation gradient @p F; @p fibre holds
     * the three components of the unit fibre vector in the reference, and if
     * needs_normal(), those of the direction across it.
     */
    template <typename Number>
    Number
    energy(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      const State<Number> s(F);
      Number W = C10 * (s.iso.value * s.I1 - 3.) + volume().energy(s.J);
      for (const auto &family : families)
        W += Fibres<Number>(*this, s, F, fibre, family).energy(*this);
      return W;
    }

    /** First Piola-Kirchhoff stress, the derivative of energy() to @p F. */
    template <typename Number>
    SmallMatrix<3, Number>
    first_piola(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      // A loop that is known to run once keeps the sums in registers.
      return families.size() == 1 ? sum_of_stresses<1>(F, fibre)
                                  : sum_of_stresses<0>(F, fibre);
    }

    /**
     * Bound of sum_ab u_a . (dP/dF : u_b (x) g_b) g_a over all nodal vectors
     * u of unit norm, in Pa/m^2, for the four reference shape gradients
     * @p gradients [node][component] (1/m): sum of the bounds of the
     * volumetric, fibre, matrix and geometric terms.
     */
    template <typename Number>
    Number
    stiffness_bound(const SmallMatrix<3, Number> &F,
                    const Number *fibre,
                    const Number (&gradients)[4][3]) const
    {
      const State<Number> s(F);
      const NodeGradients<Number> nodes(s.cofactor,
                                        at_least(s.J, smallest_jacobian),
                                        gradients);
      const Number spatial = nodes.square_sum();
      Number Fg[4][3];
      for (int a = 0; a < 4; ++a)
        multiply(F, gradients[a], Fg[a]);

      Number W1 = Number{} + C10, bound{};
      for (const auto &family : families)
        {
          const Fibres<Number> f(*this, s, F, fibre, family);
          Number linear[4][3], h[4][3], along{};
          for (int a = 0; a < 4; ++a)
            {
              Number part{};
              for (int i = 0; i < 3; ++i)
                part += f.direction[i] * gradients[a][i];
              along += part * part;
              for (int i = 0; i < 3; ++i)
                linear[a][i] =
                  kappa * Fg[a][i] + (1 - 3 * kappa) * part * f.Fa[i];
            }
          const Number value = kappa * s.I1 + (1 - 3 * kappa) * f.I4;
          nodes.isochoric(s.iso.value, value, linear, h);
          const Number tangent = f.S > 0 ? f.dS : Number{};
          bound += 4. * tangent * square_sum(h) +
            2. * (1 - 3 * kappa) * f.S * s.iso.value *
              fibre_curvature(along, spatial, f.I4);
          W1 += kappa * f.S;
        }
      return (volume().stiffness(s.J) + (8. / 9.) * W1 * s.iso.value * s.I1) *
        spatial +
        bound;
    }

  private:
    /** Stress of the matrix and of all families; @p n_families is zero where
     * their number is known at run time only. */
    template <int n_families, typename Number>
    SmallMatrix<3, Number>
    sum_of_stresses(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      const unsigned int n = n_families > 0 ? n_families : families.size();
      const State<Number> s(F);
      SmallMatrix<3, Number> P{};
      Number W1 = Number{} + C10, W4_I4{};
      for (unsigned int k = 0; k < n; ++k)
        {
          const Fibres<Number> f(*this, s, F, fibre, families[k]);
          const Number W4      = (1 - 3 * kappa) * f.S;
          const Number fibrous = 2. * s.iso.value * W4;
          W1 += kappa * f.S;
          W4_I4 += W4 * f.I4;
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              P[i][j] += fibrous * f.Fa[i] * f.direction[j];
        }
      const Number matrix = 2. * s.iso.value * W1;
      const Number pressure =
        volume().pressure(s.J) + s.iso.derivative * (W1 * s.I1 + W4_I4);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          P[i][j] += matrix * F[i][j] + pressure * s.cofactor[i][j];
      return P;
    }

    VolumetricEnergy
    volume() const
    {
      return {bulk_modulus()};
    }

    /** What energy, stress and stiffness have in common. */
    template <typename Number>
    struct State
    {
      explicit State(const SmallMatrix<3, Number> &F)
        : cofactor(cofactors(F))
        , J(determinant(F, cofactor))
        , iso(J)
        , I1(square_norm(F))
      {
      }

      SmallMatrix<3, Number> cofactor;
      Number J;
      IsochoricFactor<Number> iso;
      Number I1;
    };

    /** One family: its direction, strain and stress. */
    template <typename Number>
    struct Fibres
    {
      Fibres(const HolzapfelGasserOgden &m,
             const State<Number> &s,
             const SmallMatrix<3, Number> &F,
             const Number *fibre,
             const std::array<double, 2> &family)
      {
        for (int i = 0; i < 3; ++i)
          direction[i] = fibre[i];
        if (family[1] != 0)
          for (int i = 0; i < 3; ++i)
            direction[i] = family[0] * fibre[i] + family[1] * fibre[3 + i];
        multiply(F, direction, Fa);
        I4               = Fa[0] * Fa[0] + Fa[1] * Fa[1] + Fa[2] * Fa[2];
        const Number all = m.kappa * (s.iso.value * s.I1 - 3.) +
          (1 - 3 * m.kappa) * (s.iso.value * I4 - 1.);
        const Number positive = at_least(all, 0);
        E_exponential         = at_most(positive, m.exponential_limit);
        excess                = positive - E_exponential;
        const Number exponent = m.K2 * E_exponential * E_exponential;
        power                 = exponential(exponent);
        const Number stiff    = m.K1 * power;
        S_limit               = stiff * E_exponential;
        dS                    = stiff * (1. + 2. * exponent);
        S                     = S_limit + dS * excess;
      }

      /** Positive part of the strain. */
      Number
      E() const
      {
        return E_exponential + excess;
      }

      /** Energy density (Pa). */
      Number
      energy(const HolzapfelGasserOgden &m) const
      {
        return m.K1 / (2 * m.K2) * (power - 1.) +
          (S_limit + dS * excess / 2.) * excess;
      }

      Number direction[3], Fa[3], I4;
      /** E in the exponential range and beyond it, the exponential, dW/dE at
       * the end of that range, the slope of dW/dE, and dW/dE (Pa). */
      Number E_exponential, excess, power, S_limit, dS, S;
    };
  };
} // namespace coapt

#endif
