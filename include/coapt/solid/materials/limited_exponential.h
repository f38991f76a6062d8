#ifndef coapt_solid_materials_limited_exponential_h
#define coapt_solid_materials_limited_exponential_h

#include <coapt/solid/batch.h>

namespace coapt
{
  /**
   * exp(Q) - 1 with its derivatives, continued by a parabola beyond a limit of
   * Q, lest a brief overshoot demand an absurdly small time step.
   */
  template <typename Number>
  struct LimitedExponential
  {
    LimitedExponential(const Number &Q, const double limit)
    {
      const Number bounded = at_most(Q, limit);
      const Number excess  = Q - bounded;
      second               = exponential(bounded);
      first                = second * (1. + excess);
      value                = second * (1. + excess * (1. + 0.5 * excess)) - 1.;
    }

    Number value, first, second;
  };
} // namespace coapt

#endif
