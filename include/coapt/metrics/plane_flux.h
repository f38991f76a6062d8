#ifndef coapt_metrics_plane_flux_h
#define coapt_metrics_plane_flux_h

#include <deal.II/base/point.h>

#include <mpi.h>

#include <vector>

namespace coapt
{
  template <int dim>
  class FluidOperator;

  /** A plane through @p point (m), with a normal of any length. */
  struct Plane
  {
    dealii::Point<3> point;
    dealii::Tensor<1, 3> normal;
  };

  /**
   * Flow of blood (m^3/s) through a plane within the fluid, positive along its
   * normal: the integral of u . n over the polygons in which the plane cuts
   * the cells, exact for the interpolated velocity. @p fluid_velocity has the
   * local nodal velocities (m/s). Collective.
   */
  double
  flux_through_plane(const FluidOperator<3> &fluid,
                     const std::vector<double> &fluid_velocity,
                     const Plane &plane,
                     MPI_Comm communicator);
} // namespace coapt

#endif
