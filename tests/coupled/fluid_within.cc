// The pressure of the fluid within a solid, taken off the solid's stress: what
// the solid loses goes to the fluid's compression, uniform pressures act on the
// surface alone, and fluid within a solid is compressed by no motion.
#include <coapt/immersion/fluid_within.h>

#include "coupled_case.h"

using namespace coapt;
using dealii::Point;

namespace
{
  /** A block in a box, tilted and away from all nodes of the fluid. */
  template <int dim>
  CoupledSetup<dim>
  tilted_block()
  {
    std::array<unsigned int, dim> n;
    n.fill(4);
    const auto block = make_block<dim>(n, [](const Point<dim> &r) {
      Point<dim> x;
      for (int d = 0; d < dim; ++d)
        x[d] = 5.3e-3 + 4.7e-3 * r[d] + 0.6e-3 * r[(d + 1) % dim];
      return x;
    });
    return free_in_box(block, 0.25e-3);
  }

  /** What fluid of given pressure within a moving solid does. */
  struct Action
  {
    std::vector<double> force; // N, on the solid's nodes
    std::vector<double> rate;  // Pa/s
  };

  template <int dim>
  Action
  act(const CoupledCase<dim> &c,
      const FluidWithin<dim> &within,
      const std::vector<double> &pressure,
      const std::vector<double> &V)
  {
    Action action{std::vector<double>(V.size(), 0.),
                  std::vector<double>(c.fluid.n_owned_cells(), 0.)};
    within.add(pressure.data(),
               V.data(),
               action.force.data(),
               action.rate.data());
    return action;
  }

  template <int dim>
  void
  check_power(const std::string &name,
              const CoupledCase<dim> &c,
              const FluidWithin<dim> &within)
  {
    const double modulus = 1060 * 50. * 50.;
    std::vector<double> V, pressure;
    for (const auto &x : c.block.mesh.points)
      for (int d = 0; d < dim; ++d)
        V.push_back(noise(x, d));
    for (unsigned int i = 0; i < c.fluid.n_owned_cells(); ++i)
      pressure.push_back(1e3 * noise(c.fluid.cell(i).lower, 5));
    const Action a    = act(c, within, pressure, V);
    double from_solid = 0, to_fluid = 0;
    for (unsigned int i = 0; i < V.size(); ++i)
      from_solid -= a.force[i] * V[i];
    for (unsigned int i = 0; i < pressure.size(); ++i)
      to_fluid +=
        std::pow(c.fluid.cell(i).size, dim) / modulus * pressure[i] * a.rate[i];
    check_relative(name + ", power", to_fluid, from_solid, 1e-12);
  }

  template <int dim>
  void
  check_uniform_pressure(const std::string &name,
                         const CoupledCase<dim> &c,
                         const FluidWithin<dim> &within)
  {
    const std::vector<double> pressure(c.fluid.n_owned_cells(), 1e3);
    const std::vector<double> V(dim * c.block.unit.size(), 0.);
    const Action a = act(c, within, pressure, V);
    double inner = 0, outer = 0;
    for (unsigned int n = 0; n < c.block.unit.size(); ++n)
      {
        bool inside = true;
        for (int d = 0; d < dim; ++d)
          inside = inside && std::abs(c.block.unit[n][d] - 0.5) < 0.49;
        for (int d = 0; d < dim; ++d)
          {
            double &largest = inside ? inner : outer;
            largest         = std::max(largest, std::abs(a.force[dim * n + d]));
          }
      }
    check(name + ", uniform pressure", inner < 1e-12 * outer, inner / outer);
  }

  /** Fluid in cells deep in the block that swells with it, -rho c^2 div u and
   * what is added. */
  template <int dim>
  void
  check_compression(const std::string &name,
                    const CoupledCase<dim> &c,
                    const FluidWithin<dim> &within)
  {
    const double modulus = 1060 * 50. * 50., strain_rate = 3;
    std::vector<double> V;
    for (const auto &x : c.block.mesh.points)
      for (int d = 0; d < dim; ++d)
        V.push_back(strain_rate * x[d]);
    const std::vector<double> pressure(c.fluid.n_owned_cells(), 0.);
    const Action a = act(c, within, pressure, V);
    double least = 1e300, largest = -1e300;
    for (unsigned int i = 0; i < pressure.size(); ++i)
      {
        bool inside = true;
        for (int d = 0; d < dim; ++d)
          inside = inside && c.fluid.cell(i).lower[d] > 6.1e-3 &&
            c.fluid.cell(i).lower[d] < 8.9e-3;
        if (!inside)
          continue;
        const double relative = a.rate[i] / (modulus * dim * strain_rate);
        least                 = std::min(least, relative);
        largest               = std::max(largest, relative);
      }
    check(name + ", swelling, least", least > 0.9, least);
    check(name + ", swelling, largest", largest < 1.1, largest);
  }

  template <int dim>
  void
  test()
  {
    CoupledCase<dim> c(tilted_block<dim>());
    FluidWithin<dim> within(c.block.mesh, c.points);
    const std::string name = std::to_string(dim) + "D";
    check(name + ", owns all cells",
          within.update(c.fluid, as_array(c.block.mesh.points).data()));
    check_power(name, c, within);
    check_uniform_pressure(name, c, within);
    check_compression(name, c, within);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test<2>();
  test<3>();
}
