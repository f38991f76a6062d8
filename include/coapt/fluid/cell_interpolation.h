#ifndef coapt_fluid_cell_interpolation_h
#define coapt_fluid_cell_interpolation_h

#include <coapt/fluid/fluid_operator.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/tensor.h>

namespace coapt
{
  /** The value at @p unit_point of the unit cell of nodal values with dim
   * entries for each local node, such as the velocity. */
  template <int dim>
  dealii::Tensor<1, dim>
  interpolate(const typename FluidOperator<dim>::Cell &cell,
              const dealii::Point<dim> &unit_point,
              const std::vector<double> &nodal)
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int i = 0; i < cell.nodes.size(); ++i)
      {
        const double weight =
          dealii::GeometryInfo<dim>::d_linear_shape_function(unit_point, i);
        for (unsigned int d = 0; d < dim; ++d)
          result[d] += weight * nodal[dim * cell.nodes[i] + d];
      }
    return result;
  }
} // namespace coapt

#endif
