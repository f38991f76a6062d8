#include <coapt/geometry/quadratic_mesh.h>

#include <algorithm>
#include <map>

namespace coapt
{
  QuadraticMesh::QuadraticMesh(const SimplexMesh<3> &mesh) : linear(mesh)
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> middle;
    for (const auto &cell : mesh.cells)
      {
        std::array<unsigned int, 10> nodes;
        std::copy(cell.begin(), cell.end(), nodes.begin());
        for (unsigned int e = 0; e < 6; ++e)
          {
            const auto ends = std::minmax(cell[edges[e][0]], cell[edges[e][1]]);
            const auto [place, is_new] =
              middle.emplace(ends, linear.points.size());
            if (is_new)
              linear.points.push_back(
                0.5 * (mesh.points[ends.first] + mesh.points[ends.second]));
            nodes[4 + e] = place->second;
          }
        cells.push_back(nodes);
      }
  }
} // namespace coapt
