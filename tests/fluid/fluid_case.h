#ifndef coapt_tests_fluid_fluid_case_h
#define coapt_tests_fluid_fluid_case_h

#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>
#include <vector>

#include "tests.h"

/** A fluid in a box with its state, and a small time integrator. */
template <int dim>
struct FluidCase
{
  using Point = dealii::Point<dim>;

  FluidCase(const coapt::FluidParameters &parameters,
            const coapt::FluidBoundaries<dim> &boundaries,
            const Point &lower,
            const Point &upper,
            const std::array<unsigned int, dim> &cells,
            const std::function<double(const Point &)> &lumen = {})
    : grid(MPI_COMM_WORLD, lower, upper, cells)
    , op(parameters, boundaries, lumen)
  {
  }

  /** Refines, sets up the operator, and a state of rest. */
  void
  set_up(const typename coapt::FluidGrid<dim>::WantedLevel &level)
  {
    grid.refine_to(level);
    op.reinit(grid);
    u.assign(dim * op.n_owned_nodes(), 0.);
    p.assign(op.n_owned_cells(), 0.);
  }

  /** The position of a corner of a cell. */
  Point
  corner(const typename coapt::FluidOperator<dim>::Cell &cell,
         const unsigned int i) const
  {
    Point x = cell.lower;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] += ((i >> d) & 1) * cell.size;
    return x;
  }

  /** Sets the owned velocities to f(position, component), and to zero at
   * constraints if @p constrained. */
  void
  set_velocity(const std::function<double(const Point &, int)> &f,
               const bool constrained = true)
  {
    for (unsigned int i = 0; i < op.n_owned_nodes(); ++i)
      for (int d = 0; d < dim; ++d)
        u[dim * i + d] = f(op.position(i), d);
    if (constrained)
      op.apply_constraints(u.data());
  }

  /** Sets the pressures to f(center). */
  void
  set_pressure(const std::function<double(const Point &)> &f)
  {
    for (unsigned int c = 0; c < op.n_owned_cells(); ++c)
      {
        Point x = op.cell(c).lower;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] += 0.5 * op.cell(c).size;
        p[c] = f(x);
      }
  }

  /** One evaluation of the right-hand side. */
  void
  evaluate(const double time,
           const std::vector<double> &velocity,
           const std::vector<double> &pressure,
           std::vector<double> &acceleration,
           std::vector<double> &pressure_rate)
  {
    local.resize(dim * op.n_local_nodes());
    force.assign(dim * op.n_local_nodes(), 0.);
    acceleration.resize(velocity.size());
    pressure_rate.resize(pressure.size());
    op.gather(velocity.data(), local.data());
    op.add_forces(
      time, local.data(), pressure.data(), force.data(), pressure_rate.data());
    op.finish(force.data(), acceleration.data());
  }

  /** A step of the scheme of Kinnmark and Gray, five stages, third order. */
  void
  step(double &time, const double dt)
  {
    std::vector<double> u1, p1, uk, pk;
    evaluate(time, u, p, u1, p1);
    uk                   = u1;
    pk                   = p1;
    const double shift[] = {1. / 5, 1. / 5, 1. / 3, 2. / 3};
    for (const double a : shift)
      {
        for (unsigned int i = 0; i < u.size(); ++i)
          uk[i] = u[i] + a * dt * uk[i];
        for (unsigned int i = 0; i < p.size(); ++i)
          pk[i] = p[i] + a * dt * pk[i];
        const std::vector<double> us = uk, ps = pk;
        evaluate(time + a * dt, us, ps, uk, pk);
      }
    for (unsigned int i = 0; i < u.size(); ++i)
      u[i] += dt * (0.25 * u1[i] + 0.75 * uk[i]);
    for (unsigned int i = 0; i < p.size(); ++i)
      p[i] += dt * (0.25 * p1[i] + 0.75 * pk[i]);
    time += dt;
  }

  /** Sum over all ranks of a.b. */
  static double
  dot(const std::vector<double> &a, const std::vector<double> &b)
  {
    double sum = 0;
    for (unsigned int i = 0; i < a.size(); ++i)
      sum += a[i] * b[i];
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  /** The largest absolute value over all ranks. */
  static double
  largest(const std::vector<double> &a)
  {
    double value = 0;
    for (const double x : a)
      value = std::max(value, std::abs(x));
    return dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
  }

  coapt::FluidGrid<dim> grid;
  coapt::FluidOperator<dim> op;
  std::vector<double> u, p;
  std::vector<double> local, force;
};

/** All sides alike. */
template <int dim>
coapt::FluidBoundaries<dim>
all_sides(const coapt::FluidBoundary type)
{
  coapt::FluidBoundaries<dim> boundaries;
  boundaries.type.fill(type);
  return boundaries;
}

/** A number in (-1, 1) that depends on the position alone, and so not on the
 * number of ranks. */
template <int dim>
double
noise(const dealii::Point<dim> &x, const int seed)
{
  double phase = 0.7 * seed + 0.3;
  for (int d = 0; d < dim; ++d)
    phase += (7123.1 + 1713.7 * d + 311.3 * seed) * x[d];
  const double s = 437.585 * std::sin(phase);
  return 2 * (s - std::floor(s)) - 1;
}

#endif
