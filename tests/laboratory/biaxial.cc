// The biaxial test of a sheet of finite elements gives the homogeneous state,
// by Newton's method and by explicit dynamics, for stretches and for tensions;
// of neo-Hookean and Ogden's material also that of formulas written down here.

#include <coapt/base/exceptions.h>
#include <coapt/laboratory/biaxial_test.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "tests.h"

using namespace coapt;

BiaxialProtocol
protocol_from(const std::string &text)
{
  std::ofstream("protocol.csv") << text;
  return BiaxialProtocol::from_file("protocol.csv");
}

const std::string stretches = "protocol,stretch1,stretch2\n"
                              "1,1,1\n1,1.05,1.05\n1,1.12,1.1\n"
                              "2,1.1,1\n2,1.12,0.97\n";
const std::string tensions  = "protocol,tension1_N_per_m,tension2_N_per_m\n"
                              "1,1,1\n1,3,2\n";

/** Largest difference from the homogeneous state over the largest stress. For
 * tensions, the stress is that of the load. */
double
deviation(const SolidParameters &solid,
          const std::string &text,
          const bool dynamic)
{
  BiaxialParameters parameters;
  parameters.solid      = solid;
  parameters.n_elements = 3;
  const auto protocol   = protocol_from(text);
  BiaxialTest test(parameters, protocol);
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < protocol.states.size(); ++i)
    {
      const auto &state = protocol.states[i];
      if (i > 0 && state.protocol != protocol.states[i - 1].protocol)
        test.reset();
      const BiaxialResult result =
        dynamic ? test.settle(state) : test.equilibrium(state);
      const SheetState exact = test.homogeneous(result.stretch);
      for (int d = 0; d < 2; ++d)
        {
          const double stress = protocol.has_tensions
            ? state.values[d] / parameters.thickness
            : result.stress[d];
          difference = std::max(difference, std::abs(stress - exact.P[d][d]));
          largest    = std::max(largest, std::abs(exact.P[d][d]));
        }
    }
  return difference / largest;
}

void
check_material(const std::string &name, const SolidParameters &solid)
{
  for (const bool dynamic : {false, true})
    {
      const std::string method = dynamic ? "dynamic" : "quasi-static";
      const double by_stretch  = deviation(solid, stretches, dynamic);
      check(name + ", " + method + ", stretches: homogeneous to 1e-4",
            by_stretch < 1e-4,
            by_stretch);
      if (dynamic && name != "HGO")
        continue;
      const double by_tension = deviation(solid, tensions, dynamic);
      check(name + ", " + method + ", tensions: homogeneous to 1e-4",
            by_tension < 1e-4,
            by_tension);
    }
}

/** Normal first Piola-Kirchhoff stress along axis i at principal stretches. */
using Formula = std::function<double(const std::array<double, 3> &, int)>;

/** mu/2 (l1^2 + l2^2 + l3^2 - 3 - 2 ln J) + lambda/2 (ln J)^2. */
Formula
neo_hookean_formula(const double mu, const double lambda)
{
  return [=](const std::array<double, 3> &l, const int i) {
    const double J = l[0] * l[1] * l[2];
    return mu * l[i] + (lambda * std::log(J) - mu) / l[i];
  };
}

/** sum 2 mu/alpha^2 (b1^alpha + b2^alpha + b3^alpha - 3) + K/2 [(J^2 - 1)/2 -
 * ln J] with b_k = l_k J^(-1/3). */
Formula
ogden_formula(const std::vector<double> &mu,
              const std::vector<double> &alpha,
              const double K)
{
  return [=](const std::array<double, 3> &l, const int i) {
    const double J   = l[0] * l[1] * l[2];
    double kirchhoff = K / 2 * (J * J - 1);
    for (std::size_t k = 0; k < mu.size(); ++k)
      {
        double power[3], mean = 0;
        for (int j = 0; j < 3; ++j)
          {
            power[j] = std::pow(l[j] / std::cbrt(J), alpha[k]);
            mean += power[j] / 3;
          }
        kirchhoff += 2 * mu[k] / alpha[k] * (power[i] - mean);
      }
    return kirchhoff / l[i];
  };
}

/** The thickness without stress across, by bisection; across the fibres as
 * much if @p uniaxial. */
std::array<double, 3>
free_stretches(const Formula &P,
               const double along,
               const double across,
               const bool uniaxial)
{
  double low = 0.3, high = 1.5;
  const auto at = [&](const double l) {
    return std::array<double, 3>{{along, uniaxial ? l : across, l}};
  };
  for (unsigned int i = 0; i < 200; ++i)
    {
      const double middle                 = (low + high) / 2;
      (P(at(middle), 2) < 0 ? low : high) = middle;
    }
  return at(low);
}

/** The sheet of finite elements against a formula: the same stretch along both
 * sides, and one side pulled by a tension while the other is free. */
