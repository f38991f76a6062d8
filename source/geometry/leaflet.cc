#include <coapt/geometry/leaflet.h>

namespace coapt
{
  std::vector<std::array<unsigned int, 3>>
  triangulate(const std::vector<std::array<unsigned int, 4>> &quads)
  {
    std::vector<std::array<unsigned int, 3>> triangles;
    for (const auto &quad : quads)
      {
        triangles.push_back({{quad[0], quad[1], quad[2]}});
        triangles.push_back({{quad[0], quad[2], quad[3]}});
      }
    return triangles;
  }
} // namespace coapt
