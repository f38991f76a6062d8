#include <deal.II/base/mpi.h>

#include <coapt/coupled/flow_indicator.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** Frobenius norm of the velocity gradient in the middle of a cell. */
    template <int dim>
    double
    gradient_norm(const typename FluidOperator<dim>::Cell &cell,
                  const double *velocity)
    {
      double square = 0;
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d)
          {
            double difference = 0;
            for (unsigned int i = 0; i < (1u << dim); ++i)
              difference +=
                (((i >> d) & 1) ? 1 : -1) * velocity[dim * cell.nodes[i] + c];
            difference /= (1u << (dim - 1)) * cell.size;
            square += difference * difference;
          }
      return std::sqrt(square);
    }
  } // namespace



  template <int dim>
  FlowIndicator<dim>::FlowIndicator(const MeshParameters &parameters)
    : parameters(parameters), jump(parameters.flow_jump)
  {
  }



  template <int dim>
  std::size_t
  FlowIndicator<dim>::box(const Point<dim> &x) const
  {
    const double size  = parameters.cell_size(parameters.lumen_level);
    std::size_t number = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double i = std::floor((x[d] - lower[d]) / size);
        number         = number * n_boxes[d] +
          static_cast<std::size_t>(std::clamp(i, 0., n_boxes[d] - 1.));
      }
    return number;
  }



  template <int dim>
  bool
  FlowIndicator<dim>::update(const FluidGrid<dim> &grid,
                             const FluidOperator<dim> &fluid,
                             const double *velocity_local,
                             const Mask &masked)
  {
    const MPI_Comm communicator = grid.triangulation().get_communicator();
    const double size           = parameters.cell_size(parameters.lumen_level);
    std::size_t n               = 1;
    lower                       = grid.lower();
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_boxes[d] = std::lround((grid.upper()[d] - grid.lower()[d]) / size);
        n *= n_boxes[d];
      }

    largest_gradient.assign(n, 0.);
    for (unsigned int c = 0; c < fluid.n_owned_cells(); ++c)
      {
        if (!fluid.is_active_cell(c))
          continue;
        const auto &cell  = fluid.cell(c);
        Point<dim> center = cell.lower;
        for (unsigned int d = 0; d < dim; ++d)
          center[d] += 0.5 * cell.size;
        if (!masked(center))
          {
            double &largest = largest_gradient[box(center)];
            largest =
              std::max(largest, gradient_norm<dim>(cell, velocity_local));
          }
      }
    dealii::Utilities::MPI::max(largest_gradient,
                                communicator,
                                largest_gradient);

    const double rise   = 1.2;
    const bool too_many = fluid.n_active_cells() > parameters.max_cells;
    if (too_many)
      jump *= rise;
    return too_many;
  }



  template <int dim>
  unsigned int
  FlowIndicator<dim>::level_for(const double gradient, const double jump) const
  {
    unsigned int level = parameters.lumen_level;
    while (level < parameters.flow_level &&
           gradient * parameters.cell_size(level) > jump)
      ++level;
    return level;
  }



  template <int dim>
  unsigned int
  FlowIndicator<dim>::wanted_level(const Point<dim> &center,
                                   const double size) const
  {
    if (largest_gradient.empty())
      return parameters.lumen_level;
    const double gradient = largest_gradient[box(center)];
    const unsigned int present =
      std::lround(std::log2(parameters.coarse_cell / size));
    return std::clamp(present,
                      level_for(gradient, jump),
                      level_for(gradient, 0.5 * jump));
  }



  template class FlowIndicator<2>;
  template class FlowIndicator<3>;
} // namespace coapt
