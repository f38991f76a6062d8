#ifndef coapt_metrics_surface_flux_h
#define coapt_metrics_surface_flux_h

#include <deal.II/base/point.h>

#include <mpi.h>

#include <array>
#include <vector>

namespace coapt
{
  template <int dim>
  class FluidOperator;

  /**
   * Flow of blood through a moving surface (m^3/s), towards the atrium: the
   * integral of (u - v) . n with the area vectors to the ventricular side, by
   * the midpoint rule. For the leaflet, what numerical leakage lets through
   * the tissue; what flows through gaps is the rest of the leak. Corners have
   * @p points (m) and @p velocities (m/s), the fluid local nodal velocities.
   * Triangles outside the fluid carry nothing. Collective.
   */
  double
  flux_through_surface(
    const FluidOperator<3> &fluid,
    const std::vector<double> &fluid_velocity,
    const std::vector<dealii::Point<3>> &points,
    const std::vector<dealii::Tensor<1, 3>> &velocities,
    const std::vector<std::array<unsigned int, 3>> &triangles,
    MPI_Comm communicator);
} // namespace coapt

#endif
