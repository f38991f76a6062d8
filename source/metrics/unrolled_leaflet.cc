#include <coapt/metrics/unrolled_leaflet.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    double
    mean_annulus_radius(const Leaflet &leaflet)
    {
      double radius = 0;
      for (const unsigned int column : leaflet.annulus_columns)
        {
          const Point<3> x = middle_of_column(leaflet, column);
          radius += std::hypot(x[0], x[1]) / leaflet.annulus_columns.size();
        }
      return radius;
    }
  } // namespace



  UnrolledLeaflet::UnrolledLeaflet(const Leaflet &leaflet,
                                   const LeafletLines &lines)
  {
    const double radius = mean_annulus_radius(leaflet);
    // from mid-anterior, growing to the right
    const auto angle = [&](const unsigned int column) {
      return std::remainder(M_PI / 2 - leaflet.column_coordinates[column][0],
                            2 * M_PI);
    };
    std::map<std::pair<unsigned int, int>, unsigned int> numbers;
    const auto point = [&](const unsigned int column, const int turns) {
      const auto [it, is_new] =
        numbers.insert({{column, turns}, unsigned(points.size())});
      if (is_new)
        {
          points.emplace_back(radius * (angle(column) + 2 * M_PI * turns),
                              0. - lines.depth[column],
                              0.);
          columns.push_back(column);
        }
      return it->second;
    };

    for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
      {
        const auto &quad = leaflet.quads[q];
        if (leaflet.quad_region[q] == Region::root)
          continue;
        // On the cut, corners on the left follow those on the right.
        double least = angle(quad[0]), largest = least;
        for (const unsigned int column : quad)
          {
            least   = std::min(least, angle(column));
            largest = std::max(largest, angle(column));
          }
        std::array<unsigned int, 4> corners;
        for (unsigned int i = 0; i < 4; ++i)
          corners[i] =
            point(quad[i],
                  largest - least > M_PI && angle(quad[i]) < 0 ? 1 : 0);
        triangles.push_back({{corners[0], corners[1], corners[2]}});
        triangles.push_back({{corners[0], corners[2], corners[3]}});
        quads.insert(quads.end(), 2, q);
      }
  }



  std::vector<double>
  UnrolledLeaflet::on_points(const std::vector<double> &of_columns) const
  {
    std::vector<double> result;
    for (const unsigned int column : columns)
      result.push_back(of_columns[column]);
    return result;
  }
} // namespace coapt
