// Fits: known parameters are found again from data with and without noise, the
// minimum for HGO is the global one, and what is written can be read. Measured
// data: laboratory/measured_data (check_fit.cmake).

#include <coapt/laboratory/fit_parameters.h>
#include <coapt/laboratory/fit_report.h>
#include <coapt/solid/sheet_state.h>
#include <coapt/solid/solid_parameters.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>

#include <deal.II/base/parameter_handler.h>

#include "tests.h"

using namespace coapt;

/** Stresses of a material in a test of five protocols, with noise of this part
 * of their root mean square, at strains times @p scale. */
BiaxialData
synthetic_data(const Material &material,
               const double noise,
               const unsigned int n_points,
               const double scale          = 1,
               const StressMeasure measure = StressMeasure::first_piola)
{
  BiaxialData data;
  data.measure            = measure;
  const double fibre[9]   = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const double ratio[][2] = {{1, 1}, {1, 0.7}, {0.7, 1}, {1, 0.3}, {0.3, 1}};
  double sum              = 0;
  for (int p = 0; p < 5; ++p)
    for (unsigned int i = 1; i <= n_points; ++i)
      {
        BiaxialData::Point point;
        point.protocol = p;
        for (int d = 0; d < 2; ++d)
          point.stretch[d] = 1 + 0.22 * scale * ratio[p][d] * i / n_points;
        std::visit(
          [&](const auto &law) {
            point.stress = incompressible_sheet(law,
                                                point.stretch[0],
                                                point.stretch[1],
                                                fibre);
          },
          material);
        for (int d = 0; d < 2; ++d)
          {
            point.stress[d] *= data.factor(point.stretch[d]);
            sum += point.stress[d] * point.stress[d];
          }
        data.points.push_back(point);
      }
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(
    0, noise * std::sqrt(sum / (2 * data.points.size())));
  for (auto &point : data.points)
    for (double &stress : point.stress)
      stress += normal(generator);
  return data;
}

/** True parameters of each model, those with a limit below it. */
struct Truth
{
  std::string name;
  std::vector<double> stiffness, shape;
};

const std::vector<Truth> truths = {
  {"HGO", {2272, 4000}, {30, 0.25}},
  {"Fung", {900}, {20, 8, 0.3}},
  {"Ogden", {500, 60}, {4, 25}},
  {"May-Newman-Yin", {400}, {4.3, 300}},
};

/** The numbers of the parameters, stiffnesses first; those of the terms of
 * Ogden's law, whose names have no meaning, in the order of their exponents. */
std::vector<unsigned int>
order_of_parameters(const std::string &model, const FitResult &result)
{
  const unsigned int n_stiffnesses = result.stiffness.size();
  std::vector<unsigned int> order(n_stiffnesses + result.shape.size());
  std::iota(order.begin(), order.end(), 0);
  if (model != "Ogden")
    return order;
  std::sort(order.begin(),
            order.begin() + n_stiffnesses,
            [&](const unsigned int a, const unsigned int b) {
              return result.shape[a] < result.shape[b];
            });
  for (unsigned int i = 0; i < n_stiffnesses; ++i)
    order[n_stiffnesses + i] = n_stiffnesses + order[i];
  return order;
}

/** All parameters as fitted, in that order. */
std::vector<double>
ordered_parameters(const std::string &model, const FitResult &result)
{
  std::vector<double> all = result.stiffness, ordered;
  all.insert(all.end(), result.shape.begin(), result.shape.end());
  for (const unsigned int i : order_of_parameters(model, result))
    ordered.push_back(all[i]);
  return ordered;
}

