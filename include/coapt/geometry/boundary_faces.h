#ifndef coapt_geometry_boundary_faces_h
#define coapt_geometry_boundary_faces_h

#include <array>
#include <vector>

namespace coapt
{
  /** A face that belongs to one simplex only. */
  template <int dim>
  struct BoundaryFace
  {
    /** That simplex. */
    unsigned int cell;

    /** The face's vertices, as numbers in the list of the cell's nodes. */
    std::array<unsigned int, dim> vertices;

    /** Its nodes in ascending order. */
    std::array<unsigned int, dim> nodes;
  };

  /** The faces of simplices, given by their nodes, that belong to one of them
   * only, in the order of their nodes. */
  template <int dim>
  std::vector<BoundaryFace<dim>>
  boundary_faces(const std::vector<std::array<unsigned int, dim + 1>> &cells);
} // namespace coapt

#endif
