#include <coapt/flow/flow_model.h>
#include <coapt/flow/obstacle_force.h>

#include <deal.II/base/mpi.h>

namespace coapt
{
  template <int dim>
  ObstacleForce<dim>::ObstacleForce(const FlowModel<dim> &model) : model(model)
  {
    const double tolerance = 1e-9 * model.grid().cell_size(0);
    for (unsigned int i = 0; i < model.fluid().n_owned_nodes(); ++i)
      if (model.obstacle() &&
          model.obstacle()(model.fluid().position(i)) >= -tolerance)
        held_nodes.push_back(i);
  }



  template <int dim>
  dealii::Tensor<1, dim>
  ObstacleForce<dim>::force(const double time, const double *y) const
  {
    const std::vector<double> nodal = model.nodal_forces(time, y);
    dealii::Tensor<1, dim> sum;
    for (const unsigned int i : held_nodes)
      for (unsigned int d = 0; d < dim; ++d)
        sum[d] += nodal[dim * i + d];
    return dealii::Utilities::MPI::sum(sum, model.communicator);
  }

  template class ObstacleForce<2>;
  template class ObstacleForce<3>;
} // namespace coapt
