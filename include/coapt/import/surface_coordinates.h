#ifndef coapt_import_surface_coordinates_h
#define coapt_import_surface_coordinates_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /** Length of the shortest way along the edges of @p quads from any of
   * @p sources to each of the @p points (m). */
  std::vector<double>
  distances_along_surface(const std::vector<dealii::Point<3>> &points,
                          const std::vector<std::array<unsigned int, 4>> &quads,
                          const std::vector<unsigned int> &sources);
} // namespace coapt

#endif
