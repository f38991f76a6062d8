// Lines, unrolled leaflets, orifices, sections and histories of contact of
// shapes with known answers.

#include <coapt/geometry/boundary_faces.h>
#include <coapt/metrics/contact_history.h>
#include <coapt/metrics/loads.h>
#include <coapt/metrics/orifice.h>
#include <coapt/metrics/surface_section.h>
#include <coapt/metrics/unrolled_leaflet.h>

#include "cylinder_leaflet.h"
#include "tests.h"

#include <algorithm>
#include <numeric>

using namespace coapt;
using dealii::Point;

namespace
{
  using Triangles = std::vector<std::array<unsigned int, 3>>;

  void
  check_lines(const Leaflet &leaflet, const LeafletLines &lines)
  {
    // lines 6 to 30 and 32 to 76 (= 4) touch the two leaflets
    check("number of lines of each leaflet",
          lines.anterior.size() == 25 && lines.posterior.size() == 45,
          lines.posterior.size());
    const auto x = [&](const LeafletLines::Lines &of_leaflet) {
      return middle_of_column(leaflet, of_leaflet.front().front())[0];
    };
    check("lines begin at the left",
          x(lines.anterior) < 0 && x(lines.posterior) < 0);
    check_relative("depth of the free edge",
                   lines.depth[lines.anterior[0].back()],
                   n_rows * row_height,
                   1e-12);
    check_relative(
      "heights of a line add up to its length",
      std::accumulate(lines.height.begin(), lines.height.end(), 0.) / n_angles,
      n_rows * row_height,
      1e-12);

    Leaflet without_edge = leaflet;
    without_edge.free_edge_columns.clear();
    check("a leaflet without free edge is refused",
          error_of([&] {
            LeafletLines{without_edge};
          }).find("needs a free edge") != std::string::npos);
  }

  void
  check_unrolled(const Leaflet &leaflet, const LeafletLines &lines)
  {
    const UnrolledLeaflet map(leaflet, lines);
    double area = 0;
    for (const auto &[a, b, c] : map.triangles)
      {
        const auto u = map.points[b] - map.points[a],
                   v = map.points[c] - map.points[a];
        area += 0.5 * std::abs(u[0] * v[1] - u[1] * v[0]);
      }
    check_relative("area of the unrolled cylinder",
                   area,
                   2 * M_PI * radius * n_rows * row_height,
                   1e-9);
    check("points on the cut are there twice",
          map.points.size() == leaflet.columns.size() + n_rows + 1,
          map.points.size());

    // Line 18 is mid-anterior, line 30 at 150 degrees on the left.
    std::vector<double> numbers(leaflet.columns.size());
    std::iota(numbers.begin(), numbers.end(), 0.);
    const auto of_points = map.on_points(numbers);
    const auto place     = [&](const unsigned int c) {
      return map.points.at(std::find(of_points.begin(), of_points.end(), c) -
                           of_points.begin());
    };
    check("mid-anterior is in the middle, the annulus at the top",
          place(column(18, 0)).norm() < 1e-12,
          place(column(18, 0)).norm());
    const double left = -radius * 60 * M_PI / 180;
    check("the left commissure is on the left",
          place(column(30, 5)).distance(Point<3>(left, -5 * row_height, 0)) <
            1e-12,
          place(column(30, 5))[0]);
  }

  /** The jet of a hole with a sharp edge agrees with what is seen of the hole;
   * not that of a hole three times as large, nor one that is not seen. */
  void
  check_jet(const double seen)
  {
    const double pressure = 13e3, density = 1060, contraction = 0.61;
    const double flow = contraction * seen * std::sqrt(2 * pressure / density);
    const double jet  = effective_orifice_area(flow, pressure, density);
    check_relative("contraction of the jet", jet / seen, contraction, 1e-12);
    check("jet and orifice agree", orifices_agree(seen, jet, 3));
    check("they do not with three times the leak of Bernoulli's law",
          !orifices_agree(seen, 3.01 / contraction * jet, 3));
    check("nor with a quarter of it",
          !orifices_agree(seen, 0.25 / contraction * jet, 3));
    check("nor if nothing is seen", !orifices_agree(0, jet, 3));
    check("nothing seen, no leak", orifices_agree(0, 0, 3));
  }

