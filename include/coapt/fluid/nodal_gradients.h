#ifndef coapt_fluid_nodal_gradients_h
#define coapt_fluid_nodal_gradients_h

#include <array>
#include <vector>

namespace coapt
{
  template <int dim>
  class FluidOperator;

  /** The derivative in direction d of all components of a nodal vector, laid
   * out like the vector itself. */
  template <int dim>
  using NodalGradients = std::array<std::vector<double>, dim>;

  /**
   * Gradients (1/s) at the nodes that @p op knows, from the velocities there
   * (m/s): the mean of the slopes along the edges of the cells around, each
   * with the weight 1/length, which is exact for parabolas (the derivative of
   * the parabola through three nodes in a row). Cells in the wall do not count;
   * hanging nodes have the mean of their masters. Collective.
   */
  template <int dim>
  NodalGradients<dim>
  nodal_gradients(const FluidOperator<dim> &op,
                  const std::vector<double> &velocity_local);
} // namespace coapt

#endif
