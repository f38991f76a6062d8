#include <coapt/geometry/outline.h>

#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/algorithms/within.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <algorithm>
#include <cmath>

namespace coapt
{
  namespace
  {
    const double spacing = 1e-4;
  }



  Outline::Outline(const std::vector<dealii::Point<3>> &corners)
  {
    using Point2D = boost::geometry::model::d2::point_xy<double>;
    boost::geometry::model::polygon<Point2D> polygon;
    for (const auto &x : corners)
      polygon.outer().emplace_back(x[0], x[1]);
    boost::geometry::correct(polygon);

    for (unsigned int d = 0; d < 2; ++d)
      {
        const auto [least, largest] =
          std::minmax_element(corners.begin(),
                              corners.end(),
                              [d](const auto &p, const auto &q) {
                                return p[d] < q[d];
                              });
        lower[d] = (*least)[d];
        n[d]     = std::ceil(((*largest)[d] - lower[d]) / spacing);
      }
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        is_inside.push_back(
          boost::geometry::within(Point2D(lower[0] + (i + 0.5) * spacing,
                                          lower[1] + (j + 0.5) * spacing),
                                  polygon));
  }



  bool
  Outline::inside(const dealii::Point<3> &x) const
  {
    const double i = (x[0] - lower[0]) / spacing,
                 j = (x[1] - lower[1]) / spacing;
    return i >= 0 && i < n[0] && j >= 0 && j < n[1] &&
      is_inside[static_cast<unsigned int>(j) * n[0] +
                static_cast<unsigned int>(i)];
  }
} // namespace coapt
