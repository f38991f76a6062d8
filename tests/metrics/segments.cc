// Coaptation by line and by segment, A1 to P3, of leaflets that coapt where the
// test says.

#include <coapt/metrics/coaptation.h>

#include "cylinder_leaflet.h"
#include "tests.h"

using namespace coapt;

namespace
{
  const Leaflet leaflet = cylinder();

  void
  profile_of_a_third()
  {
    const LeafletLines lines(leaflet);
    const auto points = mid_surface(leaflet);
    // the left third of the anterior leaflet (lines 30 to 22) does not coapt
    const auto coapts = belt_without(22, 31);
    const auto whole  = belt_without(0, 0);
    std::vector<double> traction(points.size(), 5e3);
    auto stretched = points;
    for (auto &x : stretched)
      x[2] *= 1.5;
    const auto profile = coaptation_profile(
      lines.anterior, lines.height, coapts, whole, traction, points, stretched);
    const auto segments      = coaptation_by_segment(profile, 'A');
    const double half_column = 0.5 * row_height;
    check_relative("positions run from 0 to 1",
                   profile.back().position,
                   1,
                   1e-12);
    check("names of segments",
          segments[0].name == "A1" && segments[2].name == "A3");
    check("A1 does not coapt", segments[0].contact_height == 0);
    check_relative("height of A3 in contact",
                   segments[2].contact_height,
                   4 * row_height + half_column,
                   1e-9);
    check_relative("apposition is measured on the closed leaflet",
                   segments[0].apposition,
                   1.5 * (4 * row_height + half_column),
                   1e-9);
    check_relative("largest traction", profile.back().max_traction, 5e3, 1e-12);
  }

  /** Thirds of a made-up profile. */
  void
  thirds()
  {
    const auto segments = coaptation_by_segment({{0, 2e-3, 3e-3, 0},
                                                 {0.2, 4e-3, 5e-3, 0},
                                                 {0.3, 0, 1e-3, 0},
                                                 {0.4, 6e-3, 7e-3, 0},
                                                 {0.7, 8e-3, 9e-3, 0},
                                                 {1, 5e-3, 8e-3, 0}},
                                                'P');
    const std::array<double, 3> height = {{2e-3, 6e-3, 6.5e-3}},
                                least  = {{0, 6e-3, 5e-3}},
                                beside = {{3e-3, 7e-3, 8.5e-3}};
    double error                       = 0;
    for (unsigned int i = 0; i < 3; ++i)
      {
        check("name of a third",
              segments[i].name == "P" + std::to_string(i + 1));
        for (const double difference :
             {segments[i].contact_height - height[i],
              segments[i].min_contact_height - least[i],
              segments[i].apposition - beside[i]})
          error = std::max(error, std::abs(difference));
      }
    check("means and least height of thirds", error < 1e-15, error);

    const auto left = coaptation_by_segment({{0.1, 2e-3, 3e-3, 0}}, 'P');
    check("thirds without lines",
          left[1].contact_height == 0 && left[1].apposition == 0 &&
            left[2].min_contact_height == 0);
  }

  /** What columns of a closed cylinder feel: all lie beside another part from
   * row 6 on. On the posterior leaflet the lowest 2, 4 and 7 rows of the three
   * thirds are pressed; of the anterior one the lowest 2, in the 9 lines on
   * the left. */
  struct ClosedCylinder
  {
    std::vector<double> gap, traction, area;

    ClosedCylinder()
      : gap(leaflet.columns.size(), 1e-2)
      , traction(gap.size(), 0.)
      , area(gap.size(), 1e-6)
    {
      for (unsigned int i = 0; i < n_angles; ++i)
        for (unsigned int j = 6; j <= n_rows; ++j)
          gap[column(i, j)] = 0.5e-3;
      for (unsigned int k = 0; k < 45; ++k)
        press(32 + k, k < 15 ? 2 : k < 30 ? 4 : 7, 10e3);
      for (unsigned int k = 0; k < 9; ++k)
        press(30 - k, 2, 10e3);
    }

    /** Presses the lowest rows of a line. */
    void
    press(const unsigned int i, const unsigned int n, const double pressure)
    {
      for (unsigned int j = 0; j <= n_rows; ++j)
        traction[column(i, j)] = j + n > n_rows ? pressure : 0.;
    }
  };

  void
  segments_of_a_valve()
  {
    CoaptationSettings settings;
    settings.filter_radius = settings.belt_radius = 0;
    const Coaptation coaptation(leaflet, settings);
    ClosedCylinder state;
    // One line is pressed by less than the least traction, one more than the
    // others.
    state.press(32 + 20, 4, 199);
    state.press(32 + 40, 1, 30e3);

    auto closed = mid_surface(leaflet);
    for (auto &x : closed)
      x[2] *= 2;
    const auto profile =
      coaptation.profile(state.gap, state.traction, state.area, closed);
    const auto anterior  = coaptation_by_segment(profile[0], 'A'),
               posterior = coaptation_by_segment(profile[1], 'P');

    const auto height = [](const unsigned int rows) {
      return (rows - 0.5) * row_height;
    };
    check_relative("P1", posterior[0].contact_height, height(2), 1e-9);
    check_relative("P2, a line less",
                   posterior[1].contact_height,
                   14. / 15 * height(4),
                   1e-9);
    check_relative("P3, one line with one row",
                   posterior[2].contact_height,
                   (14 * height(7) + height(1)) / 15,
                   1e-9);
    check_relative("least of P1",
                   posterior[0].min_contact_height,
                   height(2),
                   1e-9);
    check("least of P2", posterior[1].min_contact_height == 0);
    check_relative("least of P3",
                   posterior[2].min_contact_height,
                   height(1),
                   1e-9);
    check_relative("A1, on the left",
                   anterior[0].contact_height,
                   height(2),
                   1e-9);
    check("A3, on the right", anterior[2].contact_height == 0);
    for (unsigned int i = 0; i < 3; ++i)
      {
        check_relative("apposition of " + posterior[i].name,
                       posterior[i].apposition,
                       2 * height(7),
                       1e-9);
        check_relative("apposition of " + anterior[i].name,
                       anterior[i].apposition,
                       2 * height(7),
                       1e-9);
      }
    check_relative("largest traction of a line",
                   profile[1][40].max_traction,
                   30e3,
                   1e-12);
    check("a line that does not coapt has none",
          profile[1][20].max_traction == 0);

    const auto gaps =
      coaptation.gaps(state.gap, state.traction, state.area, closed);
    check("gaps of both leaflets",
          gaps[0].size() == 1 && gaps[0][0].columns == 16 &&
            gaps[1].size() == 1 && gaps[1][0].columns == 1);
    check_relative("length of the posterior gap",
                   gaps[1].at(0).length,
                   4 * radius * std::sin(M_PI / n_angles),
                   1e-9);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  profile_of_a_third();
  thirds();
  segments_of_a_valve();
}
