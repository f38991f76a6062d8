#ifndef coapt_geometry_outline_h
#define coapt_geometry_outline_h

#include <deal.II/base/point.h>

#include <vector>

namespace coapt
{
  /**
   * What a closed line encloses when it is seen along z, on a raster of
   * 0.1 mm: asked for millions of points, a polygon would be too slow.
   */
  class Outline
  {
  public:
    /** @p corners of the line (m) in their order, at least three. */
    explicit Outline(const std::vector<dealii::Point<3>> &corners);

    /** Whether @p x lies inside; does not depend on z. */
    bool
    inside(const dealii::Point<3> &x) const;

  private:
    double lower[2];
    unsigned int n[2];
    std::vector<bool> is_inside;
  };
} // namespace coapt

#endif
