#ifndef coapt_metrics_swept_volume_h
#define coapt_metrics_swept_volume_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Rate (m^3/s) at which a surface sweeps volume towards the atrium: the
   * integral of the velocity over the area, which for linear triangles is the
   * sum of area vector times mean velocity of the corners, exactly. Positive
   * towards the atrium; as everywhere, area vectors point to the ventricular
   * side. Flow through the atrial end is this plus what passes through the
   * orifice. @p points in m, @p velocities in m/s.
   */
  double
  swept_rate(const std::vector<dealii::Point<3>> &points,
             const std::vector<dealii::Tensor<1, 3>> &velocities,
             const std::vector<std::array<unsigned int, 3>> &triangles);

  /**
   * Volume (m^3) swept towards the atrium between two configurations if every
   * point moves along a straight line: the integral of swept_rate(), which is
   * quadratic in time, so that Simpson's rule is exact. Free edges may move.
   */
  double
  swept_volume(const std::vector<dealii::Point<3>> &before,
               const std::vector<dealii::Point<3>> &after,
               const std::vector<std::array<unsigned int, 3>> &triangles);
} // namespace coapt

#endif
