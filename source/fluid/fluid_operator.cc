#include <coapt/base/exceptions.h>
#include <coapt/fluid/fluid_operator.h>

#include <algorithm>
#include <string>
#include <utility>

namespace coapt
{
  template <int dim>
  FluidOperator<dim>::FluidOperator(
    const FluidParameters &parameters,
    const FluidBoundaries<dim> &boundaries,
    std::function<double(const dealii::Point<dim> &)> lumen)
    : fluid_parameters(parameters)
    , boundaries(boundaries)
    , lumen(std::move(lumen))
  {
    const double rho                  = parameters.density;
    coefficients.viscosity            = parameters.viscosity;
    coefficients.artificial_viscosity = rho * parameters.artificial_viscosity;
    coefficients.hourglass            = rho * parameters.hourglass_speed;
    coefficients.convection           = parameters.convection ? rho : 0.;
    coefficients.bulk_modulus =
      rho * parameters.sound_speed * parameters.sound_speed;
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (boundaries.type[side] == FluidBoundary::velocity &&
          !boundaries.velocity)
        throw InputError("Fluid boundary " + std::to_string(side) +
                         " has a given velocity, but there is none.");
      else if (boundaries.type[side] == FluidBoundary::pressure_end)
        {
          if (!boundaries.pressure[side])
            throw InputError("Fluid boundary " + std::to_string(side) +
                             " is a pressure end without a pressure.");
          if (!(boundaries.impedance[side] >= 0))
            throw InputError("Fluid boundary " + std::to_string(side) +
                             " has the impedance " +
                             std::to_string(boundaries.impedance[side]) +
                             " Pa s/m, allowed are values >= 0.");
        }
  }



  template <int dim>
  void
  FluidOperator<dim>::gather(const double *velocity_owned,
                             double *velocity_local) const
  {
    nodes.gather(velocity_owned, velocity_local);
  }



  template <int dim>
  void
  FluidOperator<dim>::add_forces(const double time,
                                 const double *velocity_local,
                                 const double *pressure,
                                 double *force_local,
                                 double *pressure_rate) const
  {
    kernel.evaluate(
      coefficients, velocity_local, pressure, force_local, pressure_rate);
    for (const unsigned int c : inactive)
      pressure_rate[c] = 0;
    filter.add_rate(pressure, pressure_rate);
    add_end_tractions(time, velocity_local, force_local);
  }



  template <int dim>
  void
  FluidOperator<dim>::add_end_tractions(const double time,
                                        const double *velocity_local,
                                        double *force_local) const
  {
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (boundaries.type[side] == FluidBoundary::pressure_end)
        {
          const unsigned int d  = side / 2;
          const double outward  = (side % 2 == 1) ? 1 : -1;
          const double pressure = outward * boundaries.pressure[side](time);
          for (const Face &face : faces[side])
            for (const unsigned int node : face.nodes)
              force_local[dim * node + d] -= face.area_per_node *
                (pressure +
                 boundaries.impedance[side] * velocity_local[dim * node + d]);
        }
  }



  template <int dim>
  void
  FluidOperator<dim>::finish(double *force_local,
                             double *acceleration_owned) const
  {
    sum_forces(force_local);
    divide_by_mass(force_local, acceleration_owned);
  }



  template <int dim>
  void
  FluidOperator<dim>::divide_by_mass(const double *force_local,
                                     double *acceleration_owned) const
  {
    for (unsigned int i = 0; i < inverse_mass.size(); ++i)
      acceleration_owned[i] = inverse_mass[i] * force_local[i];
  }



  template <int dim>
  void
  FluidOperator<dim>::sum_forces(double *force_local) const
  {
    nodes.collect(force_local);
  }



  template <int dim>
  void
  FluidOperator<dim>::set_boundary_velocity(const double time,
                                            double *velocity_owned) const
  {
    prescribed.set_velocity(time, velocity_owned);
  }



  template <int dim>
  void
  FluidOperator<dim>::set_boundary_acceleration(
    const double time,
    double *acceleration_owned) const
  {
    prescribed.set_acceleration(time, acceleration_owned);
  }



  template <int dim>
  void
  FluidOperator<dim>::apply_constraints(double *velocity_owned) const
  {
    for (unsigned int i = 0; i < inverse_mass.size(); ++i)
      if (inverse_mass[i] == 0)
        velocity_owned[i] = 0;
  }



  template <int dim>
  double
  FluidOperator<dim>::max_stable_step() const
  {
    const double h  = smallest_size;
    const double c  = fluid_parameters.sound_speed;
    const double nu = fluid_parameters.viscosity / fluid_parameters.density;
    double step     = 3.87 * h / (2 * c);
    if (nu > 0)
      step = std::min(step, 2. * h * h / (4 * nu));
    // beyond 1.2 rho c the modes at an end are overdamped (found with a
    // one-dimensional chain: 1.36, 0.88, 0.54 h/c for Z = 1.5, 2, 3 rho c)
    const double impedance = fluid_parameters.density * c;
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (boundaries.type[side] == FluidBoundary::pressure_end &&
          boundaries.impedance[side] > 1.2 * impedance)
        step = std::min(step,
                        2.5 * fluid_parameters.density * h /
                          (2 * boundaries.impedance[side]));
    return step;
  }



  template <int dim>
  unsigned int
  FluidOperator<dim>::n_owned_nodes() const
  {
    return nodes.n_owned();
  }



  template <int dim>
  unsigned int
  FluidOperator<dim>::n_local_nodes() const
  {
    return nodes.n_local();
  }



  template <int dim>
  unsigned int
  FluidOperator<dim>::n_owned_cells() const
  {
    return n_owned;
  }



  template <int dim>
  unsigned int
  FluidOperator<dim>::n_active_cells() const
  {
    const unsigned int n = n_owned - inactive.size();
    return dealii::Utilities::MPI::sum(n, comm);
  }



  template <int dim>
  const typename FluidOperator<dim>::Cell &
  FluidOperator<dim>::cell(const unsigned int i) const
  {
    return cells[i];
  }



  template <int dim>
  unsigned int
  FluidOperator<dim>::n_known_cells() const
  {
    return cells.size();
  }



  template <int dim>
  int
  FluidOperator<dim>::locate(const dealii::Point<dim> &point,
                             const int hint) const
  {
    return locator.locate(point, hint);
  }



  template <int dim>
  bool
  FluidOperator<dim>::is_active_cell(const unsigned int owned_cell) const
  {
    return active[owned_cell];
  }



  template <int dim>
  bool
  FluidOperator<dim>::is_constrained_node(const unsigned int local_node) const
  {
    return held[local_node] == (1 << dim) - 1;
  }



  template <int dim>
  bool
  FluidOperator<dim>::is_driven_node(const unsigned int local_node) const
  {
    return driven[local_node];
  }



  template <int dim>
  const NodeNumbering<dim> &
  FluidOperator<dim>::numbering() const
  {
    return nodes;
  }



  template <int dim>
  const dealii::Point<dim> &
  FluidOperator<dim>::position(const unsigned int owned_node) const
  {
    return node_position[owned_node];
  }



  template <int dim>
  double
  FluidOperator<dim>::nodal_mass(const unsigned int local_node) const
  {
    return mass[local_node];
  }



  template <int dim>
  unsigned int
  FluidOperator<dim>::owned_cell_index(
    const unsigned int active_cell_index) const
  {
    return index_of_active_cell[active_cell_index];
  }



  template <int dim>
  const FluidParameters &
  FluidOperator<dim>::parameters() const
  {
    return fluid_parameters;
  }

  template class FluidOperator<2>;
  template class FluidOperator<3>;
} // namespace coapt
