// Fluid within a body that is coupled at its surface: it goes to zero pressure
// in the cells that the body fills, also as it moves, and nowhere else.
#include <coapt/coupled/enclosed_fluid.h>

#include "coupled_case.h"

using namespace coapt;
using dealii::Point;

namespace
{
  constexpr double h = 1e-3, begin = 5.3e-3, size = 5e-3;

  template <int dim>
  CoupledSetup<dim>
  square_block()
  {
    std::array<unsigned int, dim> n;
    n.fill(5);
    const auto block = make_block<dim>(n, [](const Point<dim> &r) {
      Point<dim> x;
      for (int d = 0; d < dim; ++d)
        x[d] = begin + size * r[d];
      return x;
    });
    return free_in_box(block, h);
  }

  /** How much of the interval [x, x + h] lies in the block at @p way from its
   * first place. */
  double
  overlap(const double x, const double way)
  {
    const double from = std::max(x, begin + way);
    const double to   = std::min(x + h, begin + way + size);
    return std::max(0., to - from) / h;
  }

  template <int dim>
  void
  test()
  {
    CoupledCase<dim> c(square_block<dim>());
    EnclosedFluid<dim> enclosed(c.block.mesh, c.fluid, h, MPI_COMM_WORLD);
    const double rate    = 0.02 * c.fluid.parameters().sound_speed / h;
    const double modulus = 1060 * 50. * 50.;
    std::vector<double> pressure(c.fluid.n_owned_cells());
    for (unsigned int i = 0; i < pressure.size(); ++i)
      pressure[i] = 1e3 * (1.5 + noise(c.fluid.cell(i).lower, 5));

    // 0.6 cells of the sides count for 0.9 of the cell; then far away
    for (const double way : {0., 0.6e-3, -4e-3})
      {
        auto X = as_array(c.block.mesh.points);
        for (double &x : X)
          x += way;
        enclosed.update(X.data());
        std::vector<double> change(pressure.size(), 0.);
        enclosed.add_rate(pressure.data(), change.data());

        double power = 0, error = 0;
        unsigned int draining = 0;
        for (unsigned int i = 0; i < pressure.size(); ++i)
          {
            power -= std::pow(h, dim) / modulus * pressure[i] * change[i];
            double within = 1;
            for (int d = 0; d < dim; ++d)
              within *= overlap(c.fluid.cell(i).lower[d], way);
            const double phi = std::min(1., std::max(0., 4 * (within - 0.75)));
            draining += change[i] < -0.999 * rate * pressure[i];
            error =
              std::max(error, std::abs(change[i] / (rate * pressure[i]) + phi));
          }
        const std::string name =
          std::to_string(dim) + "D, " + std::to_string(std::lround(1e6 * way));
        check(name + " um, as much as the body takes of a cell",
              dealii::Utilities::MPI::max(error, MPI_COMM_WORLD) < 0.6,
              error);
        const double sum =
          dealii::Utilities::MPI::sum(draining, MPI_COMM_WORLD);
        check(name + " um, all cells that it fills",
              sum == std::pow(4, dim),
              sum);
        check_relative(name + " um, power",
                       enclosed.power(pressure.data()),
                       power,
                       1e-12);
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test<2>();
  test<3>();
}
