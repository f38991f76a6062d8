#ifndef coapt_geometry_quadratic_mesh_h
#define coapt_geometry_quadratic_mesh_h

#include <coapt/geometry/simplex_mesh.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Tetrahedra of ten nodes with straight edges: those of a linear mesh, which
   * come first, and one in the middle of each edge.
   */
  struct QuadraticMesh
  {
    /** The vertices, by their numbers in the list, of the edge of each node
     * beyond the fourth. */
    static constexpr unsigned int edges[6][2] =
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

    /** The mesh of ten-noded tetrahedra on the vertices of a linear @p mesh. */
    explicit QuadraticMesh(const SimplexMesh<3> &mesh);

    /** The tetrahedra between their vertices; its points hold all nodes. */
    SimplexMesh<3> linear;

    /** All ten nodes of each cell. */
    std::vector<std::array<unsigned int, 10>> cells;
  };
} // namespace coapt

#endif
