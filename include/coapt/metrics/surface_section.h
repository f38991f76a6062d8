#ifndef coapt_metrics_surface_section_h
#define coapt_metrics_surface_section_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * The curves in which a surface meets the plane x = @p x (m), as lines from
   * point to point; pieces that share an edge of a triangle follow each other.
   * A curve that is closed ends where it begins.
   */
  std::vector<std::vector<dealii::Point<3>>>
  surface_section(const std::vector<dealii::Point<3>> &points,
                  const std::vector<std::array<unsigned int, 3>> &triangles,
                  const double x);
} // namespace coapt

#endif
