#ifndef coapt_geometry_material_point_h
#define coapt_geometry_material_point_h

#include <coapt/geometry/simplex_mesh.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace coapt
{
  /** A point that moves with a body: weights of the nodes of a cell. */
  template <int dim>
  struct MaterialPoint
  {
    unsigned int cell = 0;
    std::array<double, dim + 1> weights{};
  };

  /** Finds @p point (m) in the reference configuration @p mesh. Throws
   * InputError, which says @p name, if it is in no cell. */
  template <int dim>
  MaterialPoint<dim>
  find_material_point(const SimplexMesh<dim> &mesh,
                      const dealii::Point<dim> &point,
                      const std::string &name);

  /** Displacement (m) of a point for the nodal positions @p X (m). */
  template <int dim>
  dealii::Tensor<1, dim>
  displacement(const SimplexMesh<dim> &mesh,
               const MaterialPoint<dim> &point,
               const std::vector<double> &X);
} // namespace coapt

#endif
