#ifndef coapt_geometry_facing_parts_h
#define coapt_geometry_facing_parts_h

#include <deal.II/base/point.h>

#include <vector>

namespace coapt
{
  /**
   * Which points of a surface have another part of it before or behind them:
   * a point within @p distance (m) whose direction is at most 60 degrees from
   * the normal, so that neighbours within a smooth surface do not count.
   * @p x are the points (m), @p normals of any length belong to them.
   */
  std::vector<bool>
  facing_parts(const std::vector<dealii::Point<3>> &x,
               const std::vector<dealii::Tensor<1, 3>> &normals,
               const double distance);
} // namespace coapt

#endif
