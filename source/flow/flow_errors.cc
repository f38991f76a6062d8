#include <coapt/flow/flow_errors.h>
#include <coapt/flow/flow_model.h>
#include <coapt/fluid/cell_interpolation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace coapt
{
  using dealii::Point;
  using dealii::Utilities::MPI::max;
  using dealii::Utilities::MPI::sum;

  namespace
  {
    /** Calls action(cell, point, unit point, volume) at all quadrature points
     * of this rank's cells. */
    template <int dim, typename Action>
    void
    for_each_point(const FlowModel<dim> &model, const Action &action)
    {
      static const dealii::QGauss<dim> quadrature(3);
      for (unsigned int c = 0; c < model.fluid().n_owned_cells(); ++c)
        if (model.fluid().is_active_cell(c))
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const auto &cell = model.fluid().cell(c);
              const Point<dim> point =
                cell.lower + cell.size * quadrature.point(q);
              action(c,
                     point,
                     quadrature.point(q),
                     std::pow(cell.size, dim) * quadrature.weight(q));
            }
    }

    template <int dim>
    void
    measure_velocity(const FlowModel<dim> &model,
                     const double time,
                     const double *y,
                     FlowErrors &errors)
    {
      const std::vector<double> velocity = model.local_velocity(y);
      double square = 0, largest = 0;
      for_each_point(model,
                     [&](const unsigned int c,
                         const Point<dim> &x,
                         const Point<dim> &unit_point,
                         const double volume) {
                       const double error =
                         (interpolate<dim>(model.fluid().cell(c),
                                           unit_point,
                                           velocity) -
                          model.exact_velocity(x, time))
                           .norm();
                       square += error * error * volume;
                       largest = std::max(largest, error);
                     });
      errors.velocity_l2  = std::sqrt(sum(square, model.communicator));
      errors.velocity_max = max(largest, model.communicator);
    }

    template <int dim>
    void
    measure_pressure(const FlowModel<dim> &model,
                     const double time,
                     const double *y,
                     FlowErrors &errors)
    {
      const double *pressure = model.pressure(y);
      // integrals of the error, of its square, and over each cell alone
      double first = 0, second = 0, whole = 0;
      std::vector<double> of_cell(model.fluid().n_owned_cells(), 0.);
      for_each_point(model,
                     [&](const unsigned int c,
                         const Point<dim> &x,
                         const Point<dim> &,
                         const double volume) {
                       const double error =
                         pressure[c] - model.exact_pressure(x, time);
                       of_cell[c] += error * volume;
                       first += error * volume;
                       second += error * error * volume;
                       whole += volume;
                     });
      first             = sum(first, model.communicator);
      second            = sum(second, model.communicator);
      whole             = sum(whole, model.communicator);
      const double mean = model.has_pressure_boundary() ? 0. : first / whole;
      double means      = 0;
      for (unsigned int c = 0; c < of_cell.size(); ++c)
        if (model.fluid().is_active_cell(c))
          {
            const double volume = std::pow(model.fluid().cell(c).size, dim);
            means += std::pow(of_cell[c] / volume - mean, 2) * volume;
          }
      errors.pressure_l2 = std::sqrt(
        std::max(0., second - 2 * mean * first + mean * mean * whole));
      errors.pressure_means_l2 = std::sqrt(sum(means, model.communicator));
    }
  } // namespace



  void
  FlowErrors::take_larger(const FlowErrors &other)
  {
    // fmax prefers a number to what is none
    velocity_l2       = std::fmax(velocity_l2, other.velocity_l2);
    velocity_max      = std::fmax(velocity_max, other.velocity_max);
    pressure_l2       = std::fmax(pressure_l2, other.pressure_l2);
    pressure_means_l2 = std::fmax(pressure_means_l2, other.pressure_means_l2);
  }



  template <int dim>
  FlowErrors
  flow_errors(const FlowModel<dim> &model, const double time, const double *y)
  {
    FlowErrors errors;
    if (model.exact_velocity)
      measure_velocity(model, time, y, errors);
    if (model.exact_pressure)
      measure_pressure(model, time, y, errors);
    return errors;
  }

  template FlowErrors
  flow_errors(const FlowModel<2> &, const double, const double *);
  template FlowErrors
  flow_errors(const FlowModel<3> &, const double, const double *);
} // namespace coapt
