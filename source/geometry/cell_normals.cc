#include <coapt/geometry/cell_normals.h>

namespace coapt
{
  std::vector<dealii::Tensor<1, 3>>
  cell_normals(const Leaflet &leaflet)
  {
    const auto corner = [&](const unsigned int column) {
      return leaflet.mesh.points[leaflet.columns[column].front()];
    };
    std::vector<dealii::Tensor<1, 3>> normals;
    for (const unsigned int q : leaflet.cell_quad)
      {
        const auto &quad  = leaflet.quads[q];
        const auto normal = cross_product_3d(corner(quad[2]) - corner(quad[0]),
                                             corner(quad[3]) - corner(quad[1]));
        normals.push_back(normal / normal.norm());
      }
    return normals;
  }
} // namespace coapt
