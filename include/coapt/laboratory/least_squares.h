#ifndef coapt_laboratory_least_squares_h
#define coapt_laboratory_least_squares_h

#include <functional>
#include <vector>

namespace coapt
{
  /** A problem of nonlinear least squares for variables between 0 and 1. */
  struct LeastSquares
  {
    /** Writes the residuals at x; false if they cannot be computed there. */
    std::function<bool(const std::vector<double> &x, double *residuals)>
      residuals;

    unsigned int n_residuals;

    /** Variables that keep their value; empty: none. */
    std::vector<bool> fixed;

    /**
     * Improves @p x by the method of Levenberg and Marquardt within the bounds
     * (Ceres Solver), derivatives by central differences. Returns the sum of
     * the squares of the residuals.
     */
    double
    minimise(std::vector<double> &x) const;
  };

  /**
   * Coefficients x >= 0 with the least |sum_k x_k columns[k] - y|^2 (Lawson and
   * Hanson, 1974, chapter 23), by trying all sets of positive coefficients: for
   * the few columns of a material. Columns that are zero or not finite get no
   * coefficient, neither does the column @p unused.
   */
  std::vector<double>
  non_negative_least_squares(const std::vector<std::vector<double>> &columns,
                             const std::vector<double> &y,
                             const int unused = -1);

  /**
   * Inverse of the symmetric positive definite matrix of @p n rows; empty if it
   * is singular to round-off.
   */
  std::vector<double>
  inverse_of_positive(const std::vector<double> &matrix, const unsigned int n);

  /** Two-sided quantile of Student's distribution: |t| exceeds it with the
   * probability 1 - @p confidence. */
  double
  student_quantile(const double confidence, const unsigned int n_degrees);
} // namespace coapt

#endif
