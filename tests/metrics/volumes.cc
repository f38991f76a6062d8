// Bulging and swept volumes of known shapes; peaks of chordae.

#include <coapt/base/exceptions.h>
#include <coapt/metrics/bulging_volume.h>
#include <coapt/metrics/chordae_peaks.h>
#include <coapt/metrics/swept_volume.h>

#include "tests.h"

#include <functional>
#include <numeric>

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  using Triangles = std::vector<std::array<unsigned int, 3>>;

  const double semi_axis_x = 17.5e-3, semi_axis_y = 14e-3;

  /** A polar mesh of the ellipse with radii up to @p outer semi-axes. Area
   * vectors point to -z. */
  void
  ellipse(const unsigned int n_rings,
          const unsigned int n_angles,
          const double outer,
          const std::function<double(double, double)> &z,
          std::vector<Point<3>> &points,
          Triangles &triangles)
  {
    points.clear();
    triangles.clear();
    for (unsigned int i = 0; i <= n_rings; ++i)
      for (unsigned int j = 0; j < n_angles; ++j)
        {
          const double r = outer * i / n_rings, t = 2 * M_PI * j / n_angles;
          const double x = semi_axis_x * r * std::cos(t),
                       y = semi_axis_y * r * std::sin(t);
          points.emplace_back(x, y, z(x, y));
        }
    for (unsigned int i = 0; i < n_rings; ++i)
      for (unsigned int j = 0; j < n_angles; ++j)
        {
          const unsigned int a = i * n_angles + j,
                             b = i * n_angles + (j + 1) % n_angles;
          triangles.push_back({{a, b, b + n_angles}});
          triangles.push_back({{a, b + n_angles, a + n_angles}});
        }
  }

  double
  xi_squared(const double x)
  {
    return x * x / (semi_axis_x * semi_axis_x);
  }

  double
  eta_squared(const double y)
  {
    return y * y / (semi_axis_y * semi_axis_y);
  }

  double
  saddle(const double x, const double y)
  {
    return -2.5e-3 * (xi_squared(x) - eta_squared(y));
  }

  std::vector<Point<3>>
  annulus(const std::function<double(double, double)> &z)
  {
    std::vector<Point<3>> points;
    for (unsigned int j = 0; j < 84; ++j)
      {
        const double t = 2 * M_PI * j / 84;
        const double x = semi_axis_x * std::cos(t),
                     y = semi_axis_y * std::sin(t);
        points.emplace_back(x, y, z(x, y));
      }
    return points;
  }

  void
  bulging()
  {
    const double height = 3e-3;
    std::vector<Point<3>> points;
    Triangles triangles;
    const auto flat = [](double, double) { return 0.; };
    const auto cap  = [&](const double x, const double y) {
      return height * (1 - xi_squared(x) - eta_squared(y));
    };
    const double exact = 0.5 * M_PI * semi_axis_x * semi_axis_y * height;

    ellipse(40, 336, 1, cap, points, triangles);
    const double planar = bulging_volume(annulus(flat), points, triangles);
    check_relative("cap over a planar annulus", planar, exact, 2e-3);

    ellipse(
      40,
      336,
      1,
      [&](const double x, const double y) { return saddle(x, y) + cap(x, y); },
      points,
      triangles);
    check_relative("the same cap over a saddle",
                   bulging_volume(annulus(saddle), points, triangles),
                   planar,
                   1e-6);
    const SpanningSurface surface(annulus(saddle));
    check("the surface is the saddle of the annulus",
          std::abs(surface.height_above(
            Point<3>(4e-3, -7e-3, saddle(4e-3, -7e-3)))) < 1e-12);

    // Distance: exact from the saddle along its normal, and of a fold that
    // leans over a plane, where each layer counts with all of its area.
    {
      const Point<3> foot(4e-3, -7e-3, saddle(4e-3, -7e-3));
      const double d = 1e-6;
      Tensor<1, 3> normal;
      normal[0] =
        -(saddle(4e-3 + d, -7e-3) - saddle(4e-3 - d, -7e-3)) / (2 * d);
      normal[1] =
        -(saddle(4e-3, -7e-3 + d) - saddle(4e-3, -7e-3 - d)) / (2 * d);
      normal[2] = 1;
      normal /= normal.norm();
      check_relative("distance from the saddle",
                     surface.distance_above(foot + 2e-3 * normal),
                     2e-3,
                     1e-8);
      check_relative("and below it",
                     surface.distance_above(foot - 1e-3 * normal),
                     -1e-3,
                     1e-8);
    }
    points    = {Point<3>(0, 0, 0),
                 Point<3>(0, 3e-3, 0),
                 Point<3>(3e-3, 0, 4e-3),
                 Point<3>(3e-3, 3e-3, 4e-3)};
    triangles = {{{0, 1, 2}}, {{1, 3, 2}}, {{0, 2, 1}}, {{1, 2, 3}}};
    check_relative("two layers on each other, by distance",
                   bulging_by_distance(annulus(flat), points, triangles),
                   2 * 15e-6 * 2e-3,
                   1e-9);
    check("enclose no volume",
          std::abs(bulging_volume(annulus(flat), points, triangles)) < 1e-20);

    // What is outside the annulus, or below the surface, does not count.
    ellipse(
      45,
      336,
      1.125,
      [&](const double x, const double y) {
        return xi_squared(x) + eta_squared(y) < 1.001 ? cap(x, y) : 5e-3;
      },
      points,
      triangles);
    check("root outside the annulus does not count",
          std::abs(bulging_volume(annulus(flat), points, triangles) - planar) <
            1e-9 * planar,
          bulging_volume(annulus(flat), points, triangles) / planar);
    ellipse(
      40,
      336,
      1,
      [&](const double x, const double y) { return -cap(x, y); },
      points,
      triangles);
    check("nothing bulges below",
          bulging_volume(annulus(flat), points, triangles) < 1e-15);

    // A plane that crosses the surface: the positive half of a wedge, 2/3 a^2
    // b times the slope; exact in spite of crossing facets.
    ellipse(
      40,
      336,
      1,
      [&](const double x, const double) { return 0.1 * (x - 0.1e-3); },
      points,
      triangles);
    const double above = bulging_volume(annulus(flat), points, triangles);
    for (auto &p : points)
      p[2] = -p[2];
    const double below = bulging_volume(annulus(flat), points, triangles);
    check_relative("a tilted plane bulges on one side by a wedge",
                   0.5 * (above + below),
                   0.1 * 2. / 3 * semi_axis_x * semi_axis_x * semi_axis_y,
                   2e-3);

    bool refused = false;
    try
      {
        bulging_volume({Point<3>(), Point<3>(1, 0, 0), Point<3>(0, 1, 0)},
                       points,
                       triangles);
      }
    catch (const InputError &)
      {
        refused = true;
      }
    check("an annulus of three points is refused", refused);
  }

  /** A cap of which one half, one quarter and another quarter are parts. */
  void
  bulging_of_parts()
  {
    const unsigned int n_rings = 20, n_angles = 84;
    std::vector<Point<3>> points;
    Triangles triangles;
    const auto flat = [](double, double) { return 0.; };
    const auto cap  = [](const double x, const double y) {
      return 3e-3 * (1 - xi_squared(x) - eta_squared(y));
    };
    ellipse(n_rings, n_angles, 1, cap, points, triangles);
    std::vector<Region> regions;
    for (unsigned int i = 0; i < n_rings; ++i)
      for (unsigned int j = 0; j < n_angles; ++j)
        regions.insert(regions.end(),
                       2,
                       j < n_angles / 2         ? Region::anterior
                         : j < 3 * n_angles / 4 ? Region::posterior
                                                : Region::commissure);
    const double total = bulging_volume(annulus(flat), points, triangles);
    const auto parts =
      bulging_by_region(annulus(flat), points, triangles, regions);
    check_relative("bulging of the parts adds up",
                   std::accumulate(parts.begin(), parts.end(), 0.),
                   total,
                   1e-12);
    check_relative("half of a cap", parts[0], total / 2, 1e-9);
    check_relative("a quarter of it", parts[1], total / 4, 1e-9);
    check_relative("the other quarter", parts[2], total / 4, 1e-9);
    check("parts that are not there", parts[3] == 0 && parts[4] == 0);
  }

  void
  swept()
  {
    std::vector<Point<3>> points;
    Triangles triangles;
    ellipse(
      5, 24, 1, [](double, double) { return 0.; }, points, triangles);
    const double area =
      0.5 * 24 * std::sin(2 * M_PI / 24) * semi_axis_x * semi_axis_y;
    std::vector<Tensor<1, 3>> velocities(points.size());
    for (auto &v : velocities)
      v = Point<3>(0.3, -0.2, 0.05);
    check_relative("a disc that moves sweeps area x velocity",
                   swept_rate(points, velocities, triangles),
                   0.05 * area,
                   1e-12);

    // A disc that spreads and rises: the integral of pi r^2 dz, with r from R
    // to 2 R linear in z over a height H, is 7/3 times the cylinder.
    std::vector<Point<3>> after(points);
    for (auto &p : after)
      p = Point<3>(2 * p[0], 2 * p[1], 4e-3);
    check_relative("a disc that spreads sweeps a truncated cone",
                   swept_volume(points, after, triangles),
                   7. / 3 * 4e-3 * area,
                   1e-12);
    check_relative("and back",
                   swept_volume(after, points, triangles),
                   -7. / 3 * 4e-3 * area,
                   1e-12);
  }

  void
  peaks()
  {
    std::vector<Chorda> chordae(3);
    chordae[0].id           = "R-P1";
    chordae[1].id           = "L-P1";
    chordae[2].id           = "R-S1";
    chordae[2].chorda_class = ChordaClass::posterior_secondary;
    ChordaePeaks record(chordae);
    record.update(0.01, {0.1, 0.3, 0.5});
    record.update(0.02, {0.4, 0.2, 0.4});
    const auto &primary = record.peak(ChordaClass::anterior_primary);
    check("peak of a class",
          primary.tension == 0.4 && primary.time == 0.02 &&
            primary.id == "R-P1" &&
            record.peak(ChordaClass::posterior_secondary).time == 0.01);
    check("class without chordae",
          record.peak(ChordaClass::posterior_primary).tension == 0);
    check_relative("tension of a class",
                   record.class_tensions({0.1, 0.3, 0.5})[0],
                   0.4,
                   1e-14);
    check("tensions of other chordae are refused",
          error_of([&] {
            record.update(0.03, {0.1});
          }).find("1 tensions were given for 3 chordae") != std::string::npos);
    check("name of a class",
          name_of(ChordaClass::posterior_secondary) == "posterior_secondary");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  bulging();
  bulging_of_parts();
  swept();
  peaks();
}
