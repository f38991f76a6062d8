#include <coapt/fluid/fluid_operator.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

// The parts of FluidOperator that measure.
namespace coapt
{
  using dealii::Utilities::MPI::sum;

  template <int dim>
  double
  FluidOperator<dim>::kinetic_energy(const double *velocity_owned) const
  {
    double energy = 0;
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        energy += 0.5 * mass[i] * velocity_owned[dim * i + d] *
          velocity_owned[dim * i + d];
    return sum(energy, comm);
  }



  template <int dim>
  double
  FluidOperator<dim>::acoustic_energy(const double *pressure) const
  {
    double energy = 0;
    for (unsigned int c = 0; c < n_owned; ++c)
      if (active[c])
        energy += 0.5 * pressure[c] * pressure[c] *
          std::pow(cells[c].size, dim) / coefficients.bulk_modulus;
    return sum(energy, comm);
  }



  template <int dim>
  std::array<double, 2>
  FluidOperator<dim>::normal_velocity_integrals(
    const unsigned int side,
    const double *velocity_local) const
  {
    const double outward         = (side % 2 == 1) ? 1 : -1;
    std::array<double, 2> result = {{0., 0.}};
    for (const Face &face : faces[side])
      for (const unsigned int node : face.nodes)
        {
          const double normal = outward * velocity_local[dim * node + side / 2];
          result[0] += face.area_per_node * normal;
          result[1] += face.area_per_node * normal * normal;
        }
    return result;
  }



  template <int dim>
  double
  FluidOperator<dim>::flux(const unsigned int boundary_id,
                           const double *velocity_local) const
  {
    return sum(normal_velocity_integrals(boundary_id, velocity_local)[0], comm);
  }



