#ifndef coapt_fluid_prescribed_velocity_h
#define coapt_fluid_prescribed_velocity_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace coapt
{
  /**
   * Nodes whose velocity is a given function g(x, t). They follow it through
   * its time derivative, so that the nodal velocities stay unknowns of the
   * same system of ordinary differential equations as all others and a
   * Runge-Kutta method keeps its order; writing g into the stages instead
   * reduces it to two (Carpenter, Gottlieb, Abarbanel and Don 1995).
   *
   * Evaluating g may cost more than all else. It is therefore sampled at four
   * times of an interval of some steps, and the derivative is that of the
   * cubic through them, which is continuous in value from one interval to the
   * next: the error of g is of fourth order in the interval and does not add
   * up.
   */
  template <int dim>
  class PrescribedVelocity
  {
  public:
    /** Velocity (m/s) at a position (m) and time (s). */
    using Function =
      std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &, double)>;

    /** The owned @p nodes, their positions, g, and the length of an interval
     * (s). */
    void
    reinit(const std::vector<unsigned int> &nodes,
           const std::vector<dealii::Point<dim>> &positions,
           const Function &function,
           const double interval);

    /** Writes g(t) to the entries of the nodes. */
    void
    set_velocity(const double time, double *velocity_owned) const;

    /** Writes dg/dt to the entries of the nodes. Cheap if times do not go
     * back and forth between intervals. */
    void
    set_acceleration(const double time, double *acceleration_owned) const;

  private:
    void
    sample(const double index) const;

    std::vector<unsigned int> nodes;
    std::vector<dealii::Point<dim>> positions;
    Function function;
    double interval = 1;

    mutable double sampled_interval = 0;
    /** The three coefficients of the derivative in powers of (t - start) /
     * interval, for each entry of the nodes (m/s^2). */
    mutable std::vector<std::array<double, 3>> derivative;
  };
} // namespace coapt

#endif