void
check_formula(const std::string &name,
              const SolidParameters &solid,
              const Formula &P)
{
  BiaxialParameters parameters;
  parameters.solid      = solid;
  parameters.n_elements = 2;
  double equibiaxial = 0, uniaxial = 0;
  for (const std::string stretch : {"0.95", "1.05", "1.15"})
    {
      const auto protocol =
        protocol_from("1," + stretch + "," + stretch + "\n");
      const auto result =
        BiaxialTest(parameters, protocol).equilibrium(protocol.states[0]);
      const double l     = std::stod(stretch);
      const double exact = P(free_stretches(P, l, l, false), 0);
      for (const double stress : result.stress)
        equibiaxial = std::max(equibiaxial, std::abs(stress / exact - 1));
    }
  for (const std::string tension : {"0.5", "2", "5"})
    {
      const auto protocol = protocol_from(
        "protocol,tension1_N_per_m,tension2_N_per_m\n1," + tension + ",0\n");
      const auto result =
        BiaxialTest(parameters, protocol).equilibrium(protocol.states[0]);
      const auto l        = free_stretches(P, result.stretch[0], 0, true);
      const double stress = std::stod(tension) / parameters.thickness;
      uniaxial            = std::max({uniaxial,
                                      std::abs(stress / P(l, 0) - 1),
                                      std::abs(result.stretch[1] / l[1] - 1)});
    }
  check(name + ", equibiaxial: as the formula",
        equibiaxial < 1e-8,
        equibiaxial);
  check(name + ", uniaxial: as the formula", uniaxial < 1e-8, uniaxial);
}

void
check_formulas()
{
  SolidParameters solid;
  solid.material        = "neo-Hookean";
  const NeoHookean &neo = solid.neo_hookean;
  check_formula("neo-Hookean", solid, neo_hookean_formula(neo.mu, neo.lambda));

  solid.material     = "Ogden";
  const Ogden &ogden = solid.ogden;
  // With this convention the initial shear modulus is the sum of mu.
  double shear = 0;
  for (const double mu : ogden.mu)
    shear += mu;
  check_formula("Ogden",
                solid,
                ogden_formula(ogden.mu,
                              ogden.alpha,
                              ogden.bulk_factor * shear));
}

void
check_refusals()
{
  BiaxialParameters parameters;
  const auto refusal = [&](const std::string &text) {
    return error_of([&]() { BiaxialTest(parameters, protocol_from(text)); });
  };
  const auto says = [](const std::string &message, const std::string &part) {
    return message.find(part) != std::string::npos;
  };
  check("a stretch beyond the exponential is refused with its place",
        says(refusal("1,1,1\n1,1.5,1.5\n"), "protocol.csv, line 2") &&
          says(refusal("1,1.5,1.5\n"), "times the limit of the exponential"));
  const std::string tensions = "protocol,tension1_N_per_m,tension2_N_per_m\n";
  check("a tension beyond the exponential is refused",
        says(refusal(tensions + "1,5,5\n1,500,500\n"),
             "protocol.csv, line 3: the stretches") &&
          says(refusal(tensions + "1,500,500\n"),
               "which balance the tensions, are beyond the range"));
  parameters.solid.material = "Ogden";
  check("Ogden: a stretch at which it is not incompressible is refused",
        says(refusal("1,1.1,1.1\n1,2.5,2.5\n"), "protocol.csv, line 2") &&
          says(refusal("1,2.5,2.5\n"), "times its volume"));
  parameters.solid.ogden.mu    = {2000};
  parameters.solid.ogden.alpha = {0.5};
  check("Ogden: a tension that no state balances is refused",
        says(refusal(tensions + "1,0.5,0.5\n1,5,5\n"),
             "protocol.csv, line 3: the tensions 5 and 5 N/m") &&
          says(refusal(tensions + "1,5,5\n"), "no stable state"));
  parameters.solid.material = "neo-Hookean";
  check("neo-Hookean: a stretch at which it is too stiff is refused",
        says(refusal("1,100,100\n"), "times as stiff as at rest"));
  check("neo-Hookean: such a tension is refused",
        says(refusal(tensions + "1,1e6,1e6\n"), "are beyond the range"));
  parameters.solid.material = "HGO";
  check("a negative stretch is refused",
        says(refusal("1,-1,1\n"), "both must be positive"));
  check("a missing column is refused",
        says(refusal("protocol,tension1_N_per_m\n1,1\n"),
             "'tension2_N_per_m' is missing"));
}

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  SolidParameters solid;
  check_material("HGO", solid);
  solid.material = "neo-Hookean";
  check_material("neo-Hookean", solid);
  solid.material = "Ogden";
  check_material("Ogden", solid);
  solid.material = "Fung";
  solid.fung.C10 = 500;
  check_material("Fung", solid);
  solid.material           = "May-Newman-Yin";
  solid.may_newman_yin.C10 = 500;
  check_material("May-Newman-Yin", solid);
  check_formulas();
  check_refusals();
}
