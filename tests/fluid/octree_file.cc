// An octree with the state of a fluid is read from files as it was written,
// however the octree was before, and is divided by the work of its cells.

#include <coapt/fluid/octree_file.h>

#include <memory>

#include "fluid_case.h"

using namespace coapt;
using dealii::Point;

namespace
{
  constexpr unsigned int little = 1, much = 20;

  /** A number for each place and component that nothing interpolates. */
  template <int dim>
  double
  noise(const Point<dim> &x, const int component)
  {
    double value = 0.1 + component;
    for (int d = 0; d < dim; ++d)
      value += (d + 1.7) * x[d];
    return std::fmod(std::abs(43758.5453 * std::sin(value)), 1.);
  }

  /** A fluid in the unit box with cells of two sizes, the smaller ones around
   * @p at on the diagonal. */
  template <int dim>
  std::unique_ptr<FluidCase<dim>>
  box_with_ball(const double at)
  {
    Point<dim> upper, centre;
    std::array<unsigned int, dim> cells;
    for (int d = 0; d < dim; ++d)
      {
        upper[d]  = 1;
        centre[d] = at;
      }
    cells.fill(4);
    auto result =
      std::make_unique<FluidCase<dim>>(FluidParameters(),
                                       all_sides<dim>(FluidBoundary::no_slip),
                                       Point<dim>(),
                                       upper,
                                       cells);
    result->set_up([centre](const Point<dim> &x, const double size) {
      return x.distance(centre) < 0.2 + size ? 2u : 0u;
    });
    return result;
  }

  template <int dim>
  unsigned int
  work(const Point<dim> &x)
  {
    return x[0] < 0.3 ? much : little;
  }

  template <int dim>
  void
  run()
  {
    const std::string in   = " in " + std::to_string(dim) + "D";
    const std::string name = "octree_" + std::to_string(dim) + "_" +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    const auto pressure = [](const Point<dim> &x) { return noise(x, 7); };

    const auto writer       = box_with_ball<dim>(0.35);
    FluidCase<dim> &written = *writer;
    written.set_velocity(noise<dim>);
    written.set_pressure(pressure);
    save_octree(name, written.grid, written.op, written.u, written.p);

    const auto reader    = box_with_ball<dim>(0.8);
    FluidCase<dim> &read = *reader;
    read.grid.divide_by(
      [](const Point<dim> &x, const double) { return work(x); });
    load_octree(name, read.grid, read.op, read.u, read.p);

    const auto cells = [](const FluidCase<dim> &fluid) {
      return fluid.grid.triangulation().n_global_active_cells();
    };
    check("as many cells" + in, cells(read) == cells(written), cells(read));
    const double difference =
      std::abs(FluidCase<dim>::dot(read.p, read.p) /
                 FluidCase<dim>::dot(written.p, written.p) -
               1);
    check("as large pressures" + in, difference < 1e-13, difference);

    // against what they are if they are set here
    const std::vector<double> u = read.u, p = read.p;
    read.set_velocity(noise<dim>);
    read.set_pressure(pressure);
    double error = 0;
    for (unsigned int i = 0; i < u.size(); ++i)
      error = std::max(error, std::abs(read.u[i] - u[i]));
    for (unsigned int i = 0; i < p.size(); ++i)
      error = std::max(error, std::abs(read.p[i] - p[i]));
    error = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);
    check("the same state" + in, error == 0, error);

    double own = 0;
    for (unsigned int c = 0; c < read.op.n_owned_cells(); ++c)
      own += work(read.op.cell(c).lower);
    const auto share = dealii::Utilities::MPI::min_max_avg(own, MPI_COMM_WORLD);
    check("as much work for each" + in,
          share.max < 1.2 * share.avg,
          share.max / share.avg);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  run<2>();
  run<3>();
}
