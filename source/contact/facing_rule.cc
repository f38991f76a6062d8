#include <coapt/contact/facing_rule.h>
#include <coapt/geometry/triangle.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;

  FacingRule::FacingRule(
    const std::vector<std::array<unsigned int, 3>> &triangles,
    const unsigned int n_columns)
    : triangles(triangles), around(n_columns), is_free(n_columns)
  {
    for (unsigned int t = 0; t < triangles.size(); ++t)
      for (const unsigned int column : triangles[t])
        around[column].push_back(t);

    // At a free edge there is one triangle less than neighbours.
    for (unsigned int column = 0; column < n_columns; ++column)
      {
        std::vector<unsigned int> ends;
        for (const unsigned int t : around[column])
          for (const unsigned int end : triangles[t])
            if (end != column)
              ends.push_back(end);
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        is_free[column] = ends.size() != around[column].size();
      }
  }



  Encounter
  FacingRule::encounter(const std::vector<Point<3>> &points,
                        const unsigned int column,
                        const unsigned int triangle) const
  {
    return encounter(points, points[column], triangle);
  }



  Encounter
  FacingRule::encounter(const std::vector<Point<3>> &points,
                        const Point<3> &p,
                        const unsigned int triangle) const
  {
    Encounter result;
    const auto &corner     = triangles[triangle];
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



  FacingRule::Support
  FacingRule::support(const Encounter &found) const
  {
    Support result;
    for (unsigned int v = 0; v < 3; ++v)
      if (found.weights[v] > 0)
        result.columns[result.n++] = triangles[found.triangle][v];
    return result;
  }



  bool
  FacingRule::contains(const unsigned int triangle,
                       const Support &support) const
  {
    const auto &corner = triangles[triangle];
    for (unsigned int i = 0; i < support.n; ++i)
      if (std::find(corner.begin(), corner.end(), support.columns[i]) ==
          corner.end())
        return false;
    return true;
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
    const Support shared = support(found);
    if (shared.n == 3)
      return true;

    const double round_off = 1e-6; // radian
    const Point<3> closest = points[column] + found.distance * found.normal;
    for (const unsigned int other : around[shared.columns[0]])
      if (contains(other, shared))
        for (const unsigned int end : triangles[other])
          {
            if (end == shared.columns[0] ||
                (shared.n == 2 && end == shared.columns[1]))
              continue;
            const auto way       = points[end] - closest;
            const double descent = -(found.normal * way);
            if (descent > 0 &&
                descent * descent > round_off * round_off * way.norm_square())
              return false;
          }
    return true;
  }



  // The distance falls with each triangle, so this ends.
  double
  FacingRule::descend(const std::vector<Point<3>> &points,
                      const Point<3> &p,
                      const std::vector<bool> &is_neighbour,
                      Encounter &found) const
  {
    found = encounter(points, p, found.triangle);
    for (bool falls = true; falls;)
      {
        falls                = false;
        const Support shared = support(found);
        if (shared.n == 3)
          break; // inside
        for (const unsigned int other : around[shared.columns[0]])
          if (contains(other, shared))
            {
              const Encounter there = encounter(points, p, other);
              // but for round-off where triangles meet
              if (there.distance < (1 - 1e-9) * found.distance)
                {
                  found = there;
                  falls = true;
                }
            }
      }
    return share(points, found, is_neighbour);
  }



  // The same whichever of the triangles that share the point has been found.
  double
  FacingRule::share(const std::vector<Point<3>> &points,
                    const Encounter &found,
                    const std::vector<bool> &is_neighbour) const
  {
    const Support shared  = support(found);
    unsigned int n        = 0;
    double largest_cosine = 0;
    for (const unsigned int triangle : around[shared.columns[0]])
      if (contains(triangle, shared))
        {
          if (is_neighbour[triangle])
            return 0;
          ++n;
          const auto &corner = triangles[triangle];
          const auto normal =
            cross_product_3d(points[corner[1]] - points[corner[0]],
                             points[corner[2]] - points[corner[0]]);
          if (normal.norm_square() > 0)
            largest_cosine =
              std::max(largest_cosine,
                       std::abs(found.normal * normal) / normal.norm());
        }
    const bool inside = shared.n == 3 || (shared.n == 2 && n == 2) ||
      (shared.n == 1 && !is_free[shared.columns[0]]);
    return inside ? 1. : std::min(1., std::max(0., 2 - largest_cosine / 0.2));
  }



  unsigned int
  FacingRule::first_sharing(const Encounter &found) const
  {
    const Support shared = support(found);
    for (const unsigned int triangle : around[shared.columns[0]])
      if (contains(triangle, shared))
        return triangle;
    return found.triangle;
  }



  const std::array<unsigned int, 3> &
  FacingRule::corners(const unsigned int triangle) const
  {
    return triangles[triangle];
  }
} // namespace coapt
