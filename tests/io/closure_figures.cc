// Figures and tables of a closed valve of known shape: an upright elliptic tube
// whose lower part is pressed flat.

#include <coapt/base/csv_table.h>
#include <coapt/base/units.h>
#include <coapt/io/closure_figures.h>

#include <boost/property_tree/json_parser.hpp>

#include <algorithm>
#include <sstream>

#include "../structure/upright_valve.h"
#include "tests.h"

using namespace coapt;
using namespace coapt::units;
using dealii::Point;

namespace
{
  using Figures = boost::property_tree::ptree;

  Figures
  read(const Summary &summary)
  {
    std::istringstream text(summary.json());
    Figures result;
    boost::property_tree::read_json(text, result);
    return result;
  }

  /** Relative tolerance of figures, which have nine digits. */
  constexpr double digits = 1e-8;

  const double row_height = upright_height / upright_rows;

  // The tube is flat from the third row on, and stretched along its height.
  constexpr double flatness = 0.05, stretch = 1.2;
  constexpr int first_flat_row = 3;

  Point<3>
  closed(const Point<3> &x)
  {
    const bool is_flat = x[2] < -(first_flat_row - 0.1) * row_height;
    return Point<3>(x[0], (is_flat ? flatness : 1.) * x[1], stretch * x[2]);
  }

  /** Angle (degrees, 20 to 370) and row below the annulus of a column. */
  struct Place
  {
    Place(const Leaflet &leaflet, const unsigned int column)
    {
      const auto &[t, s] = leaflet.column_coordinates[column];
      angle              = std::lround(t / ValveParameters::degree);
      angle += angle < 20 ? 360 : 0;
      row = std::lround(s * upright_rows);
    }

    int angle, row;
  };

  /** A traction (Pa) of each column, half of it by contact. */
  MeanTractions
  tractions(const Leaflet &leaflet,
            const std::function<double(const Place &)> &of_place)
  {
    MeanTractions result;
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      {
        result.total.push_back(of_place(Place(leaflet, c)));
        result.contact.push_back(0.5 * result.total.back());
      }
    return result;
  }

  /** Point of the annulus at an angle (degrees), with its y scaled. */
  Point<3>
  on_ellipse(const int angle, const double scale = 1)
  {
    const double t = angle * ValveParameters::degree;
    return Point<3>(upright_a * std::cos(t),
                    scale * upright_b * std::sin(t),
                    0);
  }

  /** Length (m) from column to column of a row between two angles. */
  double
  length(const int begin, const int end, const double scale = 1)
  {
    double sum = 0;
    for (int t = std::min(begin, end); t < std::max(begin, end); t += 10)
      sum += on_ellipse(t, scale).distance(on_ellipse(t + 10, scale));
    return sum;
  }

  /** Height (m) that the lowest rows of a line stand for. */
  double
  height(const int n_of_rows)
  {
    return (n_of_rows - 0.5) * row_height;
  }

  /** Length (m) of the line at this angle that lies beside another part: the
   * flat rows, and half of the way to the one above them. */
  double
  apposition(const int angle)
  {
    const double across = (1 - flatness) * on_ellipse(angle)[1];
    return stretch * (upright_rows - first_flat_row) * row_height +
      0.5 * std::hypot(stretch * row_height, across);
  }

  /** The anterior leaflet is that from 150 to 30 degrees, the posterior one
   * that from 160 to 380, and their thirds by the length of the annulus, from
   * left to right, end at 110, 80, and at 230, 300 degrees. */
  void
  check_segments(const ObservedValve &tube)
  {
    // On A1 only two rows are pressed, and nothing from 290 to 310 degrees.
    const auto pressed = tractions(tube.valve.leaflet, [](const Place &place) {
      const bool is_a1   = place.angle >= 110 && place.angle <= 150;
      const bool is_open = place.angle >= 290 && place.angle <= 310;
      return place.row >= (is_a1 ? 5 : first_flat_row) && !is_open ? 5e3 : 0.;
    });
    const Figures figures =
      read(segment_figures(tube.valve, tube.monitor, pressed));
    const auto check_segment = [&](const std::string &name,
                                   const int first,
                                   const int last,
                                   const double mean,
                                   const double least) {
      const auto figure = [&](const std::string &of) {
        return figures.get<double>(name + "." + of);
      };
      check_relative(name + ", height in contact",
                     figure("contact_height_mm"),
                     mean / millimetre,
                     digits);
      check(name + ", least height in contact",
            std::abs(figure("contact_height_min_mm") - least / millimetre) <
              digits,
            figure("contact_height_min_mm"));
      double beside      = 0;
      unsigned int lines = 0;
      for (int t = first; t <= last; t += 10, ++lines)
        beside += apposition(t);
      check_relative(name + ", apposition",
                     figure("apposition_mm"),
                     beside / lines / millimetre,
                     digits);
    };
    check("there are six segments", figures.size() == 6, figures.size());
    check_segment("A1", 110, 150, height(2), height(2));
    check_segment("A2", 80, 100, height(4), height(4));
    check_segment("A3", 30, 70, height(4), height(4));
    check_segment("P1", 160, 230, height(4), height(4));
    check_segment("P2", 240, 300, 5. / 7 * height(4), 0);
    check_segment("P3", 310, 380, 7. / 8 * height(4), 0);

    const Figures gaps = read(gap_figures(tube.valve, tube.monitor, pressed));
    check("there is one gap",
          gaps.get<unsigned int>("number") == 1 && gaps.size() == 2);
    const auto of_gap = [&](const std::string &name) {
      return gaps.get<double>("gap_1." + name);
    };
    check("it is in the posterior leaflet",
          gaps.get<std::string>("gap_1.leaflet") == "posterior");
    check_relative("its position along the closed free edge",
                   of_gap("position_mm"),
                   length(160, 300, flatness) / millimetre,
                   digits);
    check_relative("its length",
                   of_gap("length_mm"),
                   length(280, 320, flatness) / millimetre,
                   digits);
    const Point<3> middle = on_ellipse(300, flatness);
    for (unsigned int d = 0; d < 2; ++d)
      check_relative(std::string("its place, ") + "xy"[d],
                     of_gap(std::string(1, "xy"[d]) + "_mm"),
                     middle[d] / millimetre,
                     digits);
  }

