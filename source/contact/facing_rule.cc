#include <coapt/contact/facing_rule.h>
#include <coapt/geometry/triangle.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;

  FacingRule::FacingRule(
    const std::vector<std::array<unsigned int, 3>> &triangles,
    const unsigned int n_columns)
    : triangles(triangles), around(n_columns)
  {
    for (unsigned int t = 0; t < triangles.size(); ++t)
      for (const unsigned int column : triangles[t])
        around[column].push_back(t);
  }



  Encounter
  FacingRule::encounter(const std::vector<Point<3>> &points,
                        const unsigned int column,
                        const unsigned int triangle) const
  {
    Encounter result;
    const auto &corner     = triangles[triangle];
    const Point<3> &p      = points[column];
    const Point<3> closest = closest_point_on_triangle(p,
                                                       points[corner[0]],
                                                       points[corner[1]],
                                                       points[corner[2]],
                                                       result.weights.data());
    result.triangle        = triangle;
    result.distance        = p.distance(closest);
    if (result.distance > 0)
      result.normal = (closest - p) / result.distance;
    return result;
  }



  // The distance is convex on each triangle, and the connection is
  // perpendicular to the edge or triangle in which the point lies: the point
  // is a minimum if the way to no other corner of the triangles that share it
  // begins towards the column.
  bool
  FacingRule::faces(const std::vector<Point<3>> &points,
                    const unsigned int column,
                    const Encounter &found) const
  {
    const auto &corner = triangles[found.triangle];
    std::array<unsigned int, 3> support{};
    unsigned int n = 0;
    for (unsigned int v = 0; v < 3; ++v)
      if (found.weights[v] > 0)
        support[n++] = corner[v];
    if (n == 3)
      return true;

    const double round_off = 1e-6; // radian
    const Point<3> closest = points[column] + found.distance * found.normal;
    for (const unsigned int other : around[support[0]])
      {
        const auto &corners = triangles[other];
        if (n == 2 &&
            std::find(corners.begin(), corners.end(), support[1]) ==
              corners.end())
          continue;
        for (const unsigned int end : corners)
          {
            if (end == support[0] || (n == 2 && end == support[1]))
              continue;
            const auto way       = points[end] - closest;
            const double descent = -(found.normal * way);
            if (descent > 0 &&
                descent * descent > round_off * round_off * way.norm_square())
              return false;
          }
      }
    return true;
  }
} // namespace coapt
