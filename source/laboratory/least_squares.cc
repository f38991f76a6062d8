#include <boost/math/distributions/students_t.hpp>

#include <ceres/dynamic_numeric_diff_cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <coapt/laboratory/least_squares.h>

#include <cmath>
#include <limits>

namespace coapt
{
  namespace
  {
    /** The residuals as Ceres calls them, a block for each variable. */
    struct Residuals
    {
      const LeastSquares &problem;
      std::size_t n_variables;

      bool
      operator()(double const *const *x, double *residuals) const
      {
        std::vector<double> values(n_variables);
        for (std::size_t i = 0; i < n_variables; ++i)
          values[i] = *x[i];
        return problem.residuals(values, residuals);
      }
    };

    /** The inverse of the part of @p matrix (n rows) of the rows in @p set, by
     * Cholesky's factorisation of the part scaled to a unit diagonal. */
    std::vector<double>
    invert_part(const std::vector<double> &matrix,
                const unsigned int n,
                const std::vector<unsigned int> &set)
    {
      const std::size_t m = set.size();
      std::vector<double> scale(m), R(m * m, 0.), inverse(m * m, 0.);
      for (std::size_t i = 0; i < m; ++i)
        scale[i] = 1 / std::sqrt(matrix[set[i] * (n + 1)]);
      for (std::size_t j = 0; j < m; ++j)
        for (std::size_t i = j; i < m; ++i)
          {
            double sum = matrix[set[i] * n + set[j]] * scale[i] * scale[j];
            for (std::size_t k = 0; k < j; ++k)
              sum -= R[i * m + k] * R[j * m + k];
            if (i == j && !(sum > 1e-13))
              return {};
            R[i * m + j] = i == j ? std::sqrt(sum) : sum / R[j * m + j];
          }
      for (std::size_t c = 0; c < m; ++c)
        {
          std::vector<double> x(m, 0.);
          for (std::size_t i = 0; i < m; ++i)
            {
              x[i] = i == c ? 1 : 0;
              for (std::size_t k = 0; k < i; ++k)
                x[i] -= R[i * m + k] * x[k];
              x[i] /= R[i * m + i];
            }
          for (std::size_t i = m; i-- > 0;)
            {
              for (std::size_t k = i + 1; k < m; ++k)
                x[i] -= R[k * m + i] * x[k];
              x[i] /= R[i * m + i];
            }
          for (std::size_t i = 0; i < m; ++i)
            inverse[i * m + c] = x[i] * scale[i] * scale[c];
        }
      return inverse;
    }
  } // namespace

  double
  LeastSquares::minimise(std::vector<double> &x) const
  {
    ceres::NumericDiffOptions differences;
    differences.relative_step_size = 1e-6;
    auto *cost = new ceres::DynamicNumericDiffCostFunction<Residuals>(
      new Residuals{*this, x.size()}, ceres::TAKE_OWNERSHIP, differences);
    std::vector<double *> blocks;
    for (double &value : x)
      {
        cost->AddParameterBlock(1);
        blocks.push_back(&value);
      }
    cost->SetNumResiduals(n_residuals);

    ceres::Problem problem; // owns the cost
    problem.AddResidualBlock(cost, nullptr, blocks);
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        problem.SetParameterLowerBound(blocks[i], 0, 0);
        problem.SetParameterUpperBound(blocks[i], 0, 1);
        if (!fixed.empty() && fixed[i])
          problem.SetParameterBlockConstant(blocks[i]);
      }
    ceres::Solver::Options options;
    options.linear_solver_type  = ceres::DENSE_QR;
    options.max_num_iterations  = 200;
    options.function_tolerance  = 1e-14;
    options.gradient_tolerance  = 1e-16;
    options.parameter_tolerance = 1e-12;
    options.logging_type        = ceres::SILENT;
    options.num_threads         = 1;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);

    std::vector<double> r(n_residuals);
    if (!residuals(x, r.data()))
      return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (const double value : r)
      sum += value * value;
    return sum;
  }

  std::vector<double>
  non_negative_least_squares(const std::vector<std::vector<double>> &columns,
                             const std::vector<double> &y,
                             const int unused)
  {
    const unsigned int n = columns.size();
    std::vector<double> normal(n * n), right(n), best(n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j <= i; ++j)
          {
            double sum = 0;
            for (std::size_t k = 0; k < y.size(); ++k)
              sum += columns[i][k] * columns[j][k];
            normal[i * n + j] = normal[j * n + i] = sum;
          }
        for (std::size_t k = 0; k < y.size(); ++k)
          right[i] += columns[i][k] * y[k];
      }

    double largest_gain = 0;
    for (unsigned int choice = 1; choice < (1u << n); ++choice)
      {
        std::vector<unsigned int> set;
        bool usable = true;
        for (unsigned int i = 0; i < n; ++i)
          if (choice & (1u << i))
            {
              set.push_back(i);
              const double square = normal[i * (n + 1)];
              usable              = usable && std::isfinite(square) &&
                static_cast<int>(i) != unused &&
                square > std::numeric_limits<double>::min();
            }
        if (!usable)
          continue;
        const auto inverse = invert_part(normal, n, set);
        if (inverse.empty())
          continue;
        // By a least-squares solution x, |y|^2 falls by x . right.
        std::vector<double> x(n, 0.);
        double gain   = 0;
        bool positive = true;
        for (std::size_t i = 0; i < set.size(); ++i)
          {
            for (std::size_t j = 0; j < set.size(); ++j)
              x[set[i]] += inverse[i * set.size() + j] * right[set[j]];
            gain += x[set[i]] * right[set[i]];
            positive = positive && x[set[i]] > 0;
          }
        if (positive && gain > largest_gain)
          {
            largest_gain = gain;
            best         = x;
          }
      }
    return best;
  }

  std::vector<double>
  inverse_of_positive(const std::vector<double> &matrix, const unsigned int n)
  {
    std::vector<unsigned int> all(n);
    for (unsigned int i = 0; i < n; ++i)
      all[i] = i;
    return invert_part(matrix, n, all);
  }

  double
  student_quantile(const double confidence, const unsigned int n_degrees)
  {
    return boost::math::quantile(boost::math::students_t(n_degrees),
                                 0.5 + confidence / 2);
  }
} // namespace coapt
