#ifndef coapt_coupled_displacement_history_h
#define coapt_coupled_displacement_history_h

#include <deal.II/base/tensor.h>

// Boost 1.74 calls isnan without a namespace.
#include <math.h>

#include <boost/math/interpolators/pchip.hpp>

#include <vector>

namespace coapt
{
  /**
   * A displacement over time. Between the given times each component is a
   * monotone cubic (Fritsch and Butland 1984), which has a continuous
   * derivative and does not overshoot; before the first and after the last
   * time it is held, and the velocity goes to zero there.
   */
  class DisplacementHistory
  {
  public:
    /** Displacements (m) at increasing @p times (s), at least one. */
    DisplacementHistory(const std::vector<double> &times,
                        const std::vector<dealii::Tensor<1, 3>> &displacements);

    /** Displacement (m) at time @p t (s). */
    dealii::Tensor<1, 3>
    displacement(const double t) const;

    /** Its derivative (m/s). */
    dealii::Tensor<1, 3>
    velocity(const double t) const;

  private:
    double first, last;
    std::vector<boost::math::interpolators::pchip<std::vector<double>>>
      components;
  };
} // namespace coapt

#endif
