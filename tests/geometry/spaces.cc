// Closest points, the lumen, coupling points, and the widest path.

#include <coapt/base/exceptions.h>
#include <coapt/geometry/coupling_lattice.h>
#include <coapt/geometry/lumen.h>
#include <coapt/geometry/quad_strips.h>
#include <coapt/geometry/triangle.h>
#include <coapt/geometry/valve_generator.h>
#include <coapt/geometry/widest_path.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <random>

#include "tests.h"

using namespace coapt;
using namespace dealii;

constexpr double mm = 1e-3;

// Against all points of a fine lattice on the triangle, degenerate ones too.
void
test_triangle()
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random = [&](const double size) {
    return Point<3>(size * uniform(generator),
                    size * uniform(generator),
                    size * uniform(generator));
  };
  double farther = 0, inconsistent = 0;
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      const Point<3> a = random(1), b = random(1), p = random(2);
      const Point<3> c = trial % 7 == 0 ? a + 0.3 * (b - a) : random(1);
      double w[3];
      const Point<3> q = closest_point_on_triangle(p, a, b, c, w);
      const Point<3> r(w[0] * a + w[1] * b + w[2] * c);
      inconsistent = std::max({inconsistent,
                               r.distance(q),
                               std::abs(w[0] + w[1] + w[2] - 1),
                               -w[0],
                               -w[1],
                               -w[2]});
      const int n  = 100;
      double least = 100;
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n - i; ++j)
          {
            const Point<3> x((i * Tensor<1, 3>(a) + j * Tensor<1, 3>(b) +
                              (n - i - j) * Tensor<1, 3>(c)) /
                             n);
            least = std::min(least, x.distance(p));
          }
      farther = std::max(farther, q.distance(p) - least);
    }
  check("closest point is the closest", farther < 1e-12, farther);
  check("closest point has its weights", inconsistent < 1e-12, inconsistent);
}

void
test_lumen()
{
  const FittedTube tube(LumenParameters(), 17.5 * mm, 14 * mm);
  const double a = 16.75 * mm, b = 13.25 * mm;
  check_relative("distance at the centre",
                 tube.signed_distance(Point<3>(0, 0, 0.01)),
                 -b,
                 1e-12);
  check_relative("distance inside on x",
                 tube.signed_distance(Point<3>(16 * mm, 0, 0)),
                 -0.75 * mm,
                 1e-9);
  check_relative("distance inside on -y",
                 tube.signed_distance(Point<3>(0, -12 * mm, 0)),
                 -1.25 * mm,
                 1e-9);
  check_relative("distance outside on x",
                 tube.signed_distance(Point<3>(-18 * mm, 0, 0)),
                 1.25 * mm,
                 1e-9);
  check_relative("distance outside on y",
                 tube.signed_distance(Point<3>(0, 14 * mm, 0)),
                 0.75 * mm,
                 1e-9);

  // off the axes: a point moved along the normal, and one whose nearest point
  // is searched; on the long axis inside of the evolute the foot is off it
  double worst = 0;
  for (unsigned int i = 0; i < 64; ++i)
    for (const double offset : {-1.5 * mm, -0.01 * mm, 0.3 * mm, 4 * mm})
      {
        const double t = 2 * numbers::PI * (i + 0.3) / 64;
        Tensor<1, 3> normal({std::cos(t) / a, std::sin(t) / b, 0});
        normal /= normal.norm();
        const Point<3> p =
          Point<3>(a * std::cos(t), b * std::sin(t), 0) + offset * normal;
        worst = std::max(worst, std::abs(tube.signed_distance(p) - offset));
      }
  check("distance off the axes", worst < 1e-9, worst);
  double searched = 0;
  for (const Point<3> &p : {Point<3>(3 * mm, 0, 0),
                            Point<3>(3 * mm, 1e-9, 0),
                            Point<3>(6 * mm, 1e-16, 0),
                            Point<3>(1e-7, 3 * mm, 0)})
    {
      double least = 1;
      for (unsigned int i = 0; i < 100000; ++i)
        {
          const double t = numbers::PI * i / 2e5;
          least          = std::min(least,
                           std::hypot(a * std::cos(t) - p[0],
                                      b * std::sin(t) - p[1]));
        }
      searched = std::max(searched, std::abs(tube.signed_distance(p) + least));
    }
  check("distance near the long axis", searched < 1e-9, searched);

  const FittedTube circle(LumenParameters(), 14 * mm, 14 * mm);
  check_relative("distance to a circle",
                 circle.signed_distance(Point<3>(3 * mm, 4 * mm, 0)),
                 -8.25 * mm,
                 1e-12);
  check("box",
        tube.lower().distance(Point<3>(-19.5 * mm, -16 * mm, -35 * mm)) <
            1e-12 &&
          tube.upper().distance(Point<3>(19.5 * mm, 16 * mm, 15 * mm)) < 1e-12);
  bool refused = false;
  try
    {
      LumenParameters wide;
      wide.inset = 14 * mm;
      FittedTube none(wide, 17.5 * mm, 14 * mm);
    }
  catch (const InputError &)
    {
      refused = true;
    }
  check("inset without lumen refused", refused);
  ParameterHandler prm;
  LumenParameters::declare_parameters(prm);
  LumenParameters parsed;
  parsed.inset = 0;
  parsed.parse_parameters(prm);
  check_relative("lumen default", parsed.inset, 0.75 * mm, 1e-12);
}

