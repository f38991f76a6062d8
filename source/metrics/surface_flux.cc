#include <deal.II/base/mpi.h>

#include <coapt/fluid/cell_interpolation.h>
#include <coapt/metrics/surface_flux.h>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  double
  flux_through_surface(
    const FluidOperator<3> &fluid,
    const std::vector<double> &fluid_velocity,
    const std::vector<Point<3>> &points,
    const std::vector<Tensor<1, 3>> &velocities,
    const std::vector<std::array<unsigned int, 3>> &triangles,
    MPI_Comm communicator)
  {
    double flux = 0;
    for (const auto &[a, b, c] : triangles)
      {
        const Tensor<1, 3> ab = points[b] - points[a],
                           ac = points[c] - points[a];
        const Point<3> center(points[a] + (ab + ac) / 3.);
        const int number = fluid.locate(center);
        if (number < 0 || number >= int(fluid.n_owned_cells()) ||
            !fluid.is_active_cell(number))
          continue;
        const auto &cell = fluid.cell(number);
        const Tensor<1, 3> slip =
          interpolate<3>(cell,
                         Point<3>((center - cell.lower) / cell.size),
                         fluid_velocity) -
          (velocities[a] + velocities[b] + velocities[c]) / 3.;
        // The area vector points to the ventricle.
        flux -= 0.5 * cross_product_3d(ab, ac) * slip;
      }
    return dealii::Utilities::MPI::sum(flux, communicator);
  }
} // namespace coapt