  /** Different stretches of anterior and posterior leaflet. */
  void
  check_regions(const ModelParameters &parameters)
  {
    const std::array<double, 2> stretches = {{1.3, 1.1}};
    ObservedValve tube(parameters);
    tube.sample(0, tube.state([&](const Point<3> &x) {
      const bool is_anterior =
        std::atan2(x[1] / upright_b, std::abs(x[0]) / upright_a) >
        25 * ValveParameters::degree;
      return Point<3>(x[0], x[1], stretches[is_anterior ? 0 : 1] * x[2]);
    }));
    const Figures figures = read(region_figures(tube.valve, tube.monitor));
    const auto &tissue    = parameters.solid.neo_hookean;
    for (unsigned int i = 0; i < 2; ++i)
      {
        const std::string name = i == 0 ? "anterior" : "posterior";
        const double s         = stretches[i];
        // of the Cauchy stress (mu (b - 1) + lambda ln J)/J
        const double von_mises = tissue.mu * (s * s - 1) / s,
                     principal = von_mises + tissue.lambda * std::log(s) / s;
        for (const std::string kind : {"mean", "95_percent"})
          {
            const auto figure = [&](const std::string &quantity,
                                    const std::string &unit) {
              return figures.get<double>(name + "." + quantity + "_" + kind +
                                         unit);
            };
            check_relative(name + ", strain, " + kind,
                           figure("strain", ""),
                           std::log(s),
                           1e-6);
            check_relative(name + ", stress, " + kind,
                           figure("stress", "_kPa"),
                           von_mises / kilopascal,
                           1e-6);
            check_relative(name + ", principal stress, " + kind,
                           figure("principal_stress", "_kPa"),
                           principal / kilopascal,
                           1e-6);
          }
      }
    const double mean = figures.get<double>("commissures.strain_mean"),
                 most = figures.get<double>("commissures.strain_95_percent");
    check("mean and largest strain of commissures, which shear",
          mean > std::log(1.1) && mean < 0.95 * most,
          mean);
    check("a mitral valve has no septal leaflet",
          figures.count("septal") == 0 && figures.count("root") == 1);
  }

  /** Leaflets that have turned over into a cone on the annulus, open at a
   * quarter of its width, 6 mm high if it were not. The thickness, by the
   * elliptic radius, is not quite symmetric to the middle. */
  void
  check_bulging(const ModelParameters &parameters)
  {
    const double cone = 6e-3, end = 0.25;
    ObservedValve tube(parameters);
    const ValveSample sample =
      tube.sample(0, tube.state([&](const Point<3> &x) {
        const double width = 1 + (1 - end) * x[2] / upright_height,
                     depth = std::hypot(x[0] / upright_a, x[1] / upright_b) - 1;
        return Point<3>(width * x[0],
                        width * x[1],
                        cone * (1 - width) - upright_b * depth);
      }));
    const double polygon = 0.5 * upright_around *
      std::sin(2 * M_PI / upright_around) * upright_a * upright_b;
    // Integral of 2 r (1 - r) from the end to the annulus. In angles of the
    // ellipse, sectors of equal angle have equal areas.
    const double volume =
      cone * polygon * (1. / 3 - end * end + 2. / 3 * end * end * end);
    const Figures figures = read(region_figures(tube.valve, tube.monitor));
    const auto check_part = [&](const std::string &name, const double degrees) {
      check_relative("bulging of the " + name,
                     figures.get<double>(name + ".bulging_volume_mL"),
                     degrees / 360 * volume / millilitre,
                     2e-3);
    };
    check_part("anterior", 120);
    check_part("posterior", 220);
    check_part("commissures", 20);
    check("the root does not bulge",
          std::abs(figures.get<double>("root.bulging_volume_mL")) < 1e-9);
    check_relative("bulging of all", sample.bulging_volume, volume, 2e-3);
  }

