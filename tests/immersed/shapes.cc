// Bodies of simple shape: volumes, orientation, faces.
#include <coapt/geometry/body_shapes.h>
#include <coapt/geometry/coupling_lattice.h>

#include <functional>
#include <map>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Volume of all cells; not a number if one of them is inverted. */
  template <int dim>
  double
  volume(const SimplexMesh<dim> &mesh)
  {
    double sum = 0;
    for (const auto &cell : mesh.cells)
      {
        Tensor<2, dim> edges;
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int d = 0; d < dim; ++d)
            edges[d][a] = mesh.points[cell[a + 1]][d] - mesh.points[cell[0]][d];
        const double v = determinant(edges) / (dim == 2 ? 2 : 6);
        sum += v > 0 ? v : std::nan("");
      }
    return sum;
  }

  template <int dim>
  std::vector<double>
  positions(const SimplexMesh<dim> &mesh)
  {
    std::vector<double> X;
    for (const auto &x : mesh.points)
      for (unsigned int d = 0; d < dim; ++d)
        X.push_back(x[d]);
    return X;
  }

  /** Area of a regular polygon. */
  double
  polygon(const double radius, const unsigned int n)
  {
    return n / 2. * radius * radius * std::sin(2 * std::acos(-1.) / n);
  }

  void
  check_fibres(const std::string &name,
               const ShapedBody<2> &body,
               const Point<2> &center)
  {
    double worst = body.fibre.size() == body.mesh.cells.size() ? 0 : 1;
    for (unsigned int c = 0; c < body.fibre.size(); ++c)
      {
        Tensor<1, 2> r;
        for (const unsigned int node : body.mesh.cells[c])
          r += (body.mesh.points[node] - center) / 3.;
        worst = std::max(worst, std::abs(body.fibre[c] * r) / r.norm());
        worst = std::max(worst, std::abs(body.fibre[c].norm() - 1));
      }
    check(name + ", unit vectors around the centre", worst < 1e-12, worst);
  }

  void
  check_round_bodies()
  {
    const Point<2> center(0.6, 0.5);
    const ShapedBody<2> disc = disc_body(center, 0.2, 0.05);
    check_relative("disc, area", volume(disc.mesh), polygon(0.2, 6 * 4), 1e-12);
    check_fibres("disc", disc, center);
    const ShapedBody<2> ring = ring_body(center, 0.25, 0.0625, 0.03125);
    const unsigned int n     = ring.mesh.points.size() / 3;
    check_relative("ring, area",
                   volume(ring.mesh),
                   polygon(0.3125, n) - polygon(0.25, n),
                   1e-12);
    check_fibres("ring", ring, center);

    ShapedBody<2> both = disc;
    append(both, ring);
    check_relative("disc and ring, area",
                   volume(both.mesh),
                   volume(disc.mesh) + volume(ring.mesh),
                   1e-12);
  }

  template <int dim>
  void
  check_strip(const std::string &name,
              const double thickness_sign,
              const bool quadratic = false)
  {
    StripShape<dim> shape;
    shape.begin                 = Point<2>(0.3, 0);
    shape.end                   = Point<2>(0.4, 1);
    shape.thickness             = Tensor<1, 2>({thickness_sign * 0.1, 0.});
    shape.bow                   = 0.05;
    shape.z_lower               = 0.5;
    shape.z_upper               = 1;
    const ShapedBody<dim> strip = strip_body(shape, 0.05, quadratic);
    const double depth          = dim == 3 ? 0.5 : 1.;
    if (quadratic)
      check(name + ", linear cells in each element",
            strip.mesh.n_elements() * (dim == 3 ? 8 : 4) ==
              strip.mesh.cells.size());
    check_relative(name + ", volume", volume(strip.mesh), 0.1 * depth, 1e-12);
    const auto X       = positions(strip.mesh);
    const double lower = volume_behind<dim>(strip.lower_face, X);
    const double upper = volume_behind<dim>(strip.upper_face, X);
    check_relative(name + ", volume between the faces",
                   thickness_sign * (upper - lower),
                   0.1 * depth,
                   1e-12);
    // the parabola as trapezoids: 20 parts along the strip
    const double middle =
      0.35 + thickness_sign * 2. / 3 * 0.05 * (1 - 1. / 400);
    check_relative(name + ", volume behind its middle",
                   (upper + lower) / 2,
                   middle * depth,
                   1e-12);
  }

  template <int dim>
  Point<dim>
  position(const SimplexMesh<dim> &mesh, const SamplePoint<dim> &sample)
  {
    Point<dim> x;
    for (unsigned int a = 0; a <= dim; ++a)
      x += sample.barycentric[a] * mesh.points[mesh.cells[sample.cell][a]];
    return x;
  }

  /** Points on the surface of a box 1 long, 0.2 thick and 0.5 wide. */
  template <int dim>
  void
  check_surface_points(const std::string &name)
  {
    StripShape<dim> shape;
    shape.begin                 = Point<2>(0, 0.1);
    shape.end                   = Point<2>(1, 0.1);
    shape.thickness             = Tensor<1, 2>({0., 0.2});
    shape.z_upper               = 0.5;
    const ShapedBody<dim> strip = strip_body(shape, 0.1);
    const double spacing = 0.05, depth = 0.01;
    const auto samples   = surface_lattice(strip.mesh, spacing, depth);
    const double upper[] = {1, 0.2, 0.5};
    // Negative outside.
    const auto distance_inside = [&](const Point<dim> &x) {
      double distance = 1;
      for (unsigned int d = 0; d < dim; ++d)
        distance = std::min({distance, x[d], upper[d] - x[d]});
      return distance;
    };
    double volume = 0, farthest = 0;
    unsigned int n_outwards = 0;
    const double step       = 1e-6;
    std::vector<Point<dim>> positions;
    for (const auto &sample : samples)
      {
        volume += sample.volume;
        const Point<dim> x = position(strip.mesh, sample);
        farthest           = std::max(farthest, std::abs(distance_inside(x)));
        n_outwards +=
          std::abs(distance_inside(x + step * sample.outwards) + step) < 1e-12;
        positions.push_back(x);
      }
    const double area = dim == 2 ? 2.4 : 2 * (0.2 + 0.5 + 0.1);
    check_relative(name + ", layer below its surface",
                   volume,
                   area * depth,
                   1e-12);
    check(name + ", points on its surface", farthest < 1e-12);
    double nearest = 1, uncovered = 0;
    for (const auto &p : positions)
      for (const auto &q : positions)
        if (&p != &q)
          nearest = std::min(nearest, p.distance(q));
    for (const auto &p : strip.mesh.points)
      if (p[1] < 1e-9) // on the surface
        {
          double distance = 1;
          for (const auto &q : positions)
            distance = std::min(distance, p.distance(q));
          uncovered = std::max(uncovered, distance);
        }
    check(name + ", distance between points", nearest >= spacing, nearest);
    check(name + ", normals of its points",
          n_outwards == samples.size(),
          n_outwards);
    check(name + ", surface near a point", uncovered < 1.1 * spacing);
  }

  /** Points on the surface of a body that is the same above and below y = 0. */
  void
  check_symmetry(const std::string &name, const SimplexMesh<2> &mesh)
  {
    const double spacing = 0.07;
    std::vector<Point<2>> positions;
    for (const auto &sample : surface_lattice(mesh, spacing, 0.01))
      positions.push_back(position(mesh, sample));
    double farthest = 0;
    for (const auto &p : positions)
      {
        double distance = 1;
        for (const auto &q : positions)
          distance = std::min(distance, q.distance(Point<2>(p[0], -p[1])));
        farthest = std::max(farthest, distance);
      }
    check(name + ", points the same above and below its axis",
          farthest < 1e-9,
          farthest);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_round_bodies();
  check_strip<2>("strip", 1);
  check_strip<2>("strip, thickness against x", -1);
  check_strip<2>("strip of P2", 1, true);
  check_strip<2>("strip of P2, thickness against x", -1, true);
  check_strip<3>("plate of P2", 1, true);
  check_strip<3>("plate of P2, thickness against x", -1, true);
  check_strip<3>("plate", 1);
  check_strip<3>("plate, thickness against x", -1);
  check_surface_points<2>("strip");
  check_surface_points<3>("plate");
  check_symmetry("disc", disc_body(Point<2>(0.3, 0), 0.5, 0.1).mesh);
  StripShape<2> flag;
  flag.begin     = Point<2>(0, 0);
  flag.end       = Point<2>(1, 0);
  flag.thickness = Tensor<1, 2>({0., 0.2});
  check_symmetry("strip", strip_body(flag, 0.1).mesh);
}
