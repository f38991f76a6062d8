#ifndef coapt_solid_materials_may_newman_yin_h
#define coapt_solid_materials_may_newman_yin_h

#include <coapt/solid/materials/limited_exponential.h>
#include <coapt/solid/materials/material_defaults.h>
#include <coapt/solid/materials/node_gradients.h>
#include <coapt/solid/materials/volume_change.h>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Mitral leaflet tissue with one fibre family (May-Newman and Yin, 1998)
   *   W = c0 (exp Q - 1) + C10 (I1 - 3) + volumetric energy,
   *   Q = c1 (I1 - 3)^2 + c2 (sqrt(I4) - 1)^4
   * with isochoric I1 and I4; as published without C10, so slack in shear at
   * rest. A parabola continues exp Q beyond exponential_limit. Stresses are per
   * reference area, energies per volume (Pa). Defaults: anterior leaflet as
   * cited in later literature, not checked against the paper.
   */
  struct MayNewmanYin : MaterialDefaults
  {
    static constexpr const char *name = "May-Newman-Yin";
    static constexpr bool is_spatial  = true;
    static constexpr bool has_fibres  = true;

    double c0                = 399;    ///< stiffness (Pa)
    double c1                = 4.325;  ///< exponent of I1
    double c2                = 1446.5; ///< exponent of the fibre stretch
    double C10               = 0;      ///< stiffness of a matrix (Pa)
    double exponential_limit = 10;     ///< value of Q
    double bulk              = 9e5;    ///< bulk modulus (Pa)

    /** Declares the parameters in a subsection of their own. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError as check(). */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError if a parameter is outside of its range. */
    void
    check() const;

    /** Bulk modulus (Pa). */
    double
    bulk_modulus() const
    {
      return bulk;
    }

    /** Q over the limit of the exponential. */
    double
    strain_ratio(const SmallMatrix<3, double> &F, const double *fibre) const
    {
      return State<double>(*this, F, fibre).Q / exponential_limit;
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
      return c0 * s.growth.value + C10 * s.above_3 + volume().energy(s.J);
    }

    /** First Piola-Kirchhoff stress, the derivative of energy() to @p F. */
    template <typename Number>
    SmallMatrix<3, Number>
    first_piola(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      const State<Number> s(*this, F, fibre);
      const Number matrix  = 2. * s.iso.value * s.W1;
      const Number fibrous = 2. * s.iso.value * s.W4;
      const Number pressure =
        volume().pressure(s.J) + s.iso.derivative * (s.W1 * s.I1 + s.W4 * s.I4);
      SmallMatrix<3, Number> P;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          P[i][j] = matrix * F[i][j] + fibrous * s.Fa[i] * fibre[j] +
            pressure * s.cofactor[i][j];
      return P;
    }

    /**
     * Bound of the element's stiffness as for HolzapfelGasserOgden: besides
     * volume, matrix and geometric terms those of the two invariants in Q and
     * of Q itself, whose square the exponential adds.
     */
    template <typename Number>
    Number
    stiffness_bound(const SmallMatrix<3, Number> &F,
                    const Number *fibre,
                    const Number (&gradients)[4][3]) const
    {
      const State<Number> s(*this, F, fibre);
      const Number J = at_least(s.J, smallest_jacobian);
      const NodeGradients<Number> nodes(s.cofactor, J, gradients);
      Number Fg[4][3], fibrous[4][3], h1[4][3], h4[4][3], hQ[4][3], along{};
      for (int a = 0; a < 4; ++a)
        {
          multiply(F, gradients[a], Fg[a]);
          Number part{};
          for (int i = 0; i < 3; ++i)
            part += fibre[i] * gradients[a][i];
          along += part * part;
          for (int i = 0; i < 3; ++i)
            fibrous[a][i] = part * s.Fa[i];
        }
      nodes.isochoric(s.iso.value, s.I1, Fg, h1);
      nodes.isochoric(s.iso.value, s.I4, fibrous, h4);
      for (int a = 0; a < 4; ++a)
        for (int i = 0; i < 3; ++i)
          hQ[a][i] = s.Q1 * h1[a][i] + s.Q4 * h4[a][i];

      const Number spatial = nodes.square_sum();
      const Number geometric =
        absolute(s.W4) * fibre_curvature(along, spatial, s.I4);
      return (volume().stiffness(s.J) + (8. / 9.) * s.W1 * s.iso.value * s.I1) *
        spatial +
        4. * c0 *
        (s.growth.first *
           (2 * c1 * square_sum(h1) + at_least(s.Q44, 0) * square_sum(h4)) +
         s.growth.second * square_sum(hQ)) +
        2. * s.iso.value * geometric;
    }

  private:
    VolumetricEnergy
    volume() const
    {
      return {bulk};
    }

    /** What energy, stress and stiffness have in common. */
    template <typename Number>
    struct State
    {
      State(const MayNewmanYin &m,
            const SmallMatrix<3, Number> &F,
            const Number *fibre)
        : cofactor(cofactors(F))
        , J(determinant(F, cofactor))
        , iso(J)
        , I1(square_norm(F))
        , above_3(iso.value * I1 - 3.)
        , I4(square_of_fibre(F, fibre))
        , stretch(square_root(at_least(iso.value * I4, 1e-12)))
        , elongation(stretch - 1.)
        , Q(m.c1 * above_3 * above_3 +
            m.c2 * elongation * elongation * elongation * elongation)
        , growth(Q, m.exponential_limit)
      {
        const Number cube = elongation * elongation * elongation;
        Q1                = 2 * m.c1 * above_3;
        Q4                = 2 * m.c2 * cube / stretch;
        Q44 = m.c2 * elongation * elongation * (3. * stretch - elongation) /
          (stretch * stretch * stretch);
        W1 = m.C10 + m.c0 * growth.first * Q1;
        W4 = m.c0 * growth.first * Q4;
      }

      Number
      square_of_fibre(const SmallMatrix<3, Number> &F, const Number *fibre)
      {
        multiply(F, fibre, Fa);
        return Fa[0] * Fa[0] + Fa[1] * Fa[1] + Fa[2] * Fa[2];
      }

      SmallMatrix<3, Number> cofactor;
      Number J;
      IsochoricFactor<Number> iso;
      Number I1, above_3, Fa[3], I4, stretch, elongation, Q;
      LimitedExponential<Number> growth;
      /** Derivatives of Q and of the energy to the isochoric invariants. */
      Number Q1, Q4, Q44, W1, W4;
    };
  };
} // namespace coapt

#endif