// Position of a sample in the reference.
template <int dim>
Point<dim>
position(const SimplexMesh<dim> &mesh, const SamplePoint<dim> &sample)
{
  Point<dim> p;
  for (unsigned int v = 0; v <= dim; ++v)
    p += sample.barycentric[v] * mesh.points[mesh.cells[sample.cell][v]];
  return p;
}

template <int dim>
void
test_barycentrics(const std::string &name,
                  const std::vector<SamplePoint<dim>> &samples)
{
  double outside = 0, smallest = 1;
  for (const auto &sample : samples)
    {
      double sum = 0;
      for (const double coordinate : sample.barycentric)
        {
          sum += coordinate;
          outside = std::max({outside, -coordinate, coordinate - 1});
        }
      outside  = std::max(outside, std::abs(sum - 1));
      smallest = std::min(smallest, sample.volume);
    }
  check(name + " barycentric coordinates in [0,1]", outside < 1e-12, outside);
  check(name + " volumes positive", smallest > 0, smallest);
}

/** The faces of a cube, and the same without one. */
void
test_quad_strips()
{
  std::vector<std::array<unsigned int, 4>> cube = {{{0, 1, 3, 2}},
                                                   {{4, 6, 7, 5}},
                                                   {{0, 4, 5, 1}},
                                                   {{2, 3, 7, 6}},
                                                   {{0, 2, 6, 4}},
                                                   {{1, 5, 7, 3}}};
  const auto is_whole                           = [](const QuadStrip &strip) {
    return strip.is_closed && strip.crossings.size() == 4;
  };
  const auto closed = quad_strips(cube);
  check("strips of a cube",
        closed.size() == 3 &&
          std::all_of(closed.begin(), closed.end(), is_whole));
  cube.pop_back();
  const auto open          = quad_strips(cube);
  unsigned int n_crossings = 0;
  for (const QuadStrip &strip : open)
    n_crossings += strip.crossings.size();
  check("strips of an open cube",
        open.size() == 3 && n_crossings == 10 &&
          std::count_if(open.begin(), open.end(), is_whole) == 1);
}

