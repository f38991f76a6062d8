#ifndef coapt_solid_dual_h
#define coapt_solid_dual_h

#include <coapt/solid/small_matrix.h>

#include <cmath>

namespace coapt
{
  /**
   * A number with its derivatives with respect to @p n variables: forward
   * automatic differentiation (Griewank and Walther, Evaluating Derivatives,
   * section 3.1). The materials' functions take it as they take numbers and
   * batches, and then return exact derivatives.
   */
  template <int n>
  struct Dual
  {
    double value    = 0;
    double slope[n] = {};

    Dual() = default;

    /** A constant. */
    Dual(const double value) : value(value)
    {
    }

    /** The variable of this number. */
    static Dual
    variable(const double value, const int number)
    {
      Dual x(value);
      x.slope[number] = 1;
      return x;
    }

    /** The function of @p x whose value and derivative there are given. */
    static Dual
    chain(const Dual &x, const double value, const double derivative)
    {
      Dual result(value);
      for (int i = 0; i < n; ++i)
        result.slope[i] = derivative * x.slope[i];
      return result;
    }

    Dual &
    operator+=(const Dual &other)
    {
      value += other.value;
      for (int i = 0; i < n; ++i)
        slope[i] += other.slope[i];
      return *this;
    }

    Dual &
    operator-=(const Dual &other)
    {
      value -= other.value;
      for (int i = 0; i < n; ++i)
        slope[i] -= other.slope[i];
      return *this;
    }

    Dual &
    operator*=(const Dual &other)
    {
      for (int i = 0; i < n; ++i)
        slope[i] = slope[i] * other.value + value * other.slope[i];
      value *= other.value;
      return *this;
    }

    Dual &
    operator/=(const Dual &other)
    {
      value /= other.value;
      for (int i = 0; i < n; ++i)
        slope[i] = (slope[i] - value * other.slope[i]) / other.value;
      return *this;
    }

    friend Dual
    operator+(Dual x, const Dual &y)
    {
      return x += y;
    }

    friend Dual
    operator-(Dual x, const Dual &y)
    {
      return x -= y;
    }

    friend Dual
    operator*(Dual x, const Dual &y)
    {
      return x *= y;
    }

    friend Dual
    operator/(Dual x, const Dual &y)
    {
      return x /= y;
    }

    friend Dual
    operator-(const Dual &x)
    {
      return chain(x, -x.value, -1);
    }

    friend bool
    operator<(const Dual &x, const Dual &y)
    {
      return x.value < y.value;
    }

    friend bool
    operator>(const Dual &x, const Dual &y)
    {
      return x.value > y.value;
    }
  };

  /** Elementary functions with their derivatives. @{ */
  template <int n>
  inline Dual<n>
  square_root(const Dual<n> &x)
  {
    const double root = std::sqrt(x.value);
    return Dual<n>::chain(x, root, 0.5 / root);
  }

  template <int n>
  inline Dual<n>
  exponential(const Dual<n> &x)
  {
    const double power = std::exp(x.value);
    return Dual<n>::chain(x, power, power);
  }

  template <int n>
  inline Dual<n>
  logarithm(const Dual<n> &x)
  {
    return Dual<n>::chain(x, std::log(x.value), 1 / x.value);
  }

  template <int n>
  inline Dual<n>
  cube_root(const Dual<n> &x)
  {
    const double root = std::cbrt(x.value);
    return Dual<n>::chain(x, root, root / (3 * x.value));
  }
  /** @} */

  /**
   * Eigenvalues and eigenvectors with their derivatives (perturbation of first
   * order), in place of Jacobi's rotations, which have none where eigenvalues
   * coincide. Such eigenvalues are moved apart by 1e-6 of their size: an
   * isotropic function of the matrix then has its derivatives to that
   * accuracy, although those of the eigenvectors are without meaning.
   */
  template <int n>
  inline void
  diagonalise(SmallMatrix<3, Dual<n>> &A, SmallMatrix<3, Dual<n>> &vectors)
  {
    SmallMatrix<3, double> values, v;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        values[i][j] = A[i][j].value;
    diagonalise(values, v);
    double lambda[3] = {values[0][0], values[1][1], values[2][2]};
    const double gap =
      1e-6 * (std::abs(lambda[0]) + std::abs(lambda[1]) + std::abs(lambda[2]));
    for (int k = 1; k < 3; ++k)
      for (int l = 0; l < k; ++l)
        if (std::abs(lambda[k] - lambda[l]) < 1e-3 * gap)
          lambda[k] += k * gap;

    const SmallMatrix<3, Dual<n>> matrix = A;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        {
          A[i][j]       = Dual<n>(i == j ? lambda[i] : 0.);
          vectors[i][j] = Dual<n>(v[i][j]);
        }
    for (int s = 0; s < n; ++s)
      {
        double change[3][3] = {};
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                change[k][l] += v[i][k] * matrix[i][j].slope[s] * v[j][l];
        for (int k = 0; k < 3; ++k)
          {
            A[k][k].slope[s] = change[k][k];
            for (int l = 0; l < 3; ++l)
              if (l != k)
                for (int i = 0; i < 3; ++i)
                  vectors[i][k].slope[s] +=
                    v[i][l] * change[l][k] / (lambda[k] - lambda[l]);
          }
      }
  }
} // namespace coapt

#endif
