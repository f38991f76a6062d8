#include <coapt/coupled/enclosed_fluid.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  namespace
  {
    /** Points of a cell and direction that tell how much of it is solid. */
    constexpr double points_per_cell = 4;
  } // namespace



  template <int dim>
  EnclosedFluid<dim>::EnclosedFluid(const SimplexMesh<dim> &mesh,
                                    const FluidOperator<dim> &fluid,
                                    const double cell_size,
                                    MPI_Comm communicator)
    : fluid(fluid)
    , points(mesh,
             simplex_lattice(mesh, cell_size / points_per_cell),
             communicator)
  {
  }



  template <int dim>
  void
  EnclosedFluid<dim>::update(const double *X)
  {
    // Each time, since points in cells of other ranks would not count.
    points.distribute(fluid, X, no_multiplier);
    points.update(fluid, X, no_multiplier.data());

    const auto &parameters = fluid.parameters();
    const double c         = parameters.sound_speed;
    const auto volume      = points.solid_volume(fluid);
    cells.clear();
    for (unsigned int cell = 0; cell < volume.size(); ++cell)
      {
        const double h      = fluid.cell(cell).size;
        const double all    = std::pow(h, dim);
        const double within = 4 * (volume[cell] / all - 0.75);
        if (within > 0)
          cells.push_back({cell,
                           std::min(1., within) * 0.02 * c / h,
                           all / (parameters.density * c * c)});
      }
  }



  template <int dim>
  void
  EnclosedFluid<dim>::add_rate(const double *pressure, double *pressure_rate)
  {
    for (const Cell &cell : cells)
      pressure_rate[cell.number] -= cell.rate * pressure[cell.number];
  }



  template <int dim>
  double
  EnclosedFluid<dim>::power(const double *pressure) const
  {
    double result = 0;
    for (const Cell &cell : cells)
      {
        const double p = pressure[cell.number];
        result += cell.rate * cell.compliance * p * p;
      }
    return result;
  }

  template class EnclosedFluid<2>;
  template class EnclosedFluid<3>;
} // namespace coapt
