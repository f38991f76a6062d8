#ifndef coapt_tests_metrics_linear_flow_h
#define coapt_tests_metrics_linear_flow_h

#include "fluid/fluid_case.h"

/** A box with edges of 4 m and cells of 0.5 m and 1 m, in which fluid flows
 * with the velocity linear_flow(). */
struct LinearFlow : FluidCase<3>
{
  LinearFlow() : FluidCase<3>({}, {}, Point(), Point(4, 4, 4), {{4, 4, 4}})
  {
    set_up([](const Point &x, const double) { return x[0] < 2 ? 1 : 0; });
    set_velocity(linear_flow, false);
  }

  static double
  linear_flow(const Point &x, const int component)
  {
    return component == 2 ? 1 + 0.5 * x[0] - 0.25 * x[1] : 0.3 * component;
  }

  std::vector<double>
  local_velocity() const
  {
    std::vector<double> velocity(3 * op.n_local_nodes());
    op.gather(u.data(), velocity.data());
    return velocity;
  }
};

#endif
