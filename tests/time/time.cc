// The time integrator on equations with a known solution, its stability limit,
// and the choice of the step.

#include <coapt/base/exceptions.h>
#include <coapt/time/central_differences.h>
#include <coapt/time/explicit_integrator.h>
#include <coapt/time/stability_limit.h>
#include <coapt/time/step_control.h>

#include <limits>

#include "tests.h"

using namespace coapt;

namespace
{
  const auto no_post_step = [](double, double *) {};

  /** Error at t = 1 of y' = -2 t y^2, y(0) = 1, whose solution is
   * 1/(1 + t^2). */
  double
  error(const int n_steps)
  {
    std::vector<double> y(1, 1.);
    ExplicitIntegrator integrator(
      MPI_COMM_SELF,
      [](double t, const double *y, double *y_dot) {
        y_dot[0] = -2 * t * y[0] * y[0];
      },
      no_post_step);
    integrator.start(0, y);
    for (int i = 0; i < n_steps; ++i)
      integrator.step(1. / n_steps);
    check("time reached", std::abs(integrator.time() - 1) < 1e-12);
    return std::abs(y[0] - 0.5);
  }

  void
  order()
  {
    const double coarse = error(20), fine = error(40);
    const double order = std::log2(coarse / fine);
    check("third order", order > 2.8 && order < 3.3, order);
    check("error", fine < 1e-5, fine);
  }

  /** A ball that flies upwards and is stopped after each step: the next step
   * must start from what is left, and cost no more evaluations. */
  void
  post_step()
  {
    std::vector<double> y = {0., 1.};
    unsigned int calls    = 0;
    ExplicitIntegrator integrator(
      MPI_COMM_SELF,
      [](double, const double *y, double *y_dot) {
        y_dot[0] = y[1];
        y_dot[1] = 0;
      },
      [&](double, double *y) {
        ++calls;
        y[1] *= 0.5;
      });
    integrator.start(0, y);
    for (int i = 0; i < 3; ++i)
      integrator.step(1.);
    check("post step, velocity", y[1] == 0.125, y[1]);
    check("post step, position", std::abs(y[0] - 1.75) < 1e-14, y[0]);
    check("post step, once a step", calls == 3, calls);
    check("steps and evaluations",
          integrator.n_steps() == 3 && integrator.n_evaluations() <= 16,
          integrator.n_evaluations());
  }

  /** Steps of any length, a new start with another length of the state, and
   * exceptions that pass through the C library. */
  void
  steps_and_errors()
  {
    std::vector<double> y(2, 1.);
    bool fail = false;
    ExplicitIntegrator integrator(
      MPI_COMM_SELF,
      [&](double, const double *y, double *y_dot) {
        if (fail)
          throw NumericalError("broken");
        y_dot[0] = -y[0];
        y_dot[1] = -2 * y[1];
      },
      no_post_step);
    integrator.start(0, y);
    for (const double dt : {0.01, 0.02, 0.005, 0.015})
      integrator.step(dt);
    check("steps of any length",
          std::abs(y[0] - std::exp(-0.05)) < 1e-8 &&
            std::abs(y[1] - std::exp(-0.1)) < 1e-7,
          y[0]);
    y = {1., 1., 5.};
    integrator.start(2., y);
    integrator.step(0.01);
    check("new start",
          std::abs(integrator.time() - 2.01) < 1e-12 &&
            std::abs(y[0] - std::exp(-0.01)) < 1e-9,
          y[0]);

    fail        = true;
    bool caught = false;
    try
      {
        integrator.step(0.01);
      }
    catch (const NumericalError &e)
      {
        caught = std::string(e.what()).find("broken") != std::string::npos;
      }
    check("exception of the right-hand side", caught);
  }

  /** Amplitude of an oscillator of damping ratio @p xi after many steps of
   * omega dt = @p z, or when it is large. */
  double
  amplitude(const double xi, const double z)
  {
    std::vector<double> y = {1., 0.};
    ExplicitIntegrator integrator(
      MPI_COMM_SELF,
      [=](double, const double *y, double *y_dot) {
        y_dot[0] = y[1];
        y_dot[1] = -y[0] - 2 * xi * y[1];
      },
      no_post_step);
    integrator.start(0, y);
    for (int i = 0; i < 2000 && std::hypot(y[0], y[1]) < 1e6; ++i)
      integrator.step(z);
    return std::hypot(y[0], y[1]);
  }

