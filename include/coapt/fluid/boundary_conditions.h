#ifndef coapt_fluid_boundary_conditions_h
#define coapt_fluid_boundary_conditions_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>

namespace coapt
{
  /** What a side of the fluid's box does to the fluid. */
  enum class FluidBoundary
  {
    /** All velocity components are zero. */
    no_slip,
    /** The normal velocity is zero, the tangential traction is zero. */
    slip,
    /** Traction -(p(t) + Z u.n) n, tangential velocity zero. */
    pressure_end,
    /** All velocity components are those of a given function. */
    velocity
  };

  /**
   * The sides of the fluid's box, numbered as in deal.II's colorized
   * hyper-rectangle: side 2 d is the lower and 2 d + 1 the upper one in
   * direction d.
   *
   * With convection the pressure of an end is the *total* pressure
   * p + rho |u|^2 / 2: the skew-symmetric form has that natural boundary
   * condition, and it makes the power of an end exactly p(t) times the inflow.
   *
   * A node on two or more sides is held by the first of no_slip, velocity that
   * is among them, and by all of them otherwise. So the corners of a
   * lid-driven cavity rest, and nothing leaks through the walls beside them.
   */
  template <int dim>
  struct FluidBoundaries
  {
    /** Kind of each side. */
    std::array<FluidBoundary, 2 * dim> type{};

    /** Pressure p(t) in Pa, time in s; used on pressure ends only. */
    std::array<std::function<double(double)>, 2 * dim> pressure;

    /** Impedance Z >= 0 in Pa s/m; used on pressure ends only. */
    std::array<double, 2 * dim> impedance{};

    /** Velocity (m/s) by position (m) and time (s) on all sides of the kind
     * velocity. */
    std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &, double)>
      velocity;
  };
} // namespace coapt

#endif
