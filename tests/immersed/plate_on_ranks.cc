// A compressible plate with its own stress only, while it is pushed: the same
// on any number of ranks, and no energy is lost.
#include "flow/run_study.h"
#include "tests.h"

using namespace coapt;

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const auto study         = run_study<2>("plate_tilted",
                                  FlowContents::bodies,
                                  {{"Flow", "Refinements", "0"},
                                           {"Body", "Element size", "1"},
                                           {"Flow", "Figures from", "9e-3"},
                                           {"Time", "End time", "10e-3"},
                                           {"Study", "Parameter", ""},
                                           {"Study", "Values", ""}});
  const FlowResult &result = study.results()[0];
  check_relative("deflection",
                 figure(result, "displacement_1_x_m_mean"),
                 0.669464339708e-3, // on one rank
                 1e-7);
  const double error = figure(result, "energy_error_relative_max");
  check("energy error below 0.01 %", error < 1e-4, error);
}
