#include <coapt/base/exceptions.h>
#include <coapt/laboratory/tissue_fit.h>
#include <coapt/solid/sheet_state.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace coapt
{
  namespace
  {
    double
    square_sum(const std::vector<double> &x)
    {
      double sum = 0;
      for (const double value : x)
        sum += value * value;
      return sum;
    }

    bool
    all_finite(const std::vector<double> &x)
    {
      return std::all_of(x.begin(), x.end(), [](const double value) {
        return std::isfinite(value);
      });
    }
  } // namespace

  TissueFit::TissueFit(const TissueModel &model,
                       const BiaxialData &data,
                       const FitOptions &options)
    : model(model), data(data), options(options)
  {
    const auto n_parameters = model.variables().size();
    const auto n_stresses   = 2 * data.points.size();
    if (n_stresses <= n_parameters)
      throw InputError("The data have " + std::to_string(n_stresses) +
                       " stresses, which cannot determine the " +
                       std::to_string(n_parameters) + " parameters of " +
                       model.name() + "; at least " +
                       std::to_string(n_parameters + 1) + " are needed");
    for (const auto &point : data.points)
      measured.insert(measured.end(), point.stress.begin(), point.stress.end());
    stretches.resize((data.points.size() + batch_size - 1) / batch_size);
    for (unsigned int i = 0; i < stretches.size() * batch_size; ++i)
      for (int d = 0; d < 2; ++d)
        stretches[i / batch_size][d][i % batch_size] =
          data.points[std::min<std::size_t>(i, data.points.size() - 1)]
            .stretch[d];
  }

  std::vector<double>
  TissueFit::stresses(const Material &material) const
  {
    std::vector<double> result(measured.size());
    Batch directions[9] = {};
    for (int i = 0; i < 9; i += 4)
      directions[i] += 1.;
    std::visit(
      [&](const auto &law) {
        for (unsigned int b = 0; b < stretches.size(); ++b)
          {
            const auto P = incompressible_sheet(law,
                                                stretches[b][0],
                                                stretches[b][1],
                                                directions);
            for (unsigned int lane = 0; lane < batch_size; ++lane)
              {
                const std::size_t point = b * batch_size + lane;
                for (int d = 0; d < 2 && point < data.points.size(); ++d)
                  result[2 * point + d] =
                    P[d][lane] * data.factor(data.points[point].stretch[d]);
              }
          }
      },
      material);
    return result;
  }

  std::vector<double>
  TissueFit::residuals(const std::vector<double> &stiffness,
                       const std::vector<double> &shape) const
  {
    std::vector<double> r = stresses(model.material(stiffness, shape));
    for (std::size_t i = 0; i < r.size(); ++i)
      r[i] -= measured[i];
    return r;
  }

  std::vector<double>
  TissueFit::project(const std::vector<double> &shape,
                     std::vector<double> &stiffness,
                     const Fixed &fixed) const
  {
    const unsigned int n = model.stiffnesses.size();
    std::vector<std::vector<double>> columns;
    for (unsigned int k = 0; k < n; ++k)
      {
        std::vector<double> unit(n, 0.);
        unit[k] = 1;
        columns.push_back(stresses(model.material(unit, shape)));
      }
    // Stiffnesses exceed their lower bounds by something not negative.
    std::vector<double> least(n), rest = measured;
    for (unsigned int k = 0; k < n; ++k)
      {
        const bool is_fixed = fixed.index == static_cast<int>(k);
        least[k] = is_fixed ? fixed.value : model.stiffnesses[k].lowest;
        if (least[k] != 0)
          for (std::size_t i = 0; i < rest.size(); ++i)
            rest[i] -= least[k] * columns[k][i];
      }
    stiffness = non_negative_least_squares(columns, rest, fixed.index);
    for (double &value : rest)
      value = -value;
    for (unsigned int k = 0; k < n; ++k)
      {
        if (stiffness[k] > 0)
          for (std::size_t i = 0; i < rest.size(); ++i)
            rest[i] += stiffness[k] * columns[k][i];
        stiffness[k] += least[k];
      }
    return rest;
  }

  LeastSquares
  TissueFit::problem(const Fixed &fixed) const
  {
    LeastSquares result;
    result.n_residuals = measured.size();
    result.residuals = [this, fixed](const std::vector<double> &u, double *r) {
      std::vector<double> stiffness;
      const auto values = project(shapes_at(u), stiffness, fixed);
      std::copy(values.begin(), values.end(), r);
      return all_finite(values);
    };
    return result;
  }

  std::vector<double>
  TissueFit::shapes_at(const std::vector<double> &u) const
  {
    std::vector<double> shape;
    for (std::size_t i = 0; i < u.size(); ++i)
      {
        const FitVariable &v = model.shapes[i];
        shape.push_back(v.logarithmic
                          ? v.lowest * std::pow(v.highest / v.lowest, u[i])
                          : v.lowest + (v.highest - v.lowest) * u[i]);
      }
    return shape;
  }

  std::vector<double>
  TissueFit::fractions(const std::vector<double> &shape) const
  {
    std::vector<double> u;
    for (std::size_t i = 0; i < shape.size(); ++i)
      {
        const FitVariable &v  = model.shapes[i];
        const double fraction = v.logarithmic
          ? std::log(shape[i] / v.lowest) / std::log(v.highest / v.lowest)
          : (shape[i] - v.lowest) / (v.highest - v.lowest);
        u.push_back(std::min(1., std::max(0., fraction)));
      }
    return u;
  }

  std::vector<std::vector<double>>
  TissueFit::starts() const
  {
    std::vector<std::vector<double>> result;
    const unsigned int n_shapes = model.shapes.size();
    if (n_shapes != 2)
      {
        std::mt19937 generator(options.seed);
        std::uniform_real_distribution<double> uniform(0, 1);
        for (unsigned int i = 0; i < options.starts; ++i)
          {
            std::vector<double> u(n_shapes);
            for (double &fraction : u)
              fraction = uniform(generator);
            result.push_back(u);
          }
        return result;
      }

    const int n         = std::max(options.grid, 2u);
    const auto place    = [&](const int i) { return double(i) / (n - 1); };
    const auto evaluate = [&](const int i, const int j) {
      std::vector<double> stiffness;
      const double sum = square_sum(
        project(shapes_at({place(i), place(j)}), stiffness, Fixed()));
      return std::isfinite(sum) ? sum : std::numeric_limits<double>::max();
    };
    std::vector<double> values(n * n);
    for (int i = 0; i < n * n; ++i)
      values[i] = evaluate(i / n, i % n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        {
          // On a plateau, the first point stands for all.
          bool lowest = values[i * n + j] < std::numeric_limits<double>::max();
          for (int k = std::max(i - 1, 0); k <= std::min(i + 1, n - 1); ++k)
            for (int l = std::max(j - 1, 0); l <= std::min(j + 1, n - 1); ++l)
              {
                const double other = values[k * n + l];
                lowest             = lowest &&
                  (k * n + l < i * n + j ? values[i * n + j] < other
                                         : values[i * n + j] <= other);
              }
          if (lowest)
            result.push_back({place(i), place(j)});
        }
    return result;
  }

  double
  TissueFit::local_fit(std::vector<double> &shape,
                       std::vector<double> &stiffness) const
  {
    std::vector<double> u = fractions(shape);
    problem(Fixed()).minimise(u);
    shape = shapes_at(u);
    return square_sum(project(shape, stiffness, Fixed()));
  }

  FitResult
  TissueFit::fit(const bool all) const
  {
    FitResult best;
    std::vector<double> minima;
    const auto places = starts();
    for (const auto &u : places)
      {
        std::vector<double> shape = shapes_at(u), stiffness;
        const double sum          = local_fit(shape, stiffness);
        if (!std::isfinite(sum))
          continue;
        if (std::none_of(minima.begin(), minima.end(), [&](const double other) {
              return std::abs(sum - other) <= 1e-6 * (sum + other);
            }))
          minima.push_back(sum);
        if (sum < best.sum_of_squares)
          {
            best.sum_of_squares = sum;
            best.shape          = shape;
            best.stiffness      = stiffness;
          }
      }
    if (best.shape.empty())
      throw NumericalError("no start of the fit of " + model.name() +
                           " gave finite stresses");
    best.n_starts = places.size();
    best.n_minima = minima.size();
    add_quality(best);
    add_intervals(best);
    if (all)
      for (unsigned int i = 0; i < best.variables.size(); ++i)
        add_profile(best, i);
    return best;
  }

  void
  TissueFit::add_quality(FitResult &result) const
  {
    const auto r      = residuals(result.stiffness, result.shape);
    double squares[3] = {}, totals[3] = {}, means[3] = {};
    double deviation         = 0;
    unsigned int n_deviation = 0;
    const double n           = data.points.size();
    for (std::size_t i = 0; i < r.size(); ++i)
      {
        means[i % 2] += measured[i] / n;
        means[2] += measured[i] / (2 * n);
      }
    result.stress.resize(data.points.size());
    for (std::size_t i = 0; i < r.size(); ++i)
      {
        const double model_stress   = measured[i] + r[i];
        result.stress[i / 2][i % 2] = model_stress;
        for (const unsigned int k : {static_cast<unsigned int>(i % 2), 2u})
          {
            squares[k] += r[i] * r[i];
            totals[k] += (measured[i] - means[k]) * (measured[i] - means[k]);
          }
        const double larger_one = std::max(measured[i], model_stress);
        if (measured[i] != 0 && larger_one > 0)
          {
            deviation += 100 * std::abs(r[i]) / larger_one;
            ++n_deviation;
          }
      }
    for (int k = 0; k < 3; ++k)
      result.r_squared[k] = totals[k] > 0
        ? 1 - squares[k] / totals[k]
        : std::numeric_limits<double>::quiet_NaN(); // nothing to explain
    result.nmad = deviation / std::max(n_deviation, 1u);
  }

  void
  TissueFit::add_intervals(FitResult &result) const
  {
    const auto variables        = model.variables();
    const unsigned int n        = variables.size();
    const unsigned int n_linear = model.stiffnesses.size();
    std::vector<unsigned int> free;
    std::vector<std::vector<double>> derivatives;
    for (unsigned int i = 0; i < n; ++i)
      {
        FittedVariable fitted;
        fitted.variable = variables[i];
        fitted.value =
          i < n_linear ? result.stiffness[i] : result.shape[i - n_linear];
        fitted.lower = variables[i].lowest;
        fitted.upper = variables[i].highest;
        result.variables.push_back(fitted);
        const double width = variables[i].highest - variables[i].lowest;
        if (fitted.value <= variables[i].lowest + 1e-9 * std::min(width, 1.) ||
            fitted.value >= variables[i].highest - 1e-9 * width)
          continue;
        const double step = 1e-5 * std::max(std::abs(fitted.value), 1e-6);
        std::vector<double> both[2];
        for (int side = 0; side < 2; ++side)
          {
            auto stiffness = result.stiffness, shape = result.shape;
            (i < n_linear ? stiffness[i] : shape[i - n_linear]) +=
              side == 0 ? -step : step;
            both[side] = residuals(stiffness, shape);
          }
        for (std::size_t k = 0; k < both[0].size(); ++k)
          both[0][k] = (both[1][k] - both[0][k]) / (2 * step);
        free.push_back(i);
        derivatives.push_back(both[0]);
      }

    const unsigned int m = free.size();
    std::vector<double> normal(m * m, 0.);
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        for (std::size_t k = 0; k < measured.size(); ++k)
          normal[i * m + j] += derivatives[i][k] * derivatives[j][k];
    const auto inverse = inverse_of_positive(normal, m);
    if (inverse.empty())
      return;
    const unsigned int n_degrees = measured.size() - n;
    const double variance        = result.sum_of_squares / n_degrees;
    const double quantile = student_quantile(options.confidence, n_degrees);
    for (unsigned int i = 0; i < m; ++i)
      {
        FittedVariable &fitted = result.variables[free[i]];
        fitted.standard_error  = std::sqrt(variance * inverse[i * (m + 1)]);
        const double half      = quantile * fitted.standard_error;
        fitted.lower = std::max(fitted.value - half, fitted.variable.lowest);
        fitted.upper = std::min(fitted.value + half, fitted.variable.highest);
      }
  }

  void
  TissueFit::follow_profile(const FitResult &result,
                            const unsigned int number,
                            const int side,
                            const double threshold,
                            FittedVariable &fitted) const
  {
    const unsigned int n_linear = model.stiffnesses.size();
    const bool is_shape         = number >= n_linear;
    const double bound =
      side < 0 ? fitted.variable.lowest : fitted.variable.highest;
    double &end = side < 0 ? fitted.profile_lower : fitted.profile_upper;
    bool &is_known =
      side < 0 ? fitted.determined_below : fitted.determined_above;
    end = bound;

    std::vector<double> u = fractions(result.shape);
    // A parameter that is zero has no size of its own.
    const double width = fitted.variable.highest - fitted.variable.lowest;
    const double least = is_shape
      ? 1e-3 * std::min(width, 1.)
      : 1e-2 * std::sqrt(square_sum(measured) / measured.size());
    const double size  = std::max(std::abs(fitted.value), least);
    double step        = std::min(std::isfinite(fitted.standard_error)
                             ? 0.5 * fitted.standard_error
                             : 0.05 * size,
                           0.1 * size);
    step          = std::max(step, 1e-6 * size);
    double before = fitted.value, sum_before = result.sum_of_squares;
    for (unsigned int i = 0; i < 40 && before != bound; ++i, step *= 1.4)
      {
        double value = fitted.value + side * step;
        if (side * (value - bound) >= 0)
          value = bound;
        Fixed fixed;
        if (!is_shape)
          fixed = {static_cast<int>(number), value};
        LeastSquares search = problem(fixed);
        if (is_shape)
          {
            auto shape               = result.shape;
            shape[number - n_linear] = value;
            u[number - n_linear]     = fractions(shape)[number - n_linear];
            search.fixed.assign(u.size(), false);
            search.fixed[number - n_linear] = true;
          }
        const double sum = search.minimise(u);
        if (!std::isfinite(sum))
          return;
        fitted.profile.push_back({{value, sum}});
        if (sum > threshold)
          {
            is_known = true;
            // near the minimum, the profile is a parabola
            const double above = sum - result.sum_of_squares;
            const double below =
              std::max(sum_before - result.sum_of_squares, 0.);
            const double wanted = threshold - result.sum_of_squares;
            const double t      = (std::sqrt(wanted) - std::sqrt(below)) /
              (std::sqrt(above) - std::sqrt(below));
            end = before + t * (value - before);
            return;
          }
        before     = value;
        sum_before = sum;
      }
  }

  void
  TissueFit::add_profile(FitResult &result, const unsigned int number) const
  {
    FittedVariable &fitted       = result.variables[number];
    const unsigned int n_degrees = measured.size() - result.variables.size();
    const double t = student_quantile(options.confidence, n_degrees);
    // Round-off decides where the model reproduces the data exactly.
    const double least =
      std::max(result.sum_of_squares, 1e-20 * square_sum(measured));
    const double threshold = result.sum_of_squares + least * t * t / n_degrees;
    fitted.profile         = {{{fitted.value, result.sum_of_squares}}};
    follow_profile(result, number, -1, threshold, fitted);
    follow_profile(result, number, 1, threshold, fitted);
    std::sort(fitted.profile.begin(), fitted.profile.end());
  }
} // namespace coapt
