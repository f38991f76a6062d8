#ifndef coapt_geometry_simplex_mesh_h
#define coapt_geometry_simplex_mesh_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * A mesh of simplices (triangles in 2D, tetrahedra in 3D) in the reference
   * configuration. The mesh of a leaflet is small, so every rank holds all of
   * it. All cells have positive volume. Lengths in m.
   */
  template <int dim>
  struct SimplexMesh
  {
    /** Positions of the nodes (m). */
    std::vector<dealii::Point<dim>> points;

    /** Node numbers of each linear cell. */
    std::vector<std::array<unsigned int, dim + 1>> cells;

    /**
     * Quadratic elements on the same nodes, if the solid is to consist of
     * such: the vertices of each, then the nodes of its edges. Element i
     * consists of the cells 2^dim i and following, the first of which lie at
     * its vertices; see add_quadratic_cell().
     */
    std::vector<std::array<unsigned int, (dim + 1) * (dim + 2) / 2>>
      quadratic_cells;

    /** Number of elements that the solid consists of. */
    unsigned int
    n_elements() const
    {
      return quadratic_cells.empty() ? cells.size() : quadratic_cells.size();
    }
  };
} // namespace coapt

#endif