void
check_recovery(const Truth &truth)
{
  const auto model             = make_tissue_model(truth.name, 2);
  const Material exact         = model->material(truth.stiffness, truth.shape);
  std::vector<double> expected = truth.stiffness;
  expected.insert(expected.end(), truth.shape.begin(), truth.shape.end());
  FitOptions options;
  options.starts = 30;

  for (const StressMeasure measure : {StressMeasure::first_piola,
                                      StressMeasure::second_piola,
                                      StressMeasure::cauchy})
    {
      const BiaxialData data = synthetic_data(exact, 0, 10, 1, measure);
      const auto found =
        ordered_parameters(truth.name,
                           TissueFit(*model, data, options).fit(false));
      double error = 0;
      for (unsigned int i = 0; i < found.size(); ++i)
        error = std::max(error, std::abs(found[i] / expected[i] - 1));
      check(truth.name + ", no noise, measure " +
              std::to_string(static_cast<int>(measure)) + ": recovered",
            error < 1e-4,
            error);
    }

  // With noise: within the intervals, and the model itself within a part of
  // the noise.
  const BiaxialData noisy = synthetic_data(exact, 0.05, 20);
  const BiaxialData clean = synthetic_data(exact, 0, 20);
  const FitResult result  = TissueFit(*model, noisy, options).fit();
  double difference = 0, size = 0;
  for (unsigned int i = 0; i < clean.points.size(); ++i)
    for (int d = 0; d < 2; ++d)
      {
        const double exact_stress = clean.points[i].stress[d];
        difference += std::pow(result.stress[i][d] - exact_stress, 2);
        size += exact_stress * exact_stress;
      }
  check(truth.name + ", 5 % noise: stresses to 1.5 %",
        std::sqrt(difference / size) < 0.015,
        std::sqrt(difference / size));
  check(truth.name + ", 5 % noise: R2 above 0.98",
        result.r_squared[2] > 0.98,
        result.r_squared[2]);
  const auto order = order_of_parameters(truth.name, result);
  double largest   = 0;
  for (unsigned int i = 0; i < expected.size(); ++i)
    {
      const FittedVariable &v = result.variables[order[i]];
      largest =
        std::max(largest, std::abs(v.value - expected[i]) / v.standard_error);
    }
  check(truth.name + ", 5 % noise: within three standard errors",
        largest < 3,
        largest);
}

/** The fit of HGO as a problem of all its four parameters at once, without
 * the linear part solved inside: C10 from 100 Pa to 0.1 MPa and K1 from 1 Pa
 * to 1 MPa, both by their logarithms, and the two shapes. */
LeastSquares
search_in_all(const TissueFit &fit, const unsigned int n_residuals)
{
  LeastSquares problem;
  problem.n_residuals = n_residuals;
  problem.residuals   = [&fit](const std::vector<double> &u, double *r) {
    const auto values =
      fit.residuals({100 * std::pow(1e3, u[0]), std::pow(1e6, u[1])},
                    fit.shapes_at({u[2], u[3]}));
    std::copy(values.begin(), values.end(), r);
    return std::all_of(values.begin(), values.end(), [](const double value) {
      return std::isfinite(value);
    });
  };
  return problem;
}

/** No local search from anywhere in the box finds less than fit(). */
void
check_global()
{
  const auto model = make_tissue_model("HGO", 2);
  const BiaxialData data =
    synthetic_data(model->material({2272, 4000}, {30, 0.25}), 0.1, 70);
  const std::clock_t start = std::clock();
  const TissueFit fit(*model, data, FitOptions());
  const FitResult result = fit.fit();
  const double seconds   = double(std::clock() - start) / CLOCKS_PER_SEC;
  check("HGO with 350 points: within 5 s of the processor",
        seconds < 5,
        seconds);

  const auto small_model = make_tissue_model("HGO", 2);
  const BiaxialData small =
    synthetic_data(model->material({2272, 4000}, {30, 0.25}), 0.1, 10);
  const TissueFit small_fit(*small_model, small, FitOptions());
  const double least = small_fit.fit(false).sum_of_squares;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  double lowest = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < 750; ++i)
    {
      std::vector<double> shape =
        small_fit.shapes_at({uniform(generator), uniform(generator)});
      std::vector<double> stiffness;
      lowest = std::min(lowest, small_fit.local_fit(shape, stiffness));
    }
  check("HGO: 750 local searches in the shapes find no less",
        lowest > least * (1 - 1e-9),
        lowest / least);
  check("HGO: ... but the same", lowest < least * (1 + 1e-6), lowest / least);

  const LeastSquares all = search_in_all(small_fit, 2 * small.points.size());
  unsigned int n_found   = 0;
  lowest                 = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < 250; ++i)
    {
      std::vector<double> u(4);
      for (double &value : u)
        value = uniform(generator);
      const double sum = all.minimise(u);
      lowest           = std::min(lowest, sum);
      n_found += sum < least * (1 + 1e-6);
    }
  check("HGO: 250 local searches in all four parameters find no less",
        lowest > least * (1 - 1e-9),
        lowest / least);
  check("HGO: ... and ten or more of them the same", n_found >= 10, n_found);
}

