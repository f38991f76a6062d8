#ifndef coapt_time_stability_limit_h
#define coapt_time_stability_limit_h

namespace coapt
{
  /**
   * Largest omega dt for which the Kinnmark-Gray 5(3) method (Kinnmark and
   * Gray 1984) is stable for y'' + 2 xi omega y' + omega^2 y = 0, that is,
   * |R(z)| <= 1 at z = omega dt (-xi + i sqrt(1 - xi^2)), with
   * R(z) = 1 + z + z^2/2 + z^3/6 + z^4/30 + z^5/150. It is sqrt(15) = 3.873 for
   * xi = 0 and falls to 3.05 / (xi + sqrt(xi^2 - 1)) when overdamped.
   */
  double
  kinnmark_gray_limit(const double damping_ratio);
} // namespace coapt

#endif
