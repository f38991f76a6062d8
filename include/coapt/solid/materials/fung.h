#ifndef coapt_solid_materials_fung_h
#define coapt_solid_materials_fung_h

#include <coapt/solid/materials/limited_exponential.h>
#include <coapt/solid/materials/material_defaults.h>
#include <coapt/solid/materials/node_gradients.h>
#include <coapt/solid/materials/volume_change.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Generalised Fung solid (Fung, Fronek and Patitucci, 1979; thesis of
   * Khaledian, 2023, equations 5.1-5.3)
   *   W = c/2 (exp Q - 1) + C10 (I1 - 3) + volumetric energy,
   *   Q = E_ij b_ijkl E_kl
   * with the isochoric Green strain E in the axes fibre (1), across it in the
   * tangent plane (2) and normal (3), and the tensor b with all its symmetries:
   * 21 constants, or 6 if it is planar, without components along the normal.
   * The published law has no C10; without it, a planar b resists no transverse
   * shear. exp Q is continued by a parabola beyond exponential_limit. Stresses
   * are per reference area (Pa), energies per reference volume (Pa).
   */
  struct Fung : MaterialDefaults
  {
    static constexpr const char *name = "Fung";
    static constexpr bool is_spatial  = true;
    static constexpr bool has_fibres  = true;

    double c = 2000; ///< stiffness (Pa)

    /** Upper triangle of b by rows: of 6 rows in the order 11, 22, 33, 12, 13,
     * 23 (21 numbers) or of 3 rows in the order 11, 22, 12 (6 numbers). */
    std::vector<double> b = {12, 4, 0, 8, 0, 4};

    double C10               = 0;   ///< stiffness of a matrix (Pa)
    double exponential_limit = 10;  ///< value of Q
    double bulk              = 9e5; ///< bulk modulus (Pa)

    /** Declares the parameters in a subsection of their own. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError as check(). */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /**
     * @throws InputError if a parameter is outside of its range, or b has a
     * negative eigenvalue, with which the energy would be negative.
     */
    void
    check() const;

    /** Bulk modulus (Pa). */
    double
    bulk_modulus() const
    {
      return bulk;
    }

    /** Cells need all three directions. */
    bool
    needs_normal() const
    {
      return true;
    }

    /** Q over the limit of the exponential. */
    double
    strain_ratio(const SmallMatrix<3, double> &F, const double *fibre) const
    {
      return State<double>(*this, F, fibre).Q / exponential_limit;
    }

    /**
     * Energy density at the elastic deformation gradient @p F; @p fibre holds
     * the three axes in the reference, one after the other.
     */
    template <typename Number>
    Number
    energy(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      const State<Number> s(*this, F, fibre);
      return c / 2 * s.growth.value + C10 * (s.iso.value * s.I1 - 3.) +
        volume().energy(s.J);
    }

    /** First Piola-Kirchhoff stress, the derivative of energy() to @p F. */
    template <typename Number>
    SmallMatrix<3, Number>
    first_piola(const SmallMatrix<3, Number> &F, const Number *fibre) const
    {
      const State<Number> s(*this, F, fibre);
      const Number stiff = c * s.growth.first;
      const Number pressure =
        volume().pressure(s.J) + s.iso.derivative * (C10 * s.I1 + stiff * s.SC);
      SmallMatrix<3, Number> P;
      for (int i = 0; i < 3; ++i)
        {
          Number FS[3]; // row i of F S in the axes
          for (int l = 0; l < 3; ++l)
            FS[l] = stiff * s.iso.value *
              (s.axis[0][i] * s.S[0][l] + s.axis[1][i] * s.S[1][l] +
               s.axis[2][i] * s.S[2][l]);
          for (int j = 0; j < 3; ++j)
            P[i][j] = FS[0] * fibre[j] + FS[1] * fibre[3 + j] +
              FS[2] * fibre[6 + j] + 2 * C10 * s.iso.value * F[i][j] +
              pressure * s.cofactor[i][j];
        }
      return P;
    }

    /**
     * Bound of the element's stiffness as for HolzapfelGasserOgden: with the
     * factors of b = sum_k r_k (x) r_k, the second derivative of Q has a term
     * for each r_k : E, to which the exponential adds that of Q.
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
      Number components[4][3]; // of the reference gradients in the axes
      for (int a = 0; a < 4; ++a)
        for (int k = 0; k < 3; ++k)
          components[a][k] = fibre[3 * k] * gradients[a][0] +
            fibre[3 * k + 1] * gradients[a][1] +
            fibre[3 * k + 2] * gradients[a][2];

      Number sum = 2. * s.growth.second * follow(s, nodes, components, s.S);
      const Matrix factor = cholesky(matrix());
      for (int k = 0; k < 6; ++k)
        {
          SmallMatrix<3, Number> R{};
          for (int l = 0; l < 6; ++l)
            R[first[l]][second[l]] = R[second[l]][first[l]] =
              Number{} + factor[6 * l + k];
          sum += s.growth.first * follow(s, nodes, components, R);
        }
      const Number spatial = nodes.square_sum();
      return c * sum + geometric(s, components, spatial) +
        (volume().stiffness(s.J) + (8. / 9.) * C10 * s.iso.value * s.I1) *
        spatial;
    }

  private:
    using Matrix = std::array<double, 36>;

    /** Row and column of the tensor's components in the order 11, 22, 33, 12,
     * 13, 23. */
    static constexpr int first[6]  = {0, 1, 2, 0, 0, 1};
    static constexpr int second[6] = {0, 1, 2, 1, 2, 2};

    /** b as a matrix of 6 rows, which acts on (E11, E22, E33, 2 E12, 2 E13,
     * 2 E23). */
    Matrix
    matrix() const
    {
      constexpr int planar[3] = {0, 1, 3};
      Matrix B{};
      const int n         = b.size() == 6 ? 3 : 6;
      unsigned int number = 0;
      for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j)
          {
            const int row    = n == 3 ? planar[i] : i;
            const int col    = n == 3 ? planar[j] : j;
            B[6 * row + col] = B[6 * col + row] = b[number++];
          }
      return B;
    }

    /**
     * Lower triangular R with B = R R^T for a @p B without negative
     * eigenvalues; otherwise some entries are NaN.
     */
    static Matrix
    cholesky(const Matrix &B);

    VolumetricEnergy
    volume() const
    {
      return {bulk};
    }

    /** What energy, stress and stiffness have in common. */
    template <typename Number>
    struct State
    {
      State(const Fung &m,
            const SmallMatrix<3, Number> &F,
            const Number *directions)
        : cofactor(cofactors(F))
        , J(determinant(F, cofactor))
        , iso(J)
        , I1(square_norm(F))
        , Q(exponent(m, F, directions))
        , growth(Q, m.exponential_limit)
      {
      }

      /** Q; sets the current axes, S and S : C. */
      Number
      exponent(const Fung &m,
               const SmallMatrix<3, Number> &F,
               const Number *directions)
      {
        for (int k = 0; k < 3; ++k)
          multiply(F, directions + 3 * k, axis[k]);
        Number C[6], E[6], sum{};
        for (int k = 0; k < 6; ++k)
          {
            const Number *x = axis[first[k]], *y = axis[second[k]];
            C[k] = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
            E[k] = k < 3 ? 0.5 * (iso.value * C[k] - 1.) : iso.value * C[k];
          }
        const Matrix B = m.matrix();
        SC             = Number{};
        for (int k = 0; k < 6; ++k)
          {
            Number product{};
            for (int l = 0; l < 6; ++l)
              product += B[6 * k + l] * E[l];
            S[first[k]][second[k]] = S[second[k]][first[k]] = product;
            sum += product * E[k];
            SC += (k < 3 ? 0.5 : 1.) * product * C[k];
          }
        return sum;
      }

      SmallMatrix<3, Number> cofactor;
      Number J;
      IsochoricFactor<Number> iso;
      Number I1;
      Number axis[3][3];        ///< F times each axis
      SmallMatrix<3, Number> S; ///< b : E in the axes
      Number SC;                ///< half of S : C, without J^(-2/3)
      Number Q;
      LimitedExponential<Number> growth;
    };

    /** F X g for a node with the components @p g in the axes. */
    template <typename Number>
    static void
    transform(const State<Number> &s,
              const SmallMatrix<3, Number> &X,
              const Number *g,
              Number *result)
    {
      Number Xg[3];
      multiply(X, g, Xg);
      for (int i = 0; i < 3; ++i)
        result[i] =
          s.axis[0][i] * Xg[0] + s.axis[1][i] * Xg[1] + s.axis[2][i] * Xg[2];
    }

    /** Sum over the nodes of |d(X : E)|^2. */
    template <typename Number>
    static Number
    follow(const State<Number> &s,
           const NodeGradients<Number> &nodes,
           const Number (&components)[4][3],
           const SmallMatrix<3, Number> &X)
    {
      Number value{}, linear[4][3], h[4][3];
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          for (int i = 0; i < 3; ++i)
            value += X[k][l] * s.axis[k][i] * s.axis[l][i];
      for (int a = 0; a < 4; ++a)
        transform(s, X, components[a], linear[a]);
      nodes.isochoric(s.iso.value, value, linear, h);
      return square_sum(h);
    }

    /**
     * Bound of the stress times the second derivative of the strain: with the
     * Kirchhoff stress t of Q and the spatial gradient L,
     * tr(L t L^T) - 4/3 tr L (t : L) + (2/9 (tr L)^2 + 1/3 tr(L L)) tr t.
     */
    template <typename Number>
    Number
    geometric(const State<Number> &s,
              const Number (&components)[4][3],
              const Number &spatial) const
    {
      const Number stiff = c * s.growth.first * s.iso.value;
      Number pulled{}, turned{};
      for (int a = 0; a < 4; ++a)
        {
          Number Sg[3], FSg[3];
          multiply(s.S, components[a], Sg);
          transform(s, s.S, components[a], FSg);
          for (int i = 0; i < 3; ++i)
            {
              pulled += components[a][i] * Sg[i];
              turned += FSg[i] * FSg[i];
            }
        }
      return stiff *
        (absolute(pulled) + (4. / 3.) * square_root(spatial * turned) +
         (10. / 9.) * absolute(s.SC) * spatial);
    }
  };
} // namespace coapt

#endif