  /** A plate of 30 x 20 mm with a hole of @p a x @p b at (3, -2) mm, tilted. */
  void
  check_orifice(const double a, const double b)
  {
    const std::array<double, 4>
      x = {{-15e-3, 3e-3 - a / 2, 3e-3 + a / 2, 15e-3}},
      y = {{-10e-3, -2e-3 - b / 2, -2e-3 + b / 2, 10e-3}};
    std::vector<Point<3>> points;
    Triangles triangles;
    for (unsigned int j = 0; j < 4; ++j)
      for (unsigned int i = 0; i < 4; ++i)
        points.emplace_back(x[i], y[j], 0.3 * x[i]);
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int i = 0; i < 3; ++i)
        if (i != 1 || j != 1)
          {
            const unsigned int k = i + 4 * j;
            triangles.push_back({{k, k + 1, k + 5}});
            triangles.push_back({{k, k + 5, k + 4}});
          }
    const auto everywhere = [](const Point<3> &) { return true; };
    const Orifice orifice = seen_orifice(points, triangles, everywhere, 2e-5);
    check_relative("area of a hole", orifice.area, a * b, 0.02);
    check("largest disc in it",
          std::abs(orifice.disc - std::min(a, b)) < 3e-5,
          orifice.disc);
    check("its centre",
          std::abs(orifice.center[1] + 2e-3) < 3e-5 || a < b,
          orifice.center[1]);
    const auto left = [](const Point<3> &p) { return p[0] < 3e-3; };
    check_relative("what is outside of the lumen does not count",
                   seen_orifice(points, triangles, left, 2e-5).area,
                   a * b / 2,
                   0.03);
  }

  void
  check_sections(const Leaflet &leaflet)
  {
    const auto points    = mid_surface(leaflet);
    const auto triangles = triangulate(leaflet.quads);
    const auto curves    = surface_section(points, triangles, 1e-4);
    check("a cut cylinder has two sides", curves.size() == 2, curves.size());
    double length = 0, worst = 0;
    for (const auto &curve : curves)
      for (unsigned int i = 0; i < curve.size(); ++i)
        {
          length += i > 0 ? curve[i].distance(curve[i - 1]) : 0.;
          worst = std::max(worst, std::abs(curve[i][0] - 1e-4));
        }
    check("points are on the plane", worst < 1e-15, worst);
    check_relative("length of the sides",
                   length,
                   2 * n_rows * row_height,
                   1e-4);

    // an octahedron: a closed curve
    const std::vector<Point<3>> corners = {
      {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    Triangles faces;
    for (const unsigned int i : {0, 1})
      for (const unsigned int j : {2, 3})
        for (const unsigned int k : {4, 5})
          faces.push_back({{i, j, k}});
    const auto closed = surface_section(corners, faces, 0.5);
    check("a closed curve ends where it begins",
          closed.size() == 1 &&
            closed[0].front().distance(closed[0].back()) < 1e-15 &&
            closed[0].size() == 5,
          closed.size());
  }

  /** Two columns of a plate slide along x above one of another plate, which
   * moves itself; the second one touches later and never stops to fall. */
  void
  check_history()
  {
    using Vector = dealii::Tensor<1, 3>;
    ContactHistory history(3, 0.5e-3, 1e-3);
    const std::vector<Vector> normals    = {Vector({0., 0., -1.}),
                                            Vector({0., 0., -1.}),
                                            Vector()};
    const std::vector<Vector> velocities = {Vector({3., 0., 0.}),
                                            Vector({3., 0., -5.}),
                                            Vector({1., 0., 0.})};
    const std::vector<Point<3>> points   = {{0, 0, 1.4e-3},
                                            {1e-4, 0, 1.4e-3},
                                            {0, 0, 0}};
    const std::vector<double> before     = {0.4e-3, 1., 1.},
                              after      = {0.4e-3, 0.4e-3, 1.};
    const std::vector<Vector> spins(3);
    history.update(1., {before, normals, points, velocities, spins});
    history.update(1.5, {after, normals, points, velocities, spins});
    check("first contact is remembered",
          history.first_times()[0] == 1. && history.first_times()[1] == 1.5 &&
            std::isnan(history.first_times()[2]));
    check_relative("way of sliding", history.slips()[0], 2 * 1.5, 1e-12);
    check_relative("falling is no sliding", history.slips()[1], 1., 1e-12);
    check("the other plate has no contact of its own", history.slips()[2] == 0);
  }

  /** Two plates that touch turn together by a radian and more, about the place
   * where they are: what turns as one body does not slip. If only the upper one
   * turns, half the distance of the mid-surfaces is the lever. */
  void
  check_history_of_turning_plates()
  {
    using Vector                       = dealii::Tensor<1, 3>;
    const std::vector<Vector> normals  = {Vector({0., 0., -1.}), Vector()};
    const std::vector<Point<3>> points = {{3e-3, 0, 1.4e-3}, {3.2e-3, 0, 0}};
    const std::vector<double> gap      = {0.4e-3, 1.};
    const Vector spin({0.3, 2., 0.1});
    const auto turned = [&](const bool lower) {
      ContactHistory history(2, 0.5e-3, 1e-3);
      std::vector<Vector> velocities, spins;
      for (unsigned int i = 0; i < 2; ++i)
        {
          const bool turns = i == 0 || lower;
          spins.push_back(turns ? spin : Vector());
          velocities.push_back(
            turns ? cross_product_3d(spin, points[i] - points[lower ? 1 : 0])
                  : Vector());
        }
      history.update(0.5, {gap, normals, points, velocities, spins});
      return history.slips()[0];
    };
    check("plates that turn together do not slip", turned(true) < 1e-15);
    check_relative("a plate that turns alone slips",
                   turned(false),
                   0.5 * 0.7e-3 * std::hypot(0.3, 2.),
                   1e-12);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Leaflet leaflet = cylinder();
  const LeafletLines lines(leaflet);
  check_lines(leaflet, lines);
  check_unrolled(leaflet, lines);
  check_orifice(6e-3, 2e-3);
  check_orifice(1e-3, 4e-3);
  check_jet(6e-3 * 2e-3);
  check_sections(leaflet);

  check_relative("jet of 1 cm^3/s under 10 kPa",
                 effective_orifice_area(1e-6, 10e3, 1000.),
                 1e-6 / std::sqrt(20.),
                 1e-12);
  check("no leak, no orifice", effective_orifice_area(-1e-6, 1e4, 1e3) == 0);
  check("faces of two tetrahedra",
        boundary_faces<3>({{{0, 1, 2, 3}}, {{1, 2, 3, 4}}}).size() == 6);

  check_history();
  check_history_of_turning_plates();

  const auto force =
    force_on_supports({true, false, true}, {1, 2, 3, 10, 10, 10, 4, 5, 6});
  check("force on the supports",
        force[0] == 5 && force[1] == 7 && force[2] == 9);
  check_relative("Reynolds number of a pipe of 2 cm at 0.5 m/s",
                 reynolds_number(0.5 * M_PI * 1e-4, M_PI * 1e-4, 1060, 2e-3),
                 1060 * 0.5 * 0.02 / 2e-3,
                 1e-12);
}
