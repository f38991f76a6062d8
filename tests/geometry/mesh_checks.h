#ifndef coapt_tests_geometry_mesh_checks_h
#define coapt_tests_geometry_mesh_checks_h

#include <coapt/geometry/leaflet.h>

#include <algorithm>
#include <array>
#include <map>

#include "tests.h"

using namespace coapt;
using namespace dealii;

inline double
volume(const SimplexMesh<3> &mesh, const std::array<unsigned int, 4> &cell)
{
  const Point<3> &o = mesh.points[cell[0]];
  return cross_product_3d(mesh.points[cell[1]] - o, mesh.points[cell[2]] - o) *
    (mesh.points[cell[3]] - o) / 6;
}

// Conforming: a face belongs to two cells or, on the surface, to one; the
// surface is closed and its outward orientation encloses the mesh's volume.
inline void
test_mesh(const std::string &name, const Leaflet &leaflet)
{
  const auto &mesh = leaflet.mesh;
  double least = 1, sum = 0;
  using Face = std::array<unsigned int, 3>;
  std::map<Face, std::pair<unsigned int, Face>> faces;
  for (const auto &cell : mesh.cells)
    {
      least = std::min(least, volume(mesh, cell));
      sum += volume(mesh, cell);
      constexpr unsigned int outward[4][3] = {{1, 2, 3},
                                              {0, 3, 2},
                                              {0, 1, 3},
                                              {0, 2, 1}};
      for (const auto &f : outward)
        {
          const Face face = {{cell[f[0]], cell[f[1]], cell[f[2]]}};
          Face sorted     = face;
          std::sort(sorted.begin(), sorted.end());
          auto &entry  = faces[sorted];
          entry.second = face;
          ++entry.first;
        }
    }
  check(name + " positive tetrahedra", least > 0, least);

  unsigned int most = 0;
  double enclosed   = 0;
  std::map<std::pair<unsigned int, unsigned int>, int> edges;
  for (const auto &face : faces)
    {
      most = std::max(most, face.second.first);
      if (face.second.first != 1)
        continue;
      const Face &f = face.second.second;
      enclosed += Tensor<1, 3>(mesh.points[f[0]]) *
        cross_product_3d(Tensor<1, 3>(mesh.points[f[1]]),
                         Tensor<1, 3>(mesh.points[f[2]])) /
        6;
      for (unsigned int v = 0; v < 3; ++v)
        {
          const unsigned int a = f[v], b = f[(v + 1) % 3];
          edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
  check(name + " conforming", most == 2, most);
  check(name + " surface closed and oriented",
        std::all_of(edges.begin(), edges.end(), [](const auto &edge) {
          return edge.second == 0;
        }));
  check_relative(name + " enclosed volume", enclosed, sum, 1e-12);
}

#endif
