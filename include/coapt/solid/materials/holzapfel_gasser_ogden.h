#ifndef coapt_solid_materials_holzapfel_gasser_ogden_h
#define coapt_solid_materials_holzapfel_gasser_ogden_h

#include <coapt/solid/materials/volume_change.h>
#include <coapt/solid/small_matrix.h>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Fibre-reinforced leaflet tissue with one dispersed fibre family (Gasser,
   * Ogden and Holzapfel, 2006; thesis of Khaledian, 2023, equations 5.4-5.6)
   *   W = C10 (I1 - 3) + K1/(2 K2) [exp(K2 <E>^2) - 1] + volumetric energy,
   *   E = kappa (I1 - 3) + (1 - 3 kappa) (I4 - 1)
   * with the isochoric invariants I1 and I4 and the positive part <E>. The
   * stress dW/dE is continued by its tangent beyond E = exponential_limit,
   * lest a brief overshoot demand an absurdly small time step. Stresses are
   * per reference area (Pa), energies per reference volume (Pa).
   */
  struct HolzapfelGasserOgden
  {
    double C10               = 2272; ///< matrix stiffness (Pa)
    double K1                = 4000; ///< fibre stiffness (Pa)
    double K2                = 150;  ///< fibre exponent
    double kappa             = 0.25; ///< dispersion, 0 (none) to 1/3
    double exponential_limit = 0.25; ///< value of E
    double bulk_factor       = 200;  ///< bulk modulus over 2 C10

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

    /**
     * Energy density at the elastic deformation gradient @p F; @p fibre holds
     * the three components of the unit fibre vector in the reference.
     */
    template <typename Number>
    Number
    energy(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      const State<Number> s(*this, F, fibre);
      const Number exponent = K2 * s.E_exponential * s.E_exponential;
      return C10 * (s.iso.value * s.I1 - 3.) +
        K1 / (2 * K2) * (exponential(exponent) - 1.) +
        (s.S_limit + s.dS * s.excess / 2.) * s.excess + volume().energy(s.J);
    }

    /** First Piola-Kirchhoff stress, the derivative of energy() to @p F. */
    template <typename Number>
    SmallMatrix<3, Number>
    first_piola(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      const State<Number> s(*this, F, fibre);
      const Number W1      = C10 + kappa * s.S;
      const Number W4      = (1 - 3 * kappa) * s.S;
      const Number matrix  = 2. * s.iso.value * W1;
      const Number fibrous = 2. * s.iso.value * W4;
      const Number pressure =
        volume().pressure(s.J) + s.iso.derivative * (W1 * s.I1 + W4 * s.I4);
      SmallMatrix<3, Number> P;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          P[i][j] = matrix * F[i][j] + fibrous * s.Fa[i] * fibre[j] +
            pressure * s.cofactor[i][j];
      return P;
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
      const State<Number> s(*this, F, fibre);
      const Number bounded = at_least(s.J, smallest_jacobian);
      const Number inverse = 1. / bounded;
      const Number third =
        s.iso.value * (kappa * s.I1 + (1 - 3 * kappa) * s.I4) / 3.;
      Number spatial{}, stretched{}, along{};
      for (int a = 0; a < 4; ++a)
        {
          Number g[3], Fg[3];
          multiply(s.cofactor, gradients[a], g);
          multiply(F, gradients[a], Fg);
          Number fibre_part{};
          for (int i = 0; i < 3; ++i)
            fibre_part += fibre[i] * gradients[a][i];
          for (int i = 0; i < 3; ++i)
            {
              g[i] *= inverse;
              const Number Hg = s.iso.value *
                  (kappa * Fg[i] + (1 - 3 * kappa) * fibre_part * s.Fa[i]) -
                third * g[i];
              spatial += g[i] * g[i];
              stretched += Hg * Hg;
            }
          along += fibre_part * fibre_part;
        }
      const Number fibre_tangent = s.S > 0 ? s.dS : Number{};
      return (volume().tangent(s.J) * bounded * bounded +
              (8. / 9.) * (C10 + kappa * s.S) * s.iso.value * s.I1) *
        spatial +
        4. * fibre_tangent * stretched +
        2. * (1 - 3 * kappa) * s.S * s.iso.value * along;
    }

  private:
    VolumetricEnergy
    volume() const
    {
      return {bulk_modulus()};
    }

    /** What energy, stress and stiffness have in common. */
    template <typename Number>
    struct State
    {
      State(const HolzapfelGasserOgden &m,
            const SmallMatrix<3, Number> &F,
            const Number *fibre)
        : cofactor(cofactors(F))
        , J(determinant(F, cofactor))
        , iso(J)
        , I1(square_norm(F))
      {
        multiply(F, fibre, Fa);
        I4             = Fa[0] * Fa[0] + Fa[1] * Fa[1] + Fa[2] * Fa[2];
        const Number E = m.kappa * (iso.value * I1 - 3.) +
          (1 - 3 * m.kappa) * (iso.value * I4 - 1.);
        const Number positive = at_least(E, 0);
        E_exponential         = at_most(positive, m.exponential_limit);
        excess                = positive - E_exponential;
        const Number exponent = m.K2 * E_exponential * E_exponential;
        const Number stiff    = m.K1 * exponential(exponent);
        S_limit               = stiff * E_exponential;
        dS                    = stiff * (1. + 2. * exponent);
        S                     = S_limit + dS * excess;
      }

      SmallMatrix<3, Number> cofactor;
      Number J;
      IsochoricFactor<Number> iso;
      Number I1, I4, Fa[3];
      /** E in the exponential range and beyond it; dW/dE at its end, the
       * slope of dW/dE, and dW/dE (Pa). */
      Number E_exponential, excess, S_limit, dS, S;
    };
  };
} // namespace coapt

#endif
