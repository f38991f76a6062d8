#ifndef coapt_time_central_differences_h
#define coapt_time_central_differences_h

#include <functional>
#include <vector>

namespace coapt
{
  /**
   * Central differences for X'' = A(t, X, X') - alpha X' with velocities
   * between the steps (Belytschko, Liu, Moran: Nonlinear Finite Elements, box
   * 6.1):
   *   V_{n+1/2} = [(1 - alpha h/2) V_{n-1/2} + h A(t_n, X_n, V_{n-1/2})]
   *               / (1 + alpha h/2),
   *   X_{n+1} = X_n + dt V_{n+1/2},
   * with the mean h of the steps before and after t_n. One evaluation a step,
   * second order, momentum and (in the mean) energy are conserved; what depends
   * on the velocity lags by half a step. Stable below
   * dt = 2/omega (sqrt(1 + xi^2) - xi).
   */
  class CentralDifferences
  {
  public:
    /** The accelerations of positions and velocities. */
    using Acceleration = std::function<
      void(double t, const double *X, const double *V, double *A)>;

    /** Acts on positions and velocities at the end @p t of a step of length
     * @p dt. */
    using PostStep =
      std::function<void(double t, double *X, double *V, double dt)>;

    /** @p mass_damping is alpha (1/s). */
    CentralDifferences(const Acceleration &acceleration,
                       const double mass_damping,
                       const PostStep &post_step);

    /** Starts at time @p t from the positions and velocities @p state (first
     * half positions, second velocities), which every step() writes. */
    void
    start(const double t, std::vector<double> &state);

    /** One step of length @p dt (s). */
    void
    step(const double dt);

    /** Time reached (s). */
    double
    time() const
    {
      return current_time;
    }

    /** Number of steps since construction. */
    unsigned long
    n_steps() const
    {
      return steps;
    }

  private:
    const Acceleration acceleration;
    const double mass_damping;
    const PostStep post_step;
    std::vector<double> *state = nullptr;
    std::vector<double> A;
    double current_time = 0, last_step = 0;
    unsigned long steps = 0;
  };
} // namespace coapt

#endif
