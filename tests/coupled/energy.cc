// Energy and stability of the coupled system in time: without dissipation the
// energy is conserved as the step tends to zero and bounded at any stable
// step; the limit of the step; a method that fails.

#include <coapt/base/exceptions.h>

#include "coupled_case.h"

using namespace coapt;

namespace
{
  /** Random velocities of fluid and solid, 0.1 m/s at most. */
  void
  add_noise(CoupledCase<2> &c)
  {
    c.set_velocity([](const auto &x, int d) { return 0.1 * noise(x, d); },
                   [](const auto &x, int d) { return 0.1 * noise(x, 7 + d); });
    // The held nodes do not move.
    const auto &at = c.system.layout();
    for (unsigned int n = 0; n < at.n_solid_nodes; ++n)
      if (c.block.unit[n][1] < 1e-9 || c.block.unit[n][1] > 1 - 1e-9)
        for (int d = 0; d < 2; ++d)
          c.y[at.solid_velocity() + 2 * n + d] = 0;
  }

  /** Relative loss of energy after a fixed time in @p n_steps steps, with the
   * coefficients of the multiplier fixed. */
  double
  energy_loss(const unsigned int n_steps)
  {
    CoupledCase<2> c(closed_box(0));
    add_noise(c);
    const RelaxationCoefficients k =
      relaxation_coefficients(1060, 1060, 10e-6, 0);
    const double time = 200e-6, dt = time / n_steps;
    c.step(1e-9, &k); // sets the coefficients
    const double before = c.energy();
    for (unsigned int n = 0; n < n_steps; ++n)
      c.step(dt, &k);
    return 1 - c.energy() / before;
  }

  void
  conservation()
  {
    const double coarse = energy_loss(400), fine = energy_loss(800);
    check("no dissipation, loss of energy by the steps alone",
          std::abs(fine) < 1e-3,
          fine);
    const double order = std::log2(coarse / fine);
    check("no dissipation, loss of third order", order > 2.7, order);
  }

  /** How the energy of noise has changed. */
  struct EnergyHistory
  {
    double largest_gain = -1; // relative, from one sample to the next
    double left         = 0;  // of that at the start
  };

  /** Follows the energy of noise over 200 samples. */
  EnergyHistory
  energy_history(const double damping_ratio, const unsigned int steps_a_sample)
  {
    CoupledCase<2> c(closed_box(damping_ratio));
    add_noise(c);
    const double dt = 0.5 * c.smaller_limit();
    c.step(dt);
    const double first = c.energy();
    double last        = first;
    EnergyHistory history;
    for (unsigned int sample = 0; sample < 200; ++sample)
      {
        for (unsigned int n = 0; n < steps_a_sample; ++n)
          c.step(dt);
        const double now     = c.energy();
        history.largest_gain = std::max(history.largest_gain, now / last - 1);
        last                 = now;
      }
    history.left = last / first;
    return history;
  }

  void
  long_run()
  {
    const EnergyHistory history = energy_history(0, 500);
    check("no dissipation, energy bounded in 100000 steps",
          history.largest_gain < 1e-3 && history.left < 1 && history.left > 0,
          history.largest_gain);
    check("no dissipation, energy left", history.left > 0.01, history.left);
  }

  void
  decay()
  {
    const EnergyHistory history = energy_history(0.5, 20);
    check("drag, energy falls at each sample",
          history.largest_gain < 0,
          history.largest_gain);
    check("drag, energy is lost", history.left < 0.5, history.left);
  }

  /** A plate in a channel with the dissipation of production. @p soft: the
   * fluid's limit is the smaller one; otherwise the solid's. */
  CoupledSetup<2>
  channel(const bool soft)
  {
    Plate plate;
    plate.length      = 16e-3;
    plate.height      = 8e-3;
    plate.x           = 8.13e-3;
    plate.pressure    = 0;
    CoupledSetup<2> s = plate.setup();
    if (soft)
      {
        s.solid.neo_hookean.mu     = 10e3;
        s.solid.neo_hookean.lambda = 50e3;
      }
    return s;
  }

  /** A step of the explicit midpoint rule. */
  void
  midpoint_step(CoupledCase<2> &c, const double dt)
  {
    std::vector<double> middle(c.y.size()), rate(c.y.size());
    c.system.begin_step(dt);
    c.system.rhs(0, c.y.data(), rate.data());
    for (unsigned int i = 0; i < rate.size(); ++i)
      middle[i] = c.y[i] + 0.5 * dt * rate[i];
    c.system.rhs(0, middle.data(), rate.data());
    for (unsigned int i = 0; i < rate.size(); ++i)
      c.y[i] += dt * rate[i];
    c.system.finish_step(0, c.y.data());
  }

  /** Whether the energy of noise does not grow in 1500 steps. The integrator
   * refuses to go on with numbers that are much too large. */
  bool
  is_stable(const CoupledSetup<2> &setup, const double dt, const bool midpoint)
  {
    CoupledCase<2> c(setup);
    add_noise(c);
    c.system.begin_step(dt);
    const double before = c.energy();
    try
      {
        for (unsigned int n = 0; n < 1500; ++n)
          {
            if (midpoint)
              midpoint_step(c, dt);
            else
              c.step(dt);
            if (n % 50 == 49 && !(c.energy() < 2 * before))
              return false;
          }
      }
    catch (const NumericalError &)
      {
        return false;
      }
    return true;
  }

  /** Largest stable step over the smaller limit of fluid and solid. */
  double
  stable_factor(const CoupledSetup<2> &setup, const bool midpoint)
  {
    const double limit = CoupledCase<2>(setup).smaller_limit();
    double stable = 0.02, unstable = 2.5;
    while (unstable > 1.04 * stable)
      {
        const double factor = std::sqrt(stable * unstable);
        if (is_stable(setup, factor * limit, midpoint))
          stable = factor;
        else
          unstable = factor;
      }
    return stable;
  }

  void
  step_limit()
  {
    for (const bool soft : {false, true})
      {
        const std::string name =
          std::string(soft ? "soft" : "stiff") + " plate, ";
        const auto setup    = channel(soft);
        const double factor = stable_factor(setup, false);
        check(name + "largest stable step",
              factor > 0.9 && factor < 1.5,
              factor);
        const double midpoint = stable_factor(setup, true);
        check(name + "midpoint rule fails", midpoint < 0.4 * factor, midpoint);
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  conservation();
  long_run();
  decay();
  step_limit();
}
