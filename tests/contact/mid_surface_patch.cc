// Sheets that touch at a uniform depth: how uniform is the pressure of their
// columns?

#include <coapt/contact/mid_surface_contact.h>

#include "sheets.h"
#include "tests.h"

#include <utility>

using namespace coapt;
using dealii::Point;

namespace
{
  /** Largest over least pressure of the columns more than two elements off all
   * edges, less one; the upper sheet has @p n elements along its sides and is
   * shifted by @p shift (m) against the lower one, which has ten. */
  double
  variation(const unsigned int n, const double shift)
  {
    const double side = 10e-3, depth = 5e-6;
    ContactParameters parameters;
    parameters.clearance = 0.3e-3;
    Sheets sheets;
    sheets.add_rectangle({{10, 10}}, Point<3>(), {{side, side}}, false);
    const unsigned int upper = sheets.mass.size();
    sheets.add_rectangle({{n, n}},
                         Point<3>(shift, shift, 5e-3),
                         {{side, side}},
                         false);
    MidSurfaceContact contact(
      sheets.leaflet, sheets.mass, Sheets::density, parameters, MPI_COMM_WORLD);
    for (unsigned int node = upper; node < sheets.mass.size(); ++node)
      sheets.X[3 * node + 2] -=
        5e-3 - Sheets::thickness - parameters.clearance + depth;
    contact.apply_impulse(sheets.X.data(), sheets.V.data(), 1e-7);

    double least = 1e300, largest = 0;
    for (unsigned int c = 0; c < sheets.leaflet.columns.size(); ++c)
      {
        const unsigned int middle = sheets.leaflet.columns[c][1];
        bool inside               = true;
        for (unsigned int d = 0; d < 2; ++d)
          inside = inside && sheets.X[3 * middle + d] > 0.25 * side &&
            sheets.X[3 * middle + d] < 0.75 * side;
        if (!inside)
          continue;
        least   = std::min(least, contact.state().pressure_impulse[c]);
        largest = std::max(largest, contact.state().pressure_impulse[c]);
      }
    return largest / least - 1;
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double shift : {0., 0.3e-3})
    {
      const double same = variation(10, shift);
      check("pressure of equal meshes is uniform, shifted by " +
              std::to_string(std::lround(1e6 * shift)) + " um",
            same < 0.01,
            same);
    }
  // As a column stands for its area, all get their share of the reaction.
  const std::vector<std::pair<unsigned int, double>> bounds = {
    {9, 0.01}, {13, 0.01}, {7, 0.01}, {17, 0.01}, {23, 0.02}};
  for (const auto &bound : bounds)
    {
      const double different = variation(bound.first, 0.3e-3);
      check("pressure of 10 and " + std::to_string(bound.first) + " elements",
            different < bound.second,
            different);
    }
}