void
test_leaflet_lattice()
{
  const Leaflet leaflet = generate_leaflet(ValveParameters());
  const double spacing = 0.375 * mm, stretch = 1.35;
  const auto samples = leaflet_lattice(leaflet, spacing, stretch);
  test_barycentrics("leaflet:", samples);

  double sum = 0, volume = 0;
  for (const auto &cell : leaflet.mesh.cells)
    {
      const Point<3> &o = leaflet.mesh.points[cell[0]];
      volume += cross_product_3d(leaflet.mesh.points[cell[1]] - o,
                                 leaflet.mesh.points[cell[2]] - o) *
        (leaflet.mesh.points[cell[3]] - o) / 6;
    }
  bool same_quad = true;
  for (const auto &sample : samples)
    {
      sum += sample.volume;
      same_quad = same_quad && leaflet.cell_quad[sample.cell] == sample.quad;
    }
  check_relative("leaflet: volumes add up", sum, volume, 1e-12);
  check("leaflet: cells belong to the quad", same_quad);

  // first moment: the lattice represents the solid, not just its volume
  Point<3> moment, exact;
  for (const auto &sample : samples)
    moment += sample.volume * position(leaflet.mesh, sample);
  for (const auto &cell : leaflet.mesh.cells)
    {
      const Point<3> &o = leaflet.mesh.points[cell[0]];
      const double v    = cross_product_3d(leaflet.mesh.points[cell[1]] - o,
                                        leaflet.mesh.points[cell[2]] - o) *
        (leaflet.mesh.points[cell[3]] - o) / 6;
      for (const unsigned int node : cell)
        exact += v / 4 * leaflet.mesh.points[node];
    }
  check("leaflet: centre of mass",
        moment.distance(exact) < 0.02 * mm * volume,
        moment.distance(exact) / volume);

  std::vector<double> depths;
  std::vector<Point<3>> positions;
  for (const auto &sample : samples)
    {
      positions.push_back(position(leaflet.mesh, sample));
      if (std::find(depths.begin(), depths.end(), sample.depth) == depths.end())
        depths.push_back(sample.depth);
    }
  check("leaflet: three layers", depths.size() == 3, depths.size());

  // no node, so none at the rim either, is farther from a point than half the
  // diagonal of a lattice cell (longer where strips of other numbers of lines
  // meet, and by the shear that the profile of the heights brings)
  double farthest = 0;
  for (const Point<3> &node : leaflet.mesh.points)
    {
      double least = 1;
      for (const Point<3> &x : positions)
        least = std::min(least, x.distance_square(node));
      farthest = std::max(farthest, std::sqrt(least));
    }
  const double in_plane = spacing / stretch, across = 1 * mm / 3;
  const double diagonal = std::sqrt(2 * in_plane * in_plane + across * across);
  check("leaflet: spacing, up to the rim",
        farthest < diagonal / 2 * 1.15,
        farthest);
  // a point for each lattice cell, however the elements divide the leaflet
  const double cell = in_plane * in_plane * across;
  check("leaflet: few more points than spacing and stretch ask for",
        samples.size() < 1.15 * volume / cell,
        samples.size() * cell / volume);
  bool refused = false;
  try
    {
      leaflet_lattice(leaflet, 0);
    }
  catch (const InputError &)
    {
      refused = true;
    }
  check("leaflet: spacing 0 refused", refused);
}

void
test_nested_lattice()
{
  const Leaflet leaflet = generate_leaflet(ValveParameters());
  const double spacing = 0.3125 * mm, stretch = 1.3;
  const auto dense  = leaflet_lattice(leaflet, spacing, stretch);
  const auto nested = nested_leaflet_lattice(leaflet, spacing, stretch);
  test_barycentrics("nested:", nested.points);
  check("nested: the dense points come first",
        nested.stand_in.size() == dense.size() &&
          dense.back().volume == nested.points[dense.size() - 1].volume);

  std::vector<double> volume(nested.points.size(), 0.);
  std::vector<Point<3>> centre(nested.points.size());
  std::vector<unsigned int> members(nested.points.size(), 0);
  for (unsigned int id = 0; id < dense.size(); ++id)
    {
      const unsigned int one = nested.stand_in[id];
      volume[one] += dense[id].volume;
      centre[one] += dense[id].volume * position(leaflet.mesh, dense[id]);
      ++members[one];
    }
  double worst = 0, off = 0, apart = 0;
  for (unsigned int one = dense.size(); one < nested.points.size(); ++one)
    {
      const Point<3> x = position(leaflet.mesh, nested.points[one]);
      worst =
        std::max(worst, std::abs(volume[one] / nested.points[one].volume - 1));
      off = std::max(off, x.distance(centre[one] / volume[one]));
    }
  for (unsigned int id = 0; id < dense.size(); ++id)
    apart = std::max(apart,
                     position(leaflet.mesh, dense[id])
                       .distance(position(leaflet.mesh,
                                          nested.points[nested.stand_in[id]])));
  check("nested: volumes of groups", worst < 1e-12, worst);
  check("nested: centres of groups", off < 0.01 * mm, off);
  // half the diagonal of two by two by two cells of the lattice, less half a
  // cell's
  check("nested: no point is far from what stands for it",
        apart < 0.5 *
            std::sqrt(2 * spacing * spacing / stretch / stretch +
                      mm * mm / 16) *
            1.15,
        apart);
  const unsigned int largest =
    *std::max_element(members.begin(), members.end());
  const double mean =
    dense.size() / double(nested.points.size() - dense.size());
  check("nested: groups", largest == 8 && mean > 4, mean);

  // two layers are not joined
  bool joined = false;
  for (const auto &sample :
       nested_leaflet_lattice(leaflet, 0.6 * mm, stretch).points)
    joined = joined || std::abs(std::abs(sample.depth - 0.5) - 0.25) > 1e-9;
  check("nested: at least two layers", !joined);
}

