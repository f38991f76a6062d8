// The biaxial test of a sheet of finite elements gives the homogeneous state,
// by Newton's method and by explicit dynamics, for stretches and for tensions.

#include <coapt/base/exceptions.h>
#include <coapt/laboratory/biaxial_test.h>

#include <algorithm>
#include <fstream>

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
  check_refusals();
}
