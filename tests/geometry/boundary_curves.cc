// The boundary of plane meshes as smooth curves.

#include <coapt/geometry/body_shapes.h>
#include <coapt/geometry/boundary_curves.h>

#include "tests.h"

#include <cmath>

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Whether each edge begins where the one before ends. */
  bool
  connected(const SimplexMesh<2> &mesh, const BoundaryCurve &curve)
  {
    const auto node = [&](const unsigned int e, const unsigned int end) {
      const auto &edge = curve.edges[e];
      return mesh.cells[edge.cell][edge.vertices[end]];
    };
    bool result = true;
    for (unsigned int e = 1; e < curve.edges.size(); ++e)
      result = result && node(e, 0) == node(e - 1, 1);
    return result &&
      curve.closed == (node(0, 0) == node(curve.edges.size() - 1, 1));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  StripShape<2> shape;
  shape.begin                = Point<2>(0, 0);
  shape.end                  = Point<2>(1, 0);
  shape.thickness            = Tensor<1, 2>({0., 0.2});
  const SimplexMesh<2> strip = strip_body(shape, 0.1).mesh;
  const auto sides           = boundary_curves(strip);
  bool good                  = sides.size() == 4;
  double length              = 0;
  for (const BoundaryCurve &side : sides)
    {
      good = good && !side.closed && connected(strip, side) &&
        std::min(std::abs(side.length - 1), std::abs(side.length - 0.2)) <
          1e-12;
      length += side.length;
    }
  check("a strip has four sides", good, sides.size());
  check_relative("its boundary", length, 2.4, 1e-12);

  const SimplexMesh<2> disc = disc_body(Point<2>(0, 0), 0.5, 0.1).mesh;
  const auto circle         = boundary_curves(disc);
  check("a disc has one closed curve",
        circle.size() == 1 && circle[0].closed && connected(disc, circle[0]));
  const auto &first = circle[0].edges[0];
  const Point<2> x  = disc.points[disc.cells[first.cell][first.vertices[0]]];
  check("which begins on the axis", x.distance(Point<2>(0.5, 0)) < 1e-12);

  const SimplexMesh<2> ring =
    ring_body(Point<2>(0, 0), 0.25, 0.0625, 0.03).mesh;
  const auto circles = boundary_curves(ring);
  check("a ring has two",
        circles.size() == 2 && circles[0].closed && circles[1].closed);
}
