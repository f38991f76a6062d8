// What a sample of a valve gives rise to in warnings, at both sides of each
// bound.

#include <coapt/base/exceptions.h>
#include <coapt/io/valve_warnings.h>

#include "tests.h"

using namespace coapt;

namespace
{
  constexpr double thickness = 1.26e-3, cell = 0.5e-3;

  /** Keys of the warnings, each followed by a blank. */
  std::string
  keys(const ValveSample &sample, const double finest_cell = cell)
  {
    std::string result;
    for (const ValveWarning &warning :
         valve_warnings(sample, thickness, finest_cell))
      result += warning.key + " ";
    return result;
  }

  /** The warning of a shut valve whose @p member has the given value. */
  std::string
  with(double ValveSample::*member, const double value)
  {
    ValveSample sample;
    sample.*member = value;
    return keys(sample);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check("a valve at rest", keys(ValveSample()).empty());
  struct Case
  {
    std::string key;
    double ValveSample::*member;
    double fine, bad;
  };
  for (const Case &one :
       {Case{"penetration", &ValveSample::min_gap, -0.62e-3, -0.64e-3},
        Case{"stretched points", &ValveSample::point_spacing, 0.9, 0.91},
        Case{"checkerboard", &ValveSample::checkerboard_rms, 10, 10.1},
        Case{"hourglass", &ValveSample::hourglass_rms, 1e-3, 1.01e-3},
        Case{"jet", &ValveSample::largest_velocity, 1, 1.01}})
    {
      check("no " + one.key, with(one.member, one.fine).empty());
      check(one.key, with(one.member, one.bad) == one.key + " ");
    }

  ValveSample open;
  open.largest_velocity = 2;
  open.hourglass_rms    = 0.1;
  open.checkerboard_rms = 100;
  open.path_width       = 0.5 * cell;
  check("an open valve has jets and noise", keys(open).empty());
  open.path_width = 0.49 * cell;
  check("a shut one has not", keys(open) == "checkerboard hourglass jet ");
  check("nor is there any without blood", keys(open, 0).empty());

  ValveSample stretched;
  stretched.point_spacing = 1.4;
  bool stopped            = false;
  try
    {
      keys(stretched);
    }
  catch (const NumericalError &)
    {
      stopped = true;
    }
  check("points too far apart end the run", stopped);
}
