#ifndef coapt_geometry_quadratic_mesh_h
#define coapt_geometry_quadratic_mesh_h

#include <coapt/geometry/simplex_mesh.h>

#include <array>

namespace coapt
{
  /** Vertices of the edge of each node of a quadratic triangle or tetrahedron
   * beyond its vertices. @{ */
  constexpr unsigned int triangle_edges[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  constexpr unsigned int tetrahedron_edges[6][2] =
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

  template <int dim>
  constexpr const auto &
  simplex_edges()
  {
    if constexpr (dim == 2)
      return triangle_edges;
    else
      return tetrahedron_edges;
  }
  /** @} */

  /** Appends a triangle of six @p nodes to the @p mesh, and the four linear
   * ones that it consists of: three at its vertices, in their order, and the
   * one inside. */
  void
  add_quadratic_cell(const std::array<unsigned int, 6> &nodes,
                     SimplexMesh<2> &mesh);

  /** Appends a tetrahedron of ten @p nodes to the @p mesh, and the eight linear
   * ones that it consists of: four at its vertices, in their order, and four
   * around the line between the nodes of its edges 0-2 and 1-3. */
  void
  add_quadratic_cell(const std::array<unsigned int, 10> &nodes,
                     SimplexMesh<3> &mesh);

  /** The mesh of ten-noded tetrahedra with straight edges on the vertices of a
   * @p linear one, whose nodes come first. */
  SimplexMesh<3>
  quadratic_mesh(const SimplexMesh<3> &linear);
} // namespace coapt

#endif
