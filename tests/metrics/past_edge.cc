// Columns of the longer leaflet that hang past the free edge of the shorter one
// do not coapt; those of its round edge do.

#include <coapt/contact/facing_rule.h>
#include <coapt/metrics/past_edge.h>

#include "cylinder_leaflet.h"
#include "tests.h"

using namespace coapt;
using dealii::Point;

namespace
{
  constexpr double gap = 0.4e-3;

  const Leaflet leaflet = cylinder();
  const auto triangles  = triangulate(leaflet.quads);

  bool
  of_first_sheet(const unsigned int c)
  {
    return c / (n_rows + 1) < n_angles / 2;
  }

  /** Two upright parallel sheets, the second one longer by @p difference. */
  std::vector<Point<3>>
  two_sheets(const double difference)
  {
    std::vector<Point<3>> points;
    for (unsigned int i = 0; i < n_angles; ++i)
      for (unsigned int j = 0; j <= n_rows; ++j)
        {
          const bool first    = i < n_angles / 2;
          const double height = n_rows * row_height + (first ? 0. : difference);
          points.emplace_back(1e-3 * (first ? i : n_angles - 1 - i),
                              first ? 0. : leaflet.thickness + gap,
                              -height * j / n_rows);
        }
    return points;
  }

  /** The nearest triangle of the other sheet, as contact finds it. */
  std::vector<unsigned int>
  nearest_of_other(const std::vector<Point<3>> &points)
  {
    const FacingRule rule(triangles, points.size());
    std::vector<unsigned int> partner(points.size());
    for (unsigned int c = 0; c < points.size(); ++c)
      {
        double nearest = 1e300;
        for (unsigned int t = 0; t < triangles.size(); ++t)
          {
            bool other = true; // not one that bridges the sheets either
            for (const unsigned int corner : triangles[t])
              other = other && of_first_sheet(corner) != of_first_sheet(c);
            const Encounter found = rule.encounter(points, c, t);
            if (other && found.distance < nearest)
              {
                nearest    = found.distance;
                partner[c] = t;
              }
          }
      }
    return partner;
  }

  /** Whether exactly those columns of the second sheet that lie lower than
   * @p lowest (m) are past the edge. */
  bool
  ends_at(const double difference, const double lowest)
  {
    const auto points = two_sheets(difference);
    const auto past   = PastEdge(leaflet)(points, nearest_of_other(points));
    bool as_expected  = true;
    for (unsigned int c = 0; c < points.size(); ++c)
      as_expected =
        as_expected && past[c] == (!of_first_sheet(c) && points[c][2] < lowest);
    return as_expected;
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double edge = -(n_rows * row_height + 0.5 * leaflet.thickness);
  check("sheets of one length coapt down to their edges", ends_at(0, -1));
  check("so does one that is longer by less than the edge is round",
        ends_at(0.4 * leaflet.thickness, -1));
  check("a longer one coapts down to the edge of the other",
        ends_at(4.1e-3, edge));

  const std::vector<unsigned int> none(leaflet.columns.size(), -1);
  const auto past = PastEdge(leaflet)(two_sheets(4e-3), none);
  check("what faces nothing is past no edge",
        std::count(past.begin(), past.end(), true) == 0);
}
