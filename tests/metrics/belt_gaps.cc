// Gaps in belts of coaptation on a cylinder, upright and pressed flat, whose
// places and lengths are known.

#include <coapt/metrics/belt_graph.h>

#include "cylinder_leaflet.h"
#include "tests.h"

using namespace coapt;
using dealii::Point;

namespace
{
  // between neighbouring columns of a row
  const double chord = 2 * radius * std::sin(M_PI / n_angles);

  const Leaflet leaflet = cylinder();
  const LeafletLines lines(leaflet);
  const BeltGraph graph(leaflet);
  const auto upright = mid_surface(leaflet);

  // The lines of the posterior leaflet are 32 to 76 (= 4) from left to right,
  // those of the anterior one 30 to 6.
  constexpr unsigned int first_posterior = 32, first_anterior = 30;

  std::vector<BeltGap>
  posterior_gaps(const std::vector<bool> &coapts)
  {
    return graph.gaps(lines.posterior, coapts, upright);
  }

  /** Opens the belt from line @p begin to @p end. */
  void
  open(const unsigned int begin,
       const unsigned int end,
       std::vector<bool> &coapts)
  {
    for (unsigned int i = begin; i < end; ++i)
      for (unsigned int j = 0; j <= n_rows; ++j)
        coapts[column(i, j)] = false;
  }

  void
  one_gap()
  {
    check("a whole belt has no gap",
          posterior_gaps(belt_without(0, 0)).empty());

    const auto torn = belt_without(52, 57);
    const auto gaps = posterior_gaps(torn);
    check("one gap of five columns",
          gaps.size() == 1 && gaps[0].columns == 5,
          gaps.size());
    check_relative("length of the gap", gaps.at(0).length, 6 * chord, 1e-9);
    check_relative("its position on the edge",
                   gaps.at(0).position,
                   (54 - first_posterior) * chord,
                   1e-9);
    const auto &middle = upright[column(54, n_rows)];
    check("its place",
          std::hypot(gaps[0].place[0] - middle[0],
                     gaps[0].place[1] - middle[1]) < 1e-12 &&
            gaps[0].place[2] < -7.9e-3);
    check("the other leaflet has none",
          graph.gaps(lines.anterior, torn, upright).empty());

    const auto anterior =
      graph.gaps(lines.anterior, belt_without(26, 29), upright);
    check_relative("positions on the anterior leaflet are from its left",
                   anterior.at(0).position,
                   (first_anterior - 27) * chord,
                   1e-9);
  }

  void
  two_gaps()
  {
    auto coapts = belt_without(40, 43);
    open(60, 61, coapts);
    const auto gaps = posterior_gaps(coapts);
    check("two gaps, from left to right",
          gaps.size() == 2 && gaps[0].columns == 3 && gaps[1].columns == 1,
          gaps.size());
    check_relative("length of the first", gaps.at(0).length, 4 * chord, 1e-9);
    check_relative("its position",
                   gaps.at(0).position,
                   (41 - first_posterior) * chord,
                   1e-9);
    check_relative("length of the second", gaps.at(1).length, 2 * chord, 1e-9);
    check_relative("its position",
                   gaps.at(1).position,
                   (60 - first_posterior) * chord,
                   1e-9);
  }

  /** Gaps that reach an end of the leaflet begin or end there. */
  void
  gaps_at_the_ends()
  {
    auto coapts = belt_without(32, 35);
    open(75, 77, coapts); // the last of which is line 4
    open(4, 5, coapts);
    const auto gaps = posterior_gaps(coapts);
    check("gaps at both ends",
          gaps.size() == 2 && gaps[0].columns == 3 && gaps[1].columns == 2,
          gaps.size());
    check_relative("length on the left", gaps.at(0).length, 3 * chord, 1e-9);
    check_relative("position on the left", gaps.at(0).position, chord, 1e-9);
    check_relative("length on the right", gaps.at(1).length, 2 * chord, 1e-9);
    check_relative("position on the right",
                   gaps.at(1).position,
                   43 * chord,
                   1e-9);
  }

  /** On the left the belt is in rows 8 to 12, on the right in rows 1 to 4: the
   * shortest way comes down by four diagonals. */
  void
  step_of_the_belt()
  {
    std::vector<bool> coapts = belt_without(54, n_angles);
    for (unsigned int i = 54; i < 77; ++i)
      for (unsigned int j = 1; j <= 4; ++j)
        coapts[column(i, j)] = true;
    const auto gaps = posterior_gaps(coapts);
    check("a step of the belt is one gap of three columns",
          gaps.size() == 1 && gaps[0].columns == 3,
          gaps.size());
    check_relative("length of the way across",
                   gaps.at(0).length,
                   4 * std::hypot(row_height, chord),
                   1e-9);
  }

  /** A cylinder pressed flat: what counts are lengths of the closed leaflet,
   * which go back and forth around its ends. */
  void
  flat_leaflet()
  {
    auto flat = upright;
    for (Point<3> &x : flat)
      x[1] = 0;
    const auto gaps  = graph.gaps(lines.posterior, belt_without(52, 57), flat);
    const auto angle = [](const unsigned int i) {
      return 2 * M_PI * i / n_angles;
    };
    // from 160 degrees to 180 and back, and on to 270
    check_relative("position on the closed leaflet",
                   gaps.at(0).position,
                   radius * (2 + std::cos(angle(first_posterior))),
                   1e-9);
    check_relative("length on the closed leaflet",
                   gaps.at(0).length,
                   radius * (std::cos(angle(57)) - std::cos(angle(51))),
                   1e-9);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  one_gap();
  two_gaps();
  gaps_at_the_ends();
  step_of_the_belt();
  flat_leaflet();
}
