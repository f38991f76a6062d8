#ifndef coapt_geometry_vertex_normals_h
#define coapt_geometry_vertex_normals_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Unit normal of a triangulated surface at each of its @p points (m): the sum
   * of the area vectors of the @p triangles around it, normalised. Points on
   * no triangle, and those whose area vectors cancel, get zero.
   */
  std::vector<dealii::Tensor<1, 3>>
  vertex_normals(const std::vector<dealii::Point<3>> &points,
                 const std::vector<std::array<unsigned int, 3>> &triangles);
} // namespace coapt

#endif