template <int dim>
void
test_simplex_lattice(const SimplexMesh<dim> &mesh, const double volume)
{
  const std::string name = std::to_string(dim) + "D:";
  const auto samples     = simplex_lattice(mesh, 0.21);
  test_barycentrics(name, samples);
  double sum = 0;
  Point<dim> moment, exact;
  for (const auto &sample : samples)
    {
      sum += sample.volume;
      moment += sample.volume / volume * position(mesh, sample);
    }
  for (const auto &point : mesh.points)
    exact += point / (dim + 1.);
  check_relative(name + " volume", sum, volume, 1e-12);
  // longest edge sqrt(2): seven parts along it
  check(name + " number of parts",
        samples.size() == std::lround(std::pow(7, dim)),
        samples.size());
  check(name + " centroid", moment.distance(exact) < 1e-12);

  // seventh parts of the longest edge; stretched along x, the longest is from
  // (2.5, 0) to (0, 1)
  std::vector<Point<dim>> stretched = mesh.points;
  for (Point<dim> &point : stretched)
    point[0] *= 2.5;
  check_relative(name + " largest spacing",
                 deformed_spacing(mesh, 0.21, mesh.points),
                 2. / (dim + 1) * std::sqrt(2.) / 7,
                 1e-12);
  check_relative(name + " largest spacing, stretched",
                 deformed_spacing(mesh, 0.21, stretched),
                 2. / (dim + 1) * std::sqrt(2.5 * 2.5 + 1) / 7,
                 1e-12);
}

// A square grid over the box, without the triangles that @p hole removes.
struct Sheet
{
  std::vector<Point<3>> points;
  std::vector<std::array<unsigned int, 3>> triangles;

  void
  add(const std::function<Point<3>(double, double)> &surface,
      const double ymin,
      const double ymax)
  {
    const unsigned int n = 24, first = points.size();
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j <= n; ++j)
        points.push_back(
          surface(-6 * mm + 12 * mm * i / n, ymin + (ymax - ymin) * j / n));
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          const unsigned int c = first + i * (n + 1) + j;
          triangles.push_back({{c, c + n + 1, c + n + 2}});
          triangles.push_back({{c, c + n + 2, c + 1}});
        }
  }
};

WidestPath
path_through(const Sheet &sheet)
{
  return widest_path(
    sheet.points,
    sheet.triangles,
    1 * mm,
    [](const Point<3> &p) { return std::hypot(p[0], p[1]) < 5 * mm; },
    Point<3>(-5 * mm, -5 * mm, -6 * mm),
    Point<3>(5 * mm, 5 * mm, 6 * mm));
}

