// The coaptation belt on a cylinder with synthetic gaps and tractions.

#include <coapt/metrics/coaptation.h>

#include "cylinder_leaflet.h"
#include "tests.h"

using namespace coapt;
using dealii::Point;

namespace
{
  /** Arrays of a belt that covers rows 8 to 12 at 10 kPa all around, of which
   * contact carries 60 %. */
  struct Belt
  {
    std::vector<double> gap, contact, total, area;

    Belt(const unsigned int n)
      : gap(n, 1e-2), contact(n, 0.), total(n, 0.), area(n, 1e-6)
    {
      for (unsigned int i = 0; i < n_angles; ++i)
        for (unsigned int j = 8; j <= n_rows; ++j)
          set(i, j, 0.5e-3, 10e3);
    }

    void
    set(const unsigned int i,
        const unsigned int j,
        const double new_gap,
        const double traction)
    {
      gap[column(i, j)]     = new_gap;
      total[column(i, j)]   = traction;
      contact[column(i, j)] = 0.6 * traction;
    }
  };
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Leaflet leaflet = cylinder();
  const Coaptation coaptation(leaflet);
  const Belt closed(leaflet.columns.size());
  const auto evaluate = [&](const Belt &belt) {
    return coaptation.evaluate(belt.gap, belt.contact, belt.total, belt.area);
  };

  const auto whole = evaluate(closed);
  check("closed belt is continuous",
        whole.continuous && whole.longest_gap == 0 &&
          whole.posterior.missing_columns == 0);
  check_relative("area of one side", whole.area, 0.5 * 72 * 5e-6, 1e-12);
  check_relative("force of one side", whole.force, 1.8, 1e-12);
  check_relative("part of contact", whole.contact_fraction, 0.6, 1e-12);
  check_relative("largest traction", whole.max_traction, 10e3, 1e-12);
  check_relative("height of coaptation",
                 whole.anterior.mean_height,
                 4.5 * row_height,
                 1e-12);

  // A hole of 5 lines at mid-posterior (line 54), through all rows.
  Belt open = closed;
  for (unsigned int i = 52; i < 57; ++i)
    for (unsigned int j = 8; j <= n_rows; ++j)
      open.set(i, j, 1e-2, 0);
  const auto hole = evaluate(open);
  check("a hole interrupts its leaflet only",
        !hole.continuous && hole.anterior.continuous &&
          !hole.posterior.continuous);
  check("length of the hole",
        hole.longest_gap == 5 && hole.posterior.longest_gap == 5 &&
          hole.posterior.missing_columns == 5,
        hole.posterior.missing_columns);

  // A hole that leaves one row is none.
  Belt narrow = closed;
  for (unsigned int i = 10; i < 20; ++i)
    for (unsigned int j = 9; j <= n_rows; ++j)
      narrow.set(i, j, 1e-2, 0);
  check("a belt may be narrow", evaluate(narrow).anterior.continuous);

  // The peak is that of the belt, however narrow it is.
  Belt thread = closed;
  for (unsigned int i = 0; i < n_angles; ++i)
    for (unsigned int j = 8; j <= n_rows; ++j)
      if (j != 10)
        thread.set(i, j, 1e-2, 0);
  check_relative("largest traction of one row",
                 evaluate(thread).max_traction,
                 10e3,
                 1e-12);

  // Nor is a line without pressure a gap, where the leaflets touch.
  Belt spot = closed;
  for (unsigned int j = 8; j <= n_rows; ++j)
    spot.set(30, j, 0.5e-3, 0);
  check("a spot without pressure is no gap",
        evaluate(spot).anterior.continuous);

  // Every line coaptates somewhere, but the pieces do not meet.
  Belt split = closed;
  for (unsigned int i = 18; i < 40; ++i)
    for (unsigned int j = 8; j <= n_rows; ++j)
      {
        split.set(i, j, 1e-2, 0);
        split.set(i, j - 7, 0.5e-3, 10e3);
      }
  const auto pieces = evaluate(split);
  check("pieces that do not meet are no belt",
        !pieces.anterior.continuous && pieces.anterior.longest_gap == 0 &&
          pieces.anterior.missing_columns == 2,
        pieces.anterior.missing_columns);

  // The filter: noise of single columns averages out, constants stay.
  std::vector<double> noise(leaflet.columns.size());
  for (unsigned int c = 0; c < noise.size(); ++c)
    noise[c] = 10e3 + (c % 2 ? 30e3 : -30e3);
  const std::vector<double> touching(noise.size(), 0.);
  const auto smooth = coaptation.average(noise, touching, closed.area);
  double worst      = 0;
  for (const double value : smooth)
    worst = std::max(worst, std::abs(value - 10e3));
  check("averaging removes alternation", worst < 11e3, worst);
}
