#ifndef coapt_geometry_boundary_curves_h
#define coapt_geometry_boundary_curves_h

#include <coapt/geometry/simplex_mesh.h>

#include <array>
#include <vector>

namespace coapt
{
  /** A smooth part of the boundary of a plane mesh: edges in their order. */
  struct BoundaryCurve
  {
    struct Edge
    {
      /** Its triangle. */
      unsigned int cell;

      /** Where it begins and ends, as numbers in the list of the triangle's
       * nodes. */
      std::array<unsigned int, 2> vertices;

      /** Its length (m). */
      double length;
    };

    std::vector<Edge> edges;

    /** Whether it ends where it begins, without a corner. */
    bool closed = false;

    /** Sum of the edges (m). */
    double length = 0;
  };

  /**
   * The boundary of a plane mesh, cut at corners of more than 30 degrees. A
   * curve without corners begins where x is largest, so that a body that is
   * the same above and below its axis along x has a boundary that is, too.
   */
  std::vector<BoundaryCurve>
  boundary_curves(const SimplexMesh<2> &mesh);
} // namespace coapt

#endif