  void
  limits()
  {
    const double limit = kinnmark_gray_limit(0);
    check("limit without damping",
          std::abs(limit - std::sqrt(15.)) < 2e-3,
          limit);
    check("limit falls with damping",
          kinnmark_gray_limit(0.3) > kinnmark_gray_limit(0.9) &&
            kinnmark_gray_limit(0.9) > kinnmark_gray_limit(3.),
          kinnmark_gray_limit(0.9));
    for (const double xi : {0., 0.05, 0.5, 1., 3.})
      {
        const double z   = kinnmark_gray_limit(xi);
        const double low = amplitude(xi, 0.99 * z);
        const double up  = amplitude(xi, 1.02 * z);
        check("damping ratio " + std::to_string(xi).substr(0, 4) +
                ", stable below the limit",
              low < 2,
              low);
        check("damping ratio " + std::to_string(xi).substr(0, 4) +
                ", unstable above",
              up > 1e3,
              up);
      }
  }

  void
  step_control()
  {
    StepParameters parameters;
    parameters.safety   = 0.5;
    parameters.max_step = 1e-4;
    StepControl control(parameters);
    control.update({{"fluid", 30e-6}, {"solid", 20e-6}, {"contact", 25e-6}});
    check("smallest limit",
          std::abs(control.step(1.) - 10e-6) < 1e-18 &&
            control.limiter() == "solid",
          control.step(1.));
    control.update({{"fluid", 4e-6}, {"solid", 20e-6}});
    check("falls at once",
          std::abs(control.step(1.) - 2e-6) < 1e-18 &&
            control.limiter() == "fluid",
          control.step(1.));
    control.update({{"fluid", 30e-6}, {"solid", 20e-6}});
    check("grows slowly",
          control.step(1.) > 2e-6 && control.step(1.) < 2.2e-6,
          control.step(1.));
    for (int i = 0; i < 1000; ++i)
      control.update({{"fluid", 3e-3}, {"solid", 2e-3}});
    check("largest step",
          std::abs(control.step(1.) - 1e-4) < 1e-16 &&
            control.limiter() == "largest step",
          control.step(1.));

    check("last step ends on time", control.step(0.7e-4) == 0.7e-4);
    check("last two steps are equal",
          std::abs(control.step(1.2e-4) - 0.6e-4) < 1e-18);

    for (const double bad : {0., -1., std::numeric_limits<double>::quiet_NaN()})
      {
        bool refused = false;
        try
          {
            control.update({{"fluid", 3e-3}, {"solid", bad}});
          }
        catch (const NumericalError &e)
          {
            refused = std::string(e.what()).find("solid") != std::string::npos;
          }
        check("a limit that is none is refused", refused, bad);
      }
  }
  /** A damped oscillator with central differences: error at t = 1, with steps
   * that vary. */
  double
  central_difference_error(const unsigned int n_steps)
  {
    const double omega = 10, alpha = 2;
    std::vector<double> state = {1., 0.};
    CentralDifferences integrator(
      [&](double, const double *X, const double *, double *A) {
        A[0] = -omega * omega * X[0];
      },
      alpha,
      nullptr);
    integrator.start(0., state);
    for (unsigned int i = 0; i < n_steps; ++i)
      integrator.step(
        (1 + 0.2 * std::sin(6 * 3.14159265358979 * (i + 0.5) / n_steps)) /
        n_steps);
    const double root = std::sqrt(omega * omega - alpha * alpha / 4);
    const double t    = integrator.time();
    return std::abs(
      state[0] -
      std::exp(-alpha / 2 * t) *
        (std::cos(root * t) + alpha / 2 / root * std::sin(root * t)));
  }

  void
  central_differences()
  {
    const double order =
      std::log2(central_difference_error(100) / central_difference_error(200));
    check("central differences, second order",
          order > 1.9 && order < 2.1,
          order);

    // Just below and above the limit.
    for (const double step : {1.99, 2.01})
      {
        std::vector<double> state = {1., 0.};
        unsigned int calls        = 0;
        CentralDifferences integrator(
          [](double, const double *X, const double *, double *A) {
            A[0] = -X[0];
          },
          0.,
          [&](double, double *, double *, double) { ++calls; });
        integrator.start(0., state);
        for (unsigned int i = 0; i < 200; ++i)
          integrator.step(step);
        check(step < 2 ? "central differences, stable"
                       : "central differences, unstable",
              (std::abs(state[0]) < 20) == (step < 2) && calls == 200,
              state[0]);
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  order();
  post_step();
  steps_and_errors();
  limits();
  step_control();
  central_differences();
}
