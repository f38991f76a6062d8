#ifndef coapt_solid_materials_ogden_h
#define coapt_solid_materials_ogden_h

#include <coapt/solid/materials/material_defaults.h>
#include <coapt/solid/materials/volume_change.h>
#include <coapt/solid/small_matrix.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Isotropic Ogden solid of any order in the isochoric principal stretches,
   *   W = sum_i w_i (l1^alpha_i + l2^alpha_i + l3^alpha_i - 3) + volumetric
   * with w_i = mu_i/alpha_i ("classical": Ogden, 1972; thesis of Khaledian,
   * 2023, equation 4.1) or w_i = 2 mu_i/alpha_i^2 ("Abaqus"). The default are
   * the coefficients of table 4.1 of that thesis, in the convention of the
   * program they were fitted with. Stresses are per reference area (Pa),
   * energies per reference volume (Pa).
   */
  struct Ogden : MaterialDefaults
  {
    static constexpr const char *name = "Ogden";
    static constexpr bool is_spatial  = true;

    std::string convention    = "Abaqus";                    ///< or "classical"
    std::vector<double> mu    = {0.002, 1010.038, 1230.418}; ///< (Pa)
    std::vector<double> alpha = {63.659, 9.471, 22.412};
    double bulk_factor        = 200; ///< bulk over shear modulus

    /** Declares the parameters in a subsection of their own. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError as check(). */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /**
     * @throws InputError if the lists differ in length, an exponent is zero,
     * or the initial shear modulus is not positive.
     */
    void
    check() const;

    /** Initial shear modulus (Pa), half the sum of w_i alpha_i^2. */
    double
    shear_modulus() const
    {
      double sum = 0;
      for (unsigned int i = 0; i < mu.size(); ++i)
        sum += weight(i) * alpha[i] * alpha[i] / 2;
      return sum;
    }

    /** Bulk modulus (Pa). */
    double
    bulk_modulus() const
    {
      return bulk_factor * shear_modulus();
    }

    /** Energy density at the deformation gradient @p F; no fibres. */
    template <typename Number>
    Number
    energy(const SmallMatrix<3, Number> &F, const Number *) const
    {
      const State<Number> s(F);
      Number W = VolumetricEnergy{bulk_modulus()}.energy(s.J);
      for (unsigned int i = 0; i < mu.size(); ++i)
        {
          Number sum = Number{} - 3.;
          for (int k = 0; k < 3; ++k)
            sum += exponential(alpha[i] * s.logarithm_of_stretch[k]);
          W += weight(i) * sum;
        }
      return W;
    }

    /** First Piola-Kirchhoff stress, the derivative of energy() to @p F. */
    template <typename Number>
    SmallMatrix<3, Number>
    first_piola(const SmallMatrix<3, Number> &F, const Number *) const
    {
      const State<Number> s(F);
      Number stress[3], slope[3];
      principal(s, stress, slope);
      const Number pressure = VolumetricEnergy{bulk_modulus()}.pressure(s.J) +
        (stress[0] + stress[1] + stress[2]) * s.iso.derivative /
          (2. * s.iso.value);
      SmallMatrix<3, Number> P;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          P[i][j] = pressure * s.cofactor[i][j];
      for (int k = 0; k < 3; ++k)
        {
          const Number n[3] = {s.directions[0][k],
                               s.directions[1][k],
                               s.directions[2][k]};
          Number Fn[3];
          multiply(F, n, Fn);
          const Number factor = stress[k] / s.square[k];
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              P[i][j] += factor * Fn[i] * n[j];
        }
      return P;
    }

    /**
     * Bound of the element's stiffness as for HolzapfelGasserOgden, from the
     * eigenvalues of the second derivative of the energy in the principal
     * frame (Ball, 1984: W_ij, and (W_i -+ W_j)/(l_i -+ l_j)).
     */
    template <typename Number>
    Number
    stiffness_bound(const SmallMatrix<3, Number> &F,
                    const Number *,
                    const Number (&gradients)[4][3]) const
    {
      const State<Number> s(F);
      Number reference{}, area{};
      for (int a = 0; a < 4; ++a)
        {
          Number g[3];
          multiply(s.cofactor, gradients[a], g);
          for (int i = 0; i < 3; ++i)
            {
              reference += gradients[a][i] * gradients[a][i];
              area += g[i] * g[i];
            }
        }
      return VolumetricEnergy{bulk_modulus()}.tangent(s.J) * area +
        largest_curvature(s) * reference;
    }

  private:
    /** The factor w_i (Pa) of the class's documentation. */
    double
    weight(const unsigned int i) const
    {
      return convention == "classical" ? mu[i] / alpha[i]
                                       : 2 * mu[i] / (alpha[i] * alpha[i]);
    }

    /** Stretches and directions of a deformation gradient. */
    template <typename Number>
    struct State
    {
      explicit State(const SmallMatrix<3, Number> &F)
        : cofactor(cofactors(F)), J(determinant(F, cofactor)), iso(J)
      {
        SmallMatrix<3, Number> C = right_cauchy_green(F);
        diagonalise(C, directions);
        for (int k = 0; k < 3; ++k)
          {
            square[k]               = at_least(C[k][k], 1e-6);
            logarithm_of_stretch[k] = 0.5 * logarithm(square[k] * iso.value);
          }
      }

      SmallMatrix<3, Number> cofactor;
      Number J;
      IsochoricFactor<Number> iso;
      SmallMatrix<3, Number> directions; ///< columns, in the reference
      Number square[3];                  ///< squares of the stretches
      Number logarithm_of_stretch[3];    ///< isochoric
    };

    /**
     * Derivatives of the isochoric energy with respect to the logarithm of
     * each isochoric stretch: first (@p stress) and second (@p slope).
     */
    template <typename Number>
    void
    principal(const State<Number> &s, Number *stress, Number *slope) const
    {
      for (int k = 0; k < 3; ++k)
        stress[k] = slope[k] = Number{};
      for (unsigned int i = 0; i < mu.size(); ++i)
        {
          const double factor = weight(i) * alpha[i];
          for (int k = 0; k < 3; ++k)
            {
              const Number term =
                factor * exponential(alpha[i] * s.logarithm_of_stretch[k]);
              stress[k] += term;
              slope[k] += alpha[i] * term;
            }
        }
    }

    /** Largest eigenvalue of the isochoric energy's second derivative. */
    template <typename Number>
    Number
    largest_curvature(const State<Number> &s) const
    {
      Number stress[3], slope[3], stretch[3], bound{};
      principal(s, stress, slope);
      const Number mean_stress = (stress[0] + stress[1] + stress[2]) / 3.;
      const Number mean_slope  = (slope[0] + slope[1] + slope[2]) / 3.;
      for (int k = 0; k < 3; ++k)
        {
          stretch[k] = square_root(s.square[k]);
          stress[k] -= mean_stress;
        }
      for (int i = 0; i < 3; ++i)
        {
          Number row{};
          for (int j = 0; j < 3; ++j)
            {
              Number W_ij = (mean_slope - slope[i] - slope[j]) / 3.;
              if (i == j)
                W_ij += slope[i] - stress[i];
              row += absolute(W_ij) / (stretch[i] * stretch[j]);
            }
          bound = larger(bound, row);

          const int j           = (i + 1) % 3;
          const Number gap      = s.square[i] - s.square[j];
          const Number sum      = s.square[i] + s.square[j];
          const auto same       = absolute(gap) < 1e-6 * sum;
          const Number quotient = same
            ? (slope[i] + slope[j]) / (2. * sum)
            : (stress[i] - stress[j]) / (same ? sum : gap);
          const Number mean =
            (stress[i] / stretch[i] + stress[j] / stretch[j]) /
            (stretch[i] + stretch[j]);
          bound = larger(bound, absolute(mean));
          bound = larger(bound, absolute(2. * quotient - mean));
        }
      return bound;
    }
  };
} // namespace coapt

#endif
