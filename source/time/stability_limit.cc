#include <coapt/time/stability_limit.h>

#include <cmath>
#include <complex>

namespace coapt
{
  namespace
  {
    bool
    is_stable(const std::complex<double> &z)
    {
      const std::complex<double> R = 1. +
        z * (1. + z * (1. / 2 + z * (1. / 6 + z * (1. / 30 + z * (1. / 150)))));
      return std::abs(R) <= 1 + 1e-9;
    }
  } // namespace



  double
  kinnmark_gray_limit(const double damping_ratio)
  {
    const double xi                      = damping_ratio;
    const std::complex<double> direction = xi < 1
      ? std::complex<double>(-xi, std::sqrt(1 - xi * xi))
      : std::complex<double>(-(xi + std::sqrt(xi * xi - 1)), 0.);
    // The region of stability is not convex: walk out from the origin in
    // small steps until the first unstable point.
    const double step = 1e-3 / std::abs(direction);
    double omega      = 0;
    while (is_stable((omega + step) * direction))
      omega += step;
    return omega;
  }
} // namespace coapt
