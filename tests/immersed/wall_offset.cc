// The place of a wall within the cells: a thick plate at rest below a moving
// lid, whose drag tells where the flow comes to rest.
#include "flow/run_study.h"
#include "tests.h"

using namespace coapt;

namespace
{
  constexpr double height = 1, length = 16, cell = 1. / 16, viscosity = 0.1;

  /** Height at which the flow comes to rest above a plate whose upper face is
   * at @p wall. */
  double
  felt_wall(const double wall)
  {
    const double thickness = 4 * cell;
    const std::string y    = std::to_string(wall - thickness / 2);
    const auto runs =
      run_study<2>("couette",
                   FlowContents::bodies,
                   {{"Time", "End time", "6"},
                    {"Flow", "Upper corner", std::to_string(length) + ", 1"},
                    {"Flow", "Coarse cells", "256, 16"},
                    {"Flow", "Refinements", "0"},
                    {"Flow", "Patch lower corner", ""},
                    {"Flow", "Patch upper corner", ""},
                    {"Flow", "Side x lower", "pressure"},
                    {"Flow", "Side x upper", "pressure"},
                    {"Flow", "Boundary velocity", "1; 0"},
                    {"Flow", "Initial velocity", "max(0, (y-0.6)/0.4); 0"},
                    {"Flow", "Figures from", "6"},
                    {"Body", "Shape", "strip"},
                    {"Body", "Begin", "0, " + y},
                    {"Body", "End", std::to_string(length) + ", " + y},
                    {"Body", "Thickness", std::to_string(thickness)},
                    {"Body", "Coupled part", "surface"},
                    {"Body", "Held", "1"},
                    {"Solid", "Material", "neo-Hookean"},
                    {"Solid", "Density", "1e5"},
                    {"Coupling", "Largest relaxation time", "1"},
                    {"Coupling", "Point spacing", "1"}})
        .results();
    const double force = figure(runs[0], "body_force_x_N_mean");
    return height - viscosity * length / std::abs(force);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  for (const double fraction : {0.02, 0.25, 0.5, 0.75, 0.98})
    {
      const double wall  = (9 + fraction) * cell;
      const double error = (felt_wall(wall) - wall) / cell;
      std::ostringstream name;
      name << "wall at " << fraction << " of a cell";
      check(name.str(), std::abs(error) < 0.03, error);
    }
}
