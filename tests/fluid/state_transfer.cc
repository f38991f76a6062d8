// Velocities on a mesh that changes: smooth flow is interpolated to better than
// second order, and its kinetic energy stays as it is, whatever is divided.

#include <coapt/fluid/nodal_gradients.h>

#include "fluid_case.h"

using namespace coapt;
using dealii::Point;

namespace
{
  /** One component of a smooth flow in the unit box, zero at its sides. */
  template <int dim>
  double
  flow(const Point<dim> &x, const int component)
  {
    double value = 1;
    for (int d = 0; d < dim; ++d)
      value *= std::sin((d == component ? 2 : 1) * dealii::numbers::PI * x[d]);
    return value;
  }

  template <int dim>
  FluidCase<dim>
  unit_box()
  {
    Point<dim> upper;
    std::array<unsigned int, dim> cells;
    for (int d = 0; d < dim; ++d)
      upper[d] = 1;
    cells.fill(4);
    return FluidCase<dim>(
      {}, all_sides<dim>(FluidBoundary::no_slip), Point<dim>(), upper, cells);
  }

  /** Two sizes of cells, the smaller ones around @p at on the diagonal. */
  template <int dim>
  typename FluidGrid<dim>::WantedLevel
  ball(const double at)
  {
    return [at](const Point<dim> &x, const double size) {
      Point<dim> centre;
      for (int d = 0; d < dim; ++d)
        centre[d] = at;
      return x.distance(centre) < 0.3 + size ? 2u : 1u;
    };
  }

  /** The largest error of the velocity (m/s) after dividing all cells of edge
   * 1/(4 * 2^level) m. */
  template <int dim>
  double
  error_after_division(const unsigned int level)
  {
    auto test      = unit_box<dim>();
    const auto all = [](const unsigned int n) {
      return [n](const Point<dim> &, const double) { return n; };
    };
    test.set_up(all(level));
    test.set_velocity(flow<dim>);
    test.grid.adapt(all(level + 1), test.op, test.u, test.p);
    double error = 0;
    for (unsigned int i = 0; i < test.op.n_owned_nodes(); ++i)
      for (int d = 0; d < dim; ++d)
        error = std::max(error,
                         std::abs(test.u[dim * i + d] -
                                  flow<dim>(test.op.position(i), d)));
    return dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);
  }

  template <int dim>
  void
  run()
  {
    const std::string in = " in " + std::to_string(dim) + "D";
    const double coarse  = error_after_division<dim>(1);
    const double fine    = error_after_division<dim>(2);
    check("more than second order" + in, fine < coarse / 6, fine / coarse);

    auto test = unit_box<dim>();
    test.set_up(ball<dim>(0.3));
    test.set_velocity(flow<dim>);
    const double before = test.op.kinetic_energy(test.u.data());
    test.grid.adapt(ball<dim>(0.6), test.op, test.u, test.p);
    check_relative("kinetic energy" + in,
                   test.op.kinetic_energy(test.u.data()),
                   before,
                   1e-13);
    // one number that depends on every node, the same on any number of ranks
    double sum = 0;
    for (unsigned int i = 0; i < test.op.n_owned_nodes(); ++i)
      for (int d = 0; d < dim; ++d)
        sum += test.op.nodal_mass(i) * test.u[dim * i + d] *
          std::cos(9 * test.op.position(i)[0] + d);
    sum = dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    check_relative("moment" + in,
                   sum,
                   dim == 2 ? -202.8717319598046 : -130.2564338914704,
                   1e-12);
  }

  /** The flanks of a jet are divided after its middle: there, cubic
   * interpolation alone gives back a part of the kinetic energy only. */
  template <int dim>
  void
  jet()
  {
    const auto band = [](const double width) {
      return [width](const Point<dim> &x, const double size) {
        return std::abs(x[1] - 0.5) < width + size ? 3u : 2u;
      };
    };
    auto test = unit_box<dim>();
    test.set_up(band(0.05));
    test.set_velocity([](const Point<dim> &x, const int d) {
      const double y = (x[1] - 0.5) / 0.15;
      return d == 0 ? flow<dim>(x, 1) * std::exp(-y * y) : 0.;
    });
    const double before = test.op.kinetic_energy(test.u.data());
    test.grid.adapt(band(0.1), test.op, test.u, test.p);
    check_relative("kinetic energy of a jet in " + std::to_string(dim) + "D",
                   test.op.kinetic_energy(test.u.data()),
                   before,
                   1e-13);
  }

  /** Gradients of parabolas are exact inside, also where cells of two sizes
   * meet, but for nodes with a hanging one beside them. */
  template <int dim>
  void
  parabola()
  {
    auto test = unit_box<dim>();
    test.set_up(
      [](const Point<dim> &x, const double) { return x[0] < 0.5 ? 1u : 2u; });
    test.set_velocity([](const Point<dim> &x,
                         const int d) { return x[0] * x[0] + d * x[1]; },
                      false);
    std::vector<double> velocity(dim * test.op.n_local_nodes());
    test.op.gather(test.u.data(), velocity.data());
    const auto gradients = nodal_gradients(test.op, velocity);
    double error         = 0;
    for (unsigned int i = 0; i < test.op.n_owned_nodes(); ++i)
      for (int d = 0; d < dim; ++d)
        {
          const double x = test.op.position(i)[0];
          if (x > 0 && x < 1 && test.op.nodal_mass(i) > 0)
            error = std::max({error,
                              std::abs(gradients[0][dim * i + d] - 2 * x),
                              std::abs(gradients[1][dim * i + d] - d)});
        }
    check("gradients in " + std::to_string(dim) + "D", error < 1e-13, error);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  parabola<2>();
  parabola<3>();
  run<2>();
  run<3>();
  jet<2>();
  jet<3>();
}