void
test_widest_path()
{
  const auto flat = [](const double x, const double y) {
    return Point<3>(x, y, 0);
  };
  Sheet closed;
  closed.add(flat, -6 * mm, 6 * mm);
  check("closed disc", path_through(closed).width == 0);

  // two half discs apart by the slit's width plus the rounded edges
  for (const double slit : {0.3, 0.77, 1.4})
    {
      Sheet sheet;
      const double half = (slit + 1) / 2 * mm;
      sheet.add(flat, -6 * mm, 0.13 * mm - half);
      sheet.add(flat, 0.13 * mm + half, 6 * mm);
      const WidestPath path = path_through(sheet);
      check("straight slit",
            std::abs(path.width - slit * mm) < 0.03 * mm,
            path.width);
      check("place of the slit",
            std::abs(path.position[1] - 0.13 * mm) < 0.2 * mm &&
              std::abs(path.position[2]) < 0.3 * mm,
            path.position[1]);
    }

  // overlapping flaps that a projection along z would call shut
  for (const double slit : {0.0, 0.25, 0.5})
    {
      Sheet sheet;
      const auto bend = [&](const double sign) {
        return [=](const double x, const double y) {
          const double s = (slit + 1) / 2 * mm;
          return Point<3>(x, y, 0.4 * y + sign * s * std::hypot(1, 0.4));
        };
      };
      sheet.add(bend(1), -6 * mm, 2 * mm);
      sheet.add(bend(-1), -2 * mm, 6 * mm);
      const WidestPath path = path_through(sheet);
      check("oblique slit",
            std::abs(path.width - slit * mm) < 0.08 * mm,
            path.width);
    }

  // square hole of 2.6 mm in the mesh: clear width 1.6 mm
  Sheet hole;
  hole.add(flat, -6 * mm, -1.3 * mm);
  hole.add(flat, 1.3 * mm, 6 * mm);
  hole.add([](const double x,
              const double y) { return Point<3>(x - 7.3 * mm, y, 0); },
           -2 * mm,
           2 * mm);
  hole.add([](const double x,
              const double y) { return Point<3>(x + 7.3 * mm, y, 0); },
           -2 * mm,
           2 * mm);
  const WidestPath path = path_through(hole);
  check("square hole", std::abs(path.width - 1.6 * mm) < 0.05 * mm, path.width);
  check("place of the hole",
        path.position.norm() < 0.4 * mm,
        path.position.norm());
  check("no sheet", path_through(Sheet()).width > 1.99 * mm);
}

// The closed design of the valve is shut but for the commissures; the open
// valve is open. Also: fast enough to be asked often.
void
test_widest_path_of_valve()
{
  const ValveParameters valve;
  const Leaflet leaflet = generate_leaflet(valve);
  const auto triangles  = triangulate(leaflet.quads);
  const FittedTube tube(LumenParameters(),
                        valve.annulus_semi_axis_x,
                        valve.annulus_semi_axis_y);
  const auto width = [&](const auto &shape) {
    std::vector<Point<3>> points;
    for (const auto &place : leaflet.column_coordinates)
      points.push_back(shape(place[0], place[1]));
    Point<3> lower = tube.lower(), upper = tube.upper();
    lower[2] = -27 * mm;
    upper[2] = 8 * mm;
    return widest_path(
             points,
             triangles,
             valve.thickness,
             [&](const Point<3> &p) { return tube.inside(p); },
             lower,
             upper)
      .width;
  };
  const std::clock_t start = std::clock();
  const double open        = width(
    [&](const double t, const double s) { return open_position(valve, t, s); });
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  check("open valve", open > 1.99 * mm, open);
  const double closed = width([&](const double t, const double s) {
    return s < 0 ? open_position(valve, t, s) : closed_position(valve, t, s);
  });
  check("closed design", closed < 0.1 * mm, closed);
  check("widest path within a second", seconds < 1, seconds);
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_triangle();
  test_lumen();
  test_quad_strips();
  test_leaflet_lattice();
  test_nested_lattice();
  SimplexMesh<2> triangle;
  triangle.points = {Point<2>(1, 1), Point<2>(2, 1), Point<2>(1, 2)};
  triangle.cells  = {{{0, 1, 2}}};
  test_simplex_lattice(triangle, 0.5);
  SimplexMesh<3> tetrahedron;
  tetrahedron.points = {Point<3>(0, 0, 0),
                        Point<3>(1, 0, 0),
                        Point<3>(0, 1, 0),
                        Point<3>(0, 0, 1)};
  tetrahedron.cells  = {{{0, 1, 2, 3}}};
  test_simplex_lattice(tetrahedron, 1. / 6);
  test_widest_path();
  test_widest_path_of_valve();
}
