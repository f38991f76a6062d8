#include <coapt/base/exceptions.h>
#include <coapt/metrics/leaflet_lines.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    double
    angle_between(const double a, const double b)
    {
      return std::remainder(a - b, 2 * M_PI);
    }

    /** Which columns touch a quadrilateral of the region. */
    std::vector<bool>
    columns_of_region(const Leaflet &leaflet, const Region region)
    {
      std::vector<bool> touches(leaflet.columns.size(), false);
      for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
        if (leaflet.quad_region[q] == region)
          for (const unsigned int column : leaflet.quads[q])
            touches[column] = true;
      return touches;
    }

    /** Place of the free edge that is nearest in angle to a column. */
    unsigned int
    nearest_on_edge(const Leaflet &leaflet, const unsigned int column)
    {
      const auto &edge     = leaflet.free_edge_columns;
      unsigned int nearest = 0;
      double distance      = std::numeric_limits<double>::max();
      for (unsigned int i = 0; i < edge.size(); ++i)
        {
          const double d =
            std::abs(angle_between(leaflet.column_coordinates[column][0],
                                   leaflet.column_coordinates[edge[i]][0]));
          if (d < distance)
            {
              distance = d;
              nearest  = i;
            }
        }
      return nearest;
    }

    LeafletLines::Lines
    lines_of(const Leaflet &leaflet)
    {
      const auto &coordinates = leaflet.column_coordinates;
      LeafletLines::Lines lines(leaflet.free_edge_columns.size());
      for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
        if (coordinates[c][1] >= 0) // not in the root
          lines[nearest_on_edge(leaflet, c)].push_back(c);
      for (auto &line : lines)
        std::sort(line.begin(), line.end(), [&](const auto a, const auto b) {
          return coordinates[a][1] < coordinates[b][1];
        });
      return lines;
    }

    /** The lines that touch a region, by their angle from its @p middle, times
     * @p sense. */
    LeafletLines::Lines
    lines_of_region(const Leaflet &leaflet,
                    const LeafletLines::Lines &lines,
                    const Region region,
                    const double middle,
                    const int sense)
    {
      const auto touches = columns_of_region(leaflet, region);
      const auto angle   = [&](const unsigned int i) {
        return sense *
          angle_between(
                 leaflet.column_coordinates[leaflet.free_edge_columns[i]][0],
                 middle);
      };
      std::vector<unsigned int> numbers;
      for (unsigned int i = 0; i < lines.size(); ++i)
        if (std::any_of(lines[i].begin(), lines[i].end(), [&](const auto c) {
              return touches[c];
            }))
          numbers.push_back(i);
      std::sort(numbers.begin(),
                numbers.end(),
                [&](const auto a, const auto b) {
                  return angle(a) < angle(b);
                });
      LeafletLines::Lines selected;
      for (const unsigned int i : numbers)
        selected.push_back(lines[i]);
      return selected;
    }
  } // namespace



  Point<3>
  middle_of_column(const Leaflet &leaflet, const unsigned int column)
  {
    const auto &nodes = leaflet.columns[column];
    return leaflet.mesh.points[nodes.front()] +
      0.5 *
      (leaflet.mesh.points[nodes.back()] - leaflet.mesh.points[nodes.front()]);
  }



  LeafletLines::LeafletLines(const Leaflet &leaflet)
    : height(leaflet.columns.size(), 0.), depth(leaflet.columns.size(), 0.)
  {
    if (leaflet.free_edge_columns.empty() ||
        leaflet.column_coordinates.size() != leaflet.columns.size() ||
        leaflet.quad_region.size() != leaflet.quads.size())
      throw InputError("Coaptation: the leaflet needs a free edge, coordinates "
                       "of every column and a region of every quadrilateral.");
    all = lines_of(leaflet);
    for (const auto &line : all)
      for (unsigned int i = 1; i < line.size(); ++i)
        {
          const double length = middle_of_column(leaflet, line[i - 1])
                                  .distance(middle_of_column(leaflet, line[i]));
          height[line[i - 1]] += 0.5 * length;
          height[line[i]] += 0.5 * length;
          depth[line[i]] = depth[line[i - 1]] + length;
        }
    anterior = lines_of_region(leaflet, all, Region::anterior, 0.5 * M_PI, -1);
    posterior =
      lines_of_region(leaflet, all, Region::posterior, -0.5 * M_PI, 1);
  }
} // namespace coapt
