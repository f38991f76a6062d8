#include <coapt/base/exceptions.h>
#include <coapt/flow/flow_model.h>
#include <coapt/flow/number_lists.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    template <int dim>
    std::array<unsigned int, dim>
    to_array(const std::vector<unsigned int> &list)
    {
      std::array<unsigned int, dim> result;
      std::copy(list.begin(), list.begin() + dim, result.begin());
      return result;
    }

    /** Distance (m) of a point outwards from a circle around an axis along
     * z. */
    template <int dim>
    double
    distance_from_circle(const Point<dim> &point,
                         const std::vector<double> &center,
                         const double radius)
    {
      return std::hypot(point[0] - center[0], point[1] - center[1]) - radius;
    }

    template <int dim>
    std::function<double(const Point<dim> &)>
    depth_in_obstacle(const FlowParameters &p)
    {
      if (p.obstacle_radius == 0)
        return {};
      return [center = p.obstacle_center,
              radius = p.obstacle_radius](const Point<dim> &point) {
        return -distance_from_circle(point, center, radius);
      };
    }

    /** Depth (m) in the obstacle or in the wall of the tube. */
    template <int dim>
    std::function<double(const Point<dim> &)>
    depth_in_walls(const FlowParameters &p)
    {
      const auto in_obstacle = depth_in_obstacle<dim>(p);
      if (p.tube_radius == 0)
        return in_obstacle;
      return [in_obstacle, center = p.tube_center, radius = p.tube_radius](
               const Point<dim> &point) {
        const double in_tube = distance_from_circle(point, center, radius);
        return in_obstacle ? std::max(in_tube, in_obstacle(point)) : in_tube;
      };
    }
  } // namespace



  template <int dim>
  FlowModel<dim>::FlowModel(const FlowParameters &p,
                            const unsigned int level,
                            MPI_Comm communicator)
    : exact_velocity(vector_field<dim>("Flow/Exact velocity",
                                       p.exact_velocity,
                                       p.named_constants()))
    , exact_pressure(scalar_field<dim>("Flow/Exact pressure",
                                       p.exact_pressure,
                                       p.named_constants()))
    , communicator(communicator)
    , parameters(p)
    , level(level)
    , initial_velocity(vector_field<dim>("Flow/Initial velocity",
                                         p.initial_velocity,
                                         p.named_constants()))
    , initial_pressure(scalar_field<dim>("Flow/Initial pressure",
                                         p.initial_pressure,
                                         p.named_constants()))
    , obstacle_depth(depth_in_obstacle<dim>(p))
    , octree(communicator,
             to_point<dim>(p.lower),
             to_point<dim>(p.upper),
             to_array<dim>(p.coarse_cells))
    , op(p.fluid, boundaries(p.named_constants()), depth_in_walls<dim>(p))
  {
    octree.refine_to([&](const Point<dim> &center, double) {
      bool in_patch = !p.patch_lower.empty();
      for (unsigned int d = 0; d < dim && in_patch; ++d)
        in_patch = center[d] > p.patch_lower[d] && center[d] < p.patch_upper[d];
      return level + (in_patch ? p.patch_levels : 0);
    });
    op.reinit(octree);
  }



  template <int dim>
  FluidBoundaries<dim>
  FlowModel<dim>::boundaries(const NamedConstants &constants) const
  {
    FluidBoundaries<dim> result;
    const ScalarField<dim> pressure =
      scalar_field<dim>("Flow/Boundary pressure",
                        parameters.boundary_pressure,
                        constants);
    for (unsigned int side = 0; side < 2 * dim; ++side)
      {
        result.type[side]      = parameters.sides[side];
        result.impedance[side] = parameters.impedance;
        Point<dim> center      = (octree.lower() + octree.upper()) / 2;
        center[side / 2] =
          (side % 2 ? octree.upper() : octree.lower())[side / 2];
        result.pressure[side] = [=](const double t) {
          return pressure ? pressure(center, t) : 0.;
        };
      }
    result.velocity = vector_field<dim>("Flow/Boundary velocity",
                                        parameters.boundary_velocity,
                                        constants);
    const bool is_needed =
      std::find(result.type.begin(),
                result.type.end(),
                FluidBoundary::velocity) != result.type.end();
    if (is_needed && !result.velocity)
      throw InputError("Flow/Boundary velocity is empty, but a side of the box "
                       "is of the kind velocity");
    return result;
  }



  template <int dim>
  std::vector<double>
  FlowModel<dim>::initial_state() const
  {
    std::vector<double> y(dim * op.n_owned_nodes() + op.n_owned_cells(), 0.);
    for (unsigned int i = 0; i < op.n_owned_nodes() && initial_velocity; ++i)
      {
        const auto u = initial_velocity(op.position(i), 0.);
        for (unsigned int d = 0; d < dim; ++d)
          y[dim * i + d] = u[d];
      }
    op.apply_constraints(y.data());
    op.set_boundary_velocity(0., y.data());
    double *p = y.data() + dim * op.n_owned_nodes();
    for (unsigned int c = 0; c < op.n_owned_cells() && initial_pressure; ++c)
      {
        Point<dim> center = op.cell(c).lower;
        for (unsigned int d = 0; d < dim; ++d)
          center[d] += op.cell(c).size / 2;
        if (op.is_active_cell(c))
          p[c] = initial_pressure(center, 0.);
      }
    return y;
  }



  template <int dim>
  void
  FlowModel<dim>::rhs(const double time, const double *y, double *y_dot) const
  {
    velocity.resize(dim * op.n_local_nodes());
    force.assign(dim * op.n_local_nodes(), 0.);
    op.gather(y, velocity.data());
    op.add_forces(time,
                  velocity.data(),
                  pressure(y),
                  force.data(),
                  y_dot + dim * op.n_owned_nodes());
    op.finish(force.data(), y_dot);
    op.set_boundary_acceleration(time, y_dot);
  }



  template <int dim>
  std::vector<double>
  FlowModel<dim>::local_velocity(const double *y) const
  {
    std::vector<double> result(dim * op.n_local_nodes());
    op.gather(y, result.data());
    return result;
  }



  template <int dim>
  const double *
  FlowModel<dim>::pressure(const double *y) const
  {
    return y + dim * op.n_owned_nodes();
  }



  template <int dim>
  std::vector<double>
  FlowModel<dim>::nodal_forces(const double time, const double *y) const
  {
    const std::vector<double> u = local_velocity(y);
    std::vector<double> result(u.size(), 0.), rate(op.n_owned_cells());
    op.add_forces(time, u.data(), pressure(y), result.data(), rate.data());
    op.sum_forces(result.data());
    result.resize(dim * op.n_owned_nodes());
    return result;
  }



  template <int dim>
  bool
  FlowModel<dim>::has_pressure_boundary() const
  {
    const auto end = parameters.sides.begin() + 2 * dim;
    return std::find(parameters.sides.begin(),
                     end,
                     FluidBoundary::pressure_end) != end;
  }



  template <int dim>
  const std::function<double(const Point<dim> &)> &
  FlowModel<dim>::obstacle() const
  {
    return obstacle_depth;
  }



  template <int dim>
  const FluidGrid<dim> &
  FlowModel<dim>::grid() const
  {
    return octree;
  }



  template <int dim>
  const FluidOperator<dim> &
  FlowModel<dim>::fluid() const
  {
    return op;
  }



  template <int dim>
  double
  FlowModel<dim>::cell_size() const
  {
    return octree.cell_size(level);
  }



  template <int dim>
  FluidOperator<dim> &
  FlowModel<dim>::fluid()
  {
    return op;
  }



  template <int dim>
  double
  FlowModel<dim>::smallest_cell_size() const
  {
    return octree.cell_size(octree.triangulation().n_global_levels() - 1);
  }

  template class FlowModel<2>;
  template class FlowModel<3>;
} // namespace coapt
