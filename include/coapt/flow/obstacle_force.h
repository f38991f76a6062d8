#ifndef coapt_flow_obstacle_force_h
#define coapt_flow_obstacle_force_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace coapt
{
  template <int dim>
  class FlowModel;

  /**
   * Force of the fluid on the obstacle: the sum of the reactions of the nodes
   * that it holds. That is the force which the momentum balance of the
   * discrete fluid knows, no gradient at the wall is needed.
   */
  template <int dim>
  class ObstacleForce
  {
  public:
    /** Finds the nodes in the obstacle. */
    explicit ObstacleForce(const FlowModel<dim> &model);

    /** The force (N; in 2D N/m), drag and lift being its first two components.
     * Collective. */
    dealii::Tensor<1, dim>
    force(const double time, const double *y) const;

  private:
    const FlowModel<dim> &model;
    std::vector<unsigned int> held_nodes; // owned
  };
} // namespace coapt

#endif