/** At small strains, the exponent does not show. */
void
check_profile()
{
  const auto model     = make_tissue_model("HGO", 2);
  const Material exact = model->material({2272, 4000}, {30, 0.2});
  const FitResult result =
    TissueFit(*model, synthetic_data(exact, 0.05, 20, 0.1), FitOptions()).fit();
  const FittedVariable &C = result.variables[0], &K2 = result.variables[2];
  check("small strains: the matrix is determined",
        C.determined_below && C.determined_above && C.profile_lower < 2272 &&
          C.profile_upper > 2272);
  check("small strains: the exponent is not",
        !K2.determined_below && !K2.determined_above);
}

void
check_block(const Truth &truth)
{
  const auto model       = make_tissue_model(truth.name, 2);
  const Material exact   = model->material(truth.stiffness, truth.shape);
  const BiaxialData data = synthetic_data(exact, 0, 10);
  FitResult result;
  result.stiffness = truth.stiffness;
  result.shape     = truth.shape;
  result.r_squared = {{1, 1, 1}};
  result.nmad      = 0;
  dealii::ParameterHandler prm;
  SolidParameters::declare_parameters(prm);
  prm.parse_input_from_string(material_block(*model, data, result));
  SolidParameters solid;
  solid.parse_parameters(prm);
  const BiaxialData again = synthetic_data(solid.selected_material(), 0, 10);
  double error            = 0;
  for (unsigned int i = 0; i < data.points.size(); ++i)
    for (int d = 0; d < 2; ++d)
      error =
        std::max(error,
                 std::abs(again.points[i].stress[d] / data.points[i].stress[d] -
                          1));
  check(truth.name + ": the block gives the same stresses",
        error < 1e-6,
        error);
}

std::string
error_of_table(const std::string &text)
{
  std::ofstream("table.csv") << text;
  return error_of([]() {
    BiaxialData::from_file("table.csv", StressMeasure::first_piola, "kPa");
  });
}

void
check_input()
{
  const auto says = [](const std::string &message, const std::string &part) {
    return message.find(part) != std::string::npos;
  };
  check("a missing column is named",
        says(error_of_table("protocol,stretch1,stretch2,stress1\n1,1,1,0\n"),
             "table.csv, line 1: the column 'stress2' is missing"));
  check("a short row is named",
        says(error_of_table("1,1,1,0,0\n1,1.1,1,2\n"),
             "table.csv, line 2, column 5 (stress2): there are only 4"));
  check("a cell that is no number is named",
        says(error_of_table("# test\n1,1,1,0,0\n1,1.1,x,2,2\n"),
             "table.csv, line 3, column 3 (stretch2): 'x' is not a number"));
  check("a stretch that is not positive is named",
        says(error_of_table("1,-1,1,0,0\n"), "line 1: the stretches"));
  check("an empty table is named",
        says(error_of_table("# nothing\n"), "no row of numbers"));
  check("columns may come in any order",
        error_of_table("stress2,stress1,stretch2,stretch1,protocol,time\n"
                       "1,2,1.1,1.2,1,0\n") == "none");
  std::ofstream("table.csv") << "1,1.1,1.1,1,1\n";
  const BiaxialData data =
    BiaxialData::from_file("table.csv", StressMeasure::first_piola, "kPa");
  const auto model = make_tissue_model("HGO", 2);
  check("fewer data than parameters are refused",
        says(error_of([&]() { TissueFit(*model, data, FitOptions()); }),
             "2 stresses, which cannot determine the 4 parameters"));
}

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Truth &truth : truths)
    check_recovery(truth);
  check_global();
  check_profile();
  for (const Truth &truth : truths)
    check_block(truth);
  check_input();
}
