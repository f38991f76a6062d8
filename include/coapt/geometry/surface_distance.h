#ifndef coapt_geometry_surface_distance_h
#define coapt_geometry_surface_distance_h

#include <coapt/geometry/coupling_lattice.h>
#include <coapt/geometry/simplex_mesh.h>

#include <array>
#include <vector>

namespace coapt
{
  /** The faces (segments or triangles, by their nodes) that belong to one cell
   * only. */
  template <int dim>
  std::vector<std::array<unsigned int, dim>>
  surface_faces(const SimplexMesh<dim> &mesh);

  /** Those of @p samples that are at least @p distance (m) away from the
   * surface of @p mesh, in their order. */
  template <int dim>
  std::vector<SamplePoint<dim>>
  away_from_surface(const SimplexMesh<dim> &mesh,
                    const std::vector<SamplePoint<dim>> &samples,
                    const double distance);
} // namespace coapt

#endif