  template <int dim>
  void
  FluidOperator<dim>::cell_modes(const unsigned int cell,
                                 const double *velocity_local,
                                 double (&modes)[dim][n_corners]) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        for (unsigned int i = 0; i < n_corners; ++i)
          modes[d][i] = velocity_local[dim * cells[cell].nodes[i] + d];
        internal::corners_to_modes<dim>(modes[d]);
      }
  }



  template <int dim>
  FluidPowers
  FluidOperator<dim>::powers(const double time,
                             const double *velocity_local,
                             const double *pressure) const
  {
    FluidPowers result;
    for (unsigned int c = 0; c < n_owned; ++c)
      if (active[c])
        {
          double modes[dim][n_corners];
          cell_modes(c, velocity_local, modes);
          const double h = cells[c].size;
          double viscosity, gradient = 0, hourglass = 0;
          internal::effective_viscosity<dim>(modes, h, coefficients, viscosity);
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int s = 1; s < n_corners; ++s)
              (internal::is_hourglass(s) ? hourglass : gradient) +=
                modes[d][s] * modes[d][s];
          // integral of the squared gradient of the linear part
          const double squares =
            std::pow(h, dim - 2) * 4 / (n_corners * n_corners) * gradient;
          result.viscous += coefficients.viscosity * squares;
          result.artificial += (viscosity - coefficients.viscosity) * squares;
          result.hourglass += coefficients.hourglass * std::pow(h, dim - 1) /
            (n_corners * n_corners) * hourglass;
        }
    result.checkerboard = filter.power(pressure, coefficients.bulk_modulus);
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (boundaries.type[side] == FluidBoundary::pressure_end)
        {
          const auto integral = normal_velocity_integrals(side, velocity_local);
          result.ends -= boundaries.pressure[side](time) * integral[0];
          result.impedance += boundaries.impedance[side] * integral[1];
        }
    for (double *part : {&result.viscous,
                         &result.artificial,
                         &result.hourglass,
                         &result.checkerboard,
                         &result.impedance,
                         &result.ends})
      *part = sum(*part, comm);
    return result;
  }



  template <int dim>
  double
  FluidOperator<dim>::driving_power(const double time,
                                    const double *velocity_owned,
                                    const double *force) const
  {
    std::vector<double> acceleration(dim * nodes.n_owned(), 0.);
    set_boundary_acceleration(time, acceleration.data());
    double power = 0;
    for (unsigned int n = 0; n < nodes.n_owned(); ++n)
      for (unsigned int i = dim * n; i < dim * (n + 1); ++i)
        if (is_driven_node(n))
          power += (mass[n] * acceleration[i] - force[i]) * velocity_owned[i];
    return sum(power, comm);
  }



  template <int dim>
  double
  FluidOperator<dim>::hourglass_rms(const double *velocity_local,
                                    const Mask &mask) const
  {
    double squares = 0;
    unsigned int n = 0;
    for (unsigned int c = 0; c < n_owned; ++c)
      {
        dealii::Point<dim> center = cells[c].lower;
        for (unsigned int d = 0; d < dim; ++d)
          center[d] += 0.5 * cells[c].size;
        if (!active[c] || (mask && !mask(center)))
          continue;
        double modes[dim][n_corners];
        cell_modes(c, velocity_local, modes);
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int s = 1; s < n_corners; ++s)
            if (internal::is_hourglass(s))
              squares += modes[d][s] * modes[d][s];
        ++n;
      }
    squares = sum(squares, comm) / (n_corners * n_corners);
    n       = sum(n, comm);
    return n > 0 ? std::sqrt(squares / n) : 0.;
  }



  template <int dim>
  double
  FluidOperator<dim>::checkerboard_rms(const double *pressure,
                                       const Mask &mask) const
  {
    unsigned int n     = 0;
    const auto counted = [&](const unsigned int first) {
      // the center of the family is the upper corner of its first cell
      dealii::Point<dim> center = cells[first].lower;
      for (unsigned int d = 0; d < dim; ++d)
        center[d] += cells[first].size;
      return !mask || mask(center);
    };
    double squares = filter.sum_of_squares(pressure, counted, n);
    squares        = sum(squares, comm);
    n              = sum(n, comm);
    return n > 0 ? std::sqrt(squares / n) : 0.;
  }



  template <int dim>
  LargestVelocity<dim>
  FluidOperator<dim>::largest_velocity(const double *velocity_owned) const
  {
    LargestVelocity<dim> largest;
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      {
        double square = 0;
        for (unsigned int d = 0; d < dim; ++d)
          square += velocity_owned[dim * i + d] * velocity_owned[dim * i + d];
        // written so that a velocity that is not a number counts as largest
        if (mass[i] > 0 && !(std::sqrt(square) <= largest.speed))
          {
            largest.speed    = std::sqrt(square);
            largest.position = node_position[i];
            if (std::isnan(square))
              break;
          }
      }
    std::vector<double> mine(1, largest.speed);
    for (unsigned int d = 0; d < dim; ++d)
      mine.push_back(largest.position[d]);
    for (const auto &other : dealii::Utilities::MPI::all_gather(comm, mine))
      if (!(other[0] <= largest.speed) && !std::isnan(largest.speed))
        {
          largest.speed = other[0];
          for (unsigned int d = 0; d < dim; ++d)
            largest.position[d] = other[1 + d];
        }
    return largest;
  }

  template double
  FluidOperator<2>::kinetic_energy(const double *) const;
  template double
  FluidOperator<2>::acoustic_energy(const double *) const;
  template double
  FluidOperator<2>::flux(const unsigned int, const double *) const;
  template FluidPowers
  FluidOperator<2>::powers(const double, const double *, const double *) const;
  template double
  FluidOperator<2>::driving_power(const double,
                                  const double *,
                                  const double *) const;
  template double
  FluidOperator<2>::hourglass_rms(const double *, const Mask &) const;
  template double
  FluidOperator<2>::checkerboard_rms(const double *, const Mask &) const;
  template LargestVelocity<2>
  FluidOperator<2>::largest_velocity(const double *) const;
  template double
  FluidOperator<3>::kinetic_energy(const double *) const;
  template double
  FluidOperator<3>::acoustic_energy(const double *) const;
  template double
  FluidOperator<3>::flux(const unsigned int, const double *) const;
  template FluidPowers
  FluidOperator<3>::powers(const double, const double *, const double *) const;
  template double
  FluidOperator<3>::driving_power(const double,
                                  const double *,
                                  const double *) const;
  template double
  FluidOperator<3>::hourglass_rms(const double *, const Mask &) const;
  template double
  FluidOperator<3>::checkerboard_rms(const double *, const Mask &) const;
  template LargestVelocity<3>
  FluidOperator<3>::largest_velocity(const double *) const;
} // namespace coapt
