#ifndef coapt_geometry_simplex_mesh_h
#define coapt_geometry_simplex_mesh_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * A mesh of linear simplices (triangles in 2D, tetrahedra in 3D) in the
   * reference configuration. The mesh of a leaflet is small, so every rank
   * holds all of it. All cells have positive volume. Lengths in m.
   */
  template <int dim>
  struct SimplexMesh
  {
    /** Positions of the nodes (m). */
    std::vector<dealii::Point<dim>> points;

    /** Node numbers of each cell. */
    std::vector<std::array<unsigned int, dim + 1>> cells;
  };
} // namespace coapt

#endif