  /** Tables of the valve with 3.2, 5.2 and 9.2 kPa on the lowest three rows. */
  void
  check_tables(const ObservedValve &tube)
  {
    const auto pressed = tractions(tube.valve.leaflet, [](const Place &place) {
      return place.row < 4 ? 0.
        : place.row == 4   ? 3.2e3
        : place.row == 5   ? 5.2e3
                           : 9.2e3;
    });
    write_closure_maps(tube.valve,
                       tube.monitor,
                       pressed,
                       [](const std::string &name) { return "tube_" + name; });

    const CsvTable profile("tube_coaptation.csv");
    std::vector<int> angles;
    for (int t = 150; t >= 30; t -= 10)
      angles.push_back(t);
    for (int t = 160; t <= 380; t += 10)
      angles.push_back(t);
    const auto leaflet  = profile.numbers("leaflet"),
               position = profile.numbers("position"),
               contact  = profile.numbers("contact_height_mm"),
               beside   = profile.numbers("apposition_mm"),
               most     = profile.numbers("pressure_max_kPa");
    check("lines of both leaflets",
          profile.n_rows() == angles.size(),
          profile.n_rows());
    double error = 0;
    for (unsigned int i = 0; i < angles.size(); ++i)
      {
        const bool is_anterior = i < 13;
        const double place     = is_anterior
              ? length(angles[i], 150) / length(30, 150)
              : length(160, angles[i]) / length(160, 380);
        for (const double difference :
             {leaflet[i] - (is_anterior ? 0 : 1),
              position[i] - place,
              contact[i] - height(3) / millimetre,
              beside[i] - apposition(angles[i]) / millimetre,
              most[i] - 9.2})
          error = std::max(error, std::abs(difference));
      }
    check("the table of the belt", error < 1e-8, error);

    // The last row stands for half a strip.
    const CsvTable distribution("tube_pressure_distribution.csv");
    const auto p          = distribution.numbers("pressure_kPa"),
               by_contact = distribution.numbers("share_contact"),
               by_all     = distribution.numbers("share_coaptation");
    const auto share      = [](const double p, const double factor) {
      return p < 3.2 * factor ? 1.
             : p < 5.2 * factor    ? 0.6
             : p < 9.2 * factor    ? 0.2
                                   : 0.;
    };
    error = 0;
    for (unsigned int i = 0; i < p.size(); ++i)
      for (const double difference : {p[i] - 0.5 * i,
                                      by_contact[i] - share(p[i], 0.5),
                                      by_all[i] - share(p[i], 1)})
        error = std::max(error, std::abs(difference));
    check("distribution of the pressure", error < 1e-8, error);
  }

  /** Where the tube is cut by a plane x = @p x (m), half its width. */
  double
  half_width(const double x)
  {
    int t = 90;
    while (on_ellipse(t - 10)[0] < std::abs(x))
      t -= 10;
    const Point<3> a = on_ellipse(t), b = on_ellipse(t - 10);
    return a[1] + (std::abs(x) - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
  }

  void
  check_sections(const ObservedValve &tube)
  {
    const CsvTable table("tube_sections.csv");
    const auto x = table.numbers("x_mm"), is_closed = table.numbers("closed"),
               y = table.numbers("y_mm"), z = table.numbers("z_mm"),
               curve = table.numbers("curve");
    for (const double fraction : {-0.5, 0., 0.5})
      for (const bool closed : {false, true})
        {
          const double plane = fraction * tube.valve.lumen.semi_axis_x();
          const double width = half_width(plane);
          double error = 0, top = -1, bottom = 1, sides = 0;
          unsigned int n = 0;
          for (unsigned int i = 0; i < x.size(); ++i)
            {
              const double depth =
                -z[i] * millimetre / row_height / (closed ? stretch : 1);
              if (std::abs(x[i] * millimetre - plane) > 1e-9 ||
                  closed != (is_closed[i] == 1) ||
                  (closed && depth > first_flat_row - 0.99 &&
                   depth < first_flat_row - 0.01))
                continue; // another cut, or where the tube narrows
              ++n;
              const bool is_flat = closed && depth > first_flat_row - 0.5;
              error              = std::max(error,
                               std::abs(std::abs(y[i] * millimetre) -
                                        (is_flat ? flatness : 1) * width));
              top                = std::max(top, z[i] * millimetre);
              bottom             = std::min(bottom, z[i] * millimetre);
              sides              = std::max(sides, curve[i] + 1);
            }
          const double s         = closed ? stretch : 1;
          const std::string name = std::string(closed ? "closed" : "open") +
            ", x = " + std::to_string(fraction).substr(0, 4) + ": ";
          check(name + "two sides", sides == 2 && n >= 14, sides);
          check(name + "where they are", error < 1e-8, error);
          check(name + "from the root to the free edge",
                std::abs(top - s * upright_root) < 1e-9 &&
                  std::abs(bottom + s * upright_height) < 1e-9,
                bottom);
        }
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const ModelParameters parameters = upright_valve();
  ObservedValve tube(parameters);
  tube.sample(0, tube.state(closed));
  check_segments(tube);
  check_tables(tube);
  check_sections(tube);
  check_regions(parameters);
  check_bulging(parameters);
}
