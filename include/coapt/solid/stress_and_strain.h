#ifndef coapt_solid_stress_and_strain_h
#define coapt_solid_stress_and_strain_h

#include <coapt/solid/small_matrix.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  /** A deformation gradient in 3D; the strain of a 2D one is plane. */
  template <int dim>
  SmallMatrix<3, double>
  embed(const dealii::Tensor<2, dim> &F)
  {
    SmallMatrix<3, double> result{};
    result[2][2] = 1;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        result[i][j] = F[i][j];
    return result;
  }

  /** Cauchy stress (Pa) P F^T / J. */
  inline SmallMatrix<3, double>
  cauchy_stress(const SmallMatrix<3, double> &P,
                const SmallMatrix<3, double> &F)
  {
    const double J = determinant(F, cofactors(F));
    SmallMatrix<3, double> s{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          s[i][j] += P[i][k] * F[j][k] / J;
    return s;
  }

  /** von Mises norm (Pa) of a Cauchy stress. */
  inline double
  von_mises(SmallMatrix<3, double> s)
  {
    const double mean = (s[0][0] + s[1][1] + s[2][2]) / 3;
    for (int i = 0; i < 3; ++i)
      s[i][i] -= mean;
    return std::sqrt(1.5 * square_norm(s));
  }

  /** Largest eigenvalue of a symmetric matrix. */
  inline double
  largest_eigenvalue(SmallMatrix<3, double> A)
  {
    SmallMatrix<3, double> directions;
    diagonalise(A, directions);
    return std::max({A[0][0], A[1][1], A[2][2]});
  }

  /** Largest logarithmic principal strain. */
  inline double
  largest_strain(const SmallMatrix<3, double> &F)
  {
    return 0.5 * std::log(largest_eigenvalue(right_cauchy_green(F)));
  }
} // namespace coapt

#endif
