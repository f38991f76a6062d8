#ifndef coapt_solid_small_matrix_h
#define coapt_solid_small_matrix_h

#include <coapt/solid/batch.h>

namespace coapt
{
  /**
   * A dim x dim matrix whose entries are numbers or batches of numbers
   * (deal.II's Tensor takes no vector types of the compiler).
   */
  template <int dim, typename Number>
  struct SmallMatrix
  {
    Number entry[dim][dim];

    Number *
    operator[](const int i)
    {
      return entry[i];
    }

    const Number *
    operator[](const int i) const
    {
      return entry[i];
    }
  };

  /** Cofactors of @p A, that is det(A) A^-T, also for singular @p A. */
  template <int dim, typename Number>
  inline SmallMatrix<dim, Number>
  cofactors(const SmallMatrix<dim, Number> &A)
  {
    SmallMatrix<dim, Number> C;
    if constexpr (dim == 2)
      {
        C[0][0] = A[1][1];
        C[0][1] = -A[1][0];
        C[1][0] = -A[0][1];
        C[1][1] = A[0][0];
      }
    else
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          {
            const int k = (i + 1) % 3, l = (i + 2) % 3;
            const int m = (j + 1) % 3, n = (j + 2) % 3;
            C[i][j] = A[k][m] * A[l][n] - A[k][n] * A[l][m];
          }
    return C;
  }

  /** Determinant of @p A, whose @p cofactors are known. */
  template <int dim, typename Number>
  inline Number
  determinant(const SmallMatrix<dim, Number> &A,
              const SmallMatrix<dim, Number> &cofactors)
  {
    Number sum = A[0][0] * cofactors[0][0];
    for (int j = 1; j < dim; ++j)
      sum += A[0][j] * cofactors[0][j];
    return sum;
  }

  /** Sum of the squares of all entries of @p A. */
  template <int dim, typename Number>
  inline Number
  square_norm(const SmallMatrix<dim, Number> &A)
  {
    Number sum{};
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        sum += A[i][j] * A[i][j];
    return sum;
  }

  /** The vector @p y = A @p x; both have dim entries. */
  template <int dim, typename Number>
  inline void
  multiply(const SmallMatrix<dim, Number> &A, const Number *x, Number *y)
  {
    for (int i = 0; i < dim; ++i)
      {
        y[i] = A[i][0] * x[0];
        for (int j = 1; j < dim; ++j)
          y[i] += A[i][j] * x[j];
      }
  }

  /** Right Cauchy-Green tensor F^T F. */
  template <int dim, typename Number>
  inline SmallMatrix<dim, Number>
  right_cauchy_green(const SmallMatrix<dim, Number> &F)
  {
    SmallMatrix<dim, Number> C{};
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        for (int k = 0; k < dim; ++k)
          C[i][j] += F[k][i] * F[k][j];
    return C;
  }

  /**
   * Turns the symmetric @p A into a diagonal matrix of its eigenvalues and
   * sets the columns of @p vectors to the orthonormal eigenvectors. Cyclic
   * Jacobi rotations, which need no branch and are exact to round-off also
   * where eigenvalues coincide (Golub and Van Loan, Matrix Computations,
   * section 8.5). They end when what is off the diagonal is round-off, which
   * takes three or four sweeps of a 3 x 3 matrix, five at most.
   */
  template <typename Number>
  inline void
  diagonalise(SmallMatrix<3, Number> &A, SmallMatrix<3, Number> &vectors)
  {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        vectors[i][j] = Number{} + (i == j ? 1. : 0.);
    const auto off_diagonal = [&A] {
      return A[0][1] * A[0][1] + A[0][2] * A[0][2] + A[1][2] * A[1][2];
    };
    const Number round_off = 1e-32 *
      (A[0][0] * A[0][0] + A[1][1] * A[1][1] + A[2][2] * A[2][2] +
       2. * off_diagonal());
    for (int sweep = 0; sweep < 5 && !none_above(off_diagonal(), round_off);
         ++sweep)
      for (int r = 0; r < 3; ++r)
        {
          const int p = (r == 2 ? 1 : 0), q = (r == 0 ? 1 : 2), o = 3 - p - q;
          const Number off  = A[p][q];
          const Number half = 0.5 * (A[q][q] - A[p][p]);
          const Number root = square_root(half * half + off * off);
          const Number tangent =
            off / (half < 0 ? half - root - 1e-300 : half + root + 1e-300);
          const Number c = 1. / square_root(1. + tangent * tangent);
          const Number s = tangent * c;

          A[p][p] -= tangent * off;
          A[q][q] += tangent * off;
          A[p][q] = A[q][p] = Number{};
          const Number op = A[o][p], oq = A[o][q];
          A[o][p] = A[p][o] = c * op - s * oq;
          A[o][q] = A[q][o] = s * op + c * oq;
          for (int i = 0; i < 3; ++i)
            {
              const Number vp = vectors[i][p], vq = vectors[i][q];
              vectors[i][p] = c * vp - s * vq;
              vectors[i][q] = s * vp + c * vq;
            }
        }
  }
} // namespace coapt

#endif
