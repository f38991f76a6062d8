#ifndef coapt_solid_tangent_h
#define coapt_solid_tangent_h

#include <coapt/solid/dual.h>

namespace coapt
{
  /** dP_ij/dF_kl of a material, [3 i + j][3 k + l] (Pa). */
  using MaterialTangent = SmallMatrix<9, double>;

  /** @p F with derivatives with respect to its own entries, by rows. */
  inline SmallMatrix<3, Dual<9>>
  with_derivatives(const SmallMatrix<3, double> &F)
  {
    SmallMatrix<3, Dual<9>> G;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        G[i][j] = Dual<9>::variable(F[i][j], 3 * i + j);
    return G;
  }

  /**
   * Tangent of a material @p law at the deformation gradient @p F, by
   * automatic differentiation of its stress. @p fibre: nine numbers, the
   * directions of the cell (fibre, across it, normal).
   */
  template <typename Law>
  MaterialTangent
  material_tangent(const Law &law,
                   const SmallMatrix<3, double> &F,
                   const double *fibre)
  {
    Dual<9> directions[9];
    for (int i = 0; i < 9; ++i)
      directions[i] = fibre[i];
    const auto P = law.first_piola(with_derivatives(F), directions);
    MaterialTangent A;
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j)
        A[i][j] = P[i / 3][i % 3].slope[j];
    return A;
  }
} // namespace coapt

#endif
