#include <coapt/structure/pressure_load.h>

namespace coapt
{
  PressureLoad::PressureLoad(const Leaflet &leaflet)
  {
    std::vector<std::array<unsigned int, 4>> quads;
    for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
      if (leaflet.quad_region[q] != Region::root)
        quads.push_back(leaflet.quads[q]);
    for (const auto &columns : triangulate(quads))
      triangles.push_back({{leaflet.columns[columns[0]].back(),
                            leaflet.columns[columns[1]].back(),
                            leaflet.columns[columns[2]].back()}});
  }



  void
  PressureLoad::add_forces(const double pressure,
                           const double *X,
                           double *F,
                           const unsigned int rank,
                           const unsigned int n_ranks) const
  {
    for (unsigned int i = rank; i < triangles.size(); i += n_ranks)
      {
        const double *x[3];
        for (unsigned int v = 0; v < 3; ++v)
          x[v] = X + 3 * triangles[i][v];
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
            const double area = 0.5 *
              ((x[1][e] - x[0][e]) * (x[2][f] - x[0][f]) -
               (x[1][f] - x[0][f]) * (x[2][e] - x[0][e]));
            for (unsigned int v = 0; v < 3; ++v)
              F[3 * triangles[i][v] + d] -= pressure * area / 3;
          }
      }
  }
} // namespace coapt
