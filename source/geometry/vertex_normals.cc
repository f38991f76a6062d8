#include <coapt/geometry/vertex_normals.h>

namespace coapt
{
  std::vector<dealii::Tensor<1, 3>>
  vertex_normals(const std::vector<dealii::Point<3>> &points,
                 const std::vector<std::array<unsigned int, 3>> &triangles)
  {
    std::vector<dealii::Tensor<1, 3>> normals(points.size());
    for (const auto &[a, b, c] : triangles)
      {
        const auto twice_area =
          cross_product_3d(points[b] - points[a], points[c] - points[a]);
        for (const unsigned int corner : {a, b, c})
          normals[corner] += twice_area;
      }
    for (auto &normal : normals)
      {
        const double length = normal.norm();
        if (length > 0)
          normal /= length;
      }
    return normals;
  }
} // namespace coapt
