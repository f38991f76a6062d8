#include <coapt/base/exceptions.h>
#include <coapt/metrics/coaptation.h>

#include <algorithm>
#include <cmath>
#include <deque>
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

    Point<3>
    middle_of_column(const Leaflet &leaflet, const unsigned int column)
    {
      const auto &nodes = leaflet.columns[column];
      return leaflet.mesh.points[nodes.front()] +
        0.5 *
        (leaflet.mesh.points[nodes.back()] -
         leaflet.mesh.points[nodes.front()]);
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
  } // namespace



  Coaptation::Coaptation(const Leaflet &leaflet,
                         const CoaptationSettings &settings)
    : settings(settings)
  {
    if (leaflet.free_edge_columns.empty() ||
        leaflet.column_coordinates.size() != leaflet.columns.size() ||
        leaflet.quad_region.size() != leaflet.quads.size())
      throw InputError("Coaptation: the leaflet needs a free edge, coordinates "
                       "of every column and a region of every quadrilateral.");
    set_up_neighbourhoods(leaflet);
    set_up_lines(leaflet);
  }



  void
  Coaptation::set_up_neighbourhoods(const Leaflet &leaflet)
  {
    const unsigned int n = leaflet.columns.size();
    std::vector<Point<3>> points(n);
    for (unsigned int c = 0; c < n; ++c)
      points[c] = middle_of_column(leaflet, c);

    const double square = settings.filter_radius * settings.filter_radius;
    neighbourhood.resize(n);
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int other = 0; other < n; ++other)
        if (other == c || points[c].distance_square(points[other]) <= square)
          neighbourhood[c].push_back(other);

    adjacent.resize(n);
    for (const auto &quad : leaflet.quads)
      for (const unsigned int a : quad)
        for (const unsigned int b : quad)
          if (a != b)
            adjacent[a].push_back(b);
  }



  void
  Coaptation::set_up_lines(const Leaflet &leaflet)
  {
    const auto &edge        = leaflet.free_edge_columns;
    const auto &coordinates = leaflet.column_coordinates;
    Lines lines(edge.size());
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      if (coordinates[c][1] >= 0) // not in the root
        {
          unsigned int nearest = 0;
          double distance      = std::numeric_limits<double>::max();
          for (unsigned int i = 0; i < edge.size(); ++i)
            {
              const double d = std::abs(
                angle_between(coordinates[c][0], coordinates[edge[i]][0]));
              if (d < distance)
                {
                  distance = d;
                  nearest  = i;
                }
            }
          lines[nearest].push_back(c);
        }
    for (auto &line : lines)
      std::sort(line.begin(), line.end(), [&](const auto a, const auto b) {
        return coordinates[a][1] < coordinates[b][1];
      });
    set_up_heights(leaflet, lines);

    const auto select = [&](const Region region, const double middle) {
      const auto touches = columns_of_region(leaflet, region);
      std::vector<unsigned int> numbers;
      for (unsigned int i = 0; i < lines.size(); ++i)
        if (std::any_of(lines[i].begin(), lines[i].end(), [&](const auto c) {
              return touches[c];
            }))
          numbers.push_back(i);
      std::sort(numbers.begin(),
                numbers.end(),
                [&](const auto a, const auto b) {
                  return angle_between(coordinates[edge[a]][0], middle) <
                    angle_between(coordinates[edge[b]][0], middle);
                });
      Lines selected;
      for (const unsigned int i : numbers)
        selected.push_back(lines[i]);
      return selected;
    };
    anterior_lines  = select(Region::anterior, 0.5 * M_PI);
    posterior_lines = select(Region::posterior, -0.5 * M_PI);
  }



  void
  Coaptation::set_up_heights(const Leaflet &leaflet, const Lines &all_lines)
  {
    height.assign(leaflet.columns.size(), 0.);
    for (const auto &line : all_lines)
      for (unsigned int i = 1; i < line.size(); ++i)
        {
          const double half = 0.5 *
            middle_of_column(leaflet, line[i - 1])
              .distance(middle_of_column(leaflet, line[i]));
          height[line[i - 1]] += half;
          height[line[i]] += half;
        }
  }



  std::vector<double>
  Coaptation::average(const std::vector<double> &values,
                      const std::vector<double> &area) const
  {
    std::vector<double> result(values.size(), 0.);
    for (unsigned int c = 0; c < values.size(); ++c)
      {
        double sum = 0, weight = 0;
        for (const unsigned int other : neighbourhood[c])
          {
            sum += area[other] * values[other];
            weight += area[other];
          }
        result[c] = weight > 0 ? sum / weight : values[c];
      }
    return result;
  }



  // The cheapest way from the first line to the last one, where a column that
  // does not coapt costs one (breadth-first search with costs 0 and 1).
  unsigned int
  Coaptation::missing_columns(const Lines &lines,
                              const std::vector<bool> &coapts) const
  {
    const unsigned int unreached = std::numeric_limits<int>::max();
    std::vector<unsigned int> cost(coapts.size(), unreached);
    std::vector<bool> belongs(coapts.size(), false);
    for (const auto &line : lines)
      for (const unsigned int column : line)
        belongs[column] = true;

    std::deque<unsigned int> queue;
    const auto reach = [&](const unsigned int column, const unsigned int from) {
      const unsigned int total = from + (coapts[column] ? 0 : 1);
      if (!belongs[column] || total >= cost[column])
        return;
      cost[column] = total;
      if (coapts[column])
        queue.push_front(column);
      else
        queue.push_back(column);
    };
    for (const unsigned int column : lines.front())
      reach(column, 0);
    while (!queue.empty())
      {
        const unsigned int column = queue.front();
        queue.pop_front();
        for (const unsigned int other : adjacent[column])
          reach(other, cost[column]);
      }
    unsigned int least = unreached;
    for (const unsigned int column : lines.back())
      least = std::min(least, cost[column]);
    return least;
  }



  LeafletCoaptation
  Coaptation::belt(const Lines &lines, const std::vector<bool> &coapts) const
  {
    LeafletCoaptation result;
    if (lines.empty())
      return result;
    unsigned int gap = 0;
    for (const auto &line : lines)
      {
        double line_height = 0;
        bool touches       = false;
        for (const unsigned int column : line)
          if (coapts[column])
            {
              touches = true;
              line_height += height[column];
            }
        gap                = touches ? 0 : gap + 1;
        result.longest_gap = std::max(result.longest_gap, gap);
        result.mean_height += line_height / lines.size();
        result.max_height = std::max(result.max_height, line_height);
      }
    result.missing_columns = missing_columns(lines, coapts);
    result.continuous      = result.missing_columns == 0;
    return result;
  }



  CoaptationResult
  Coaptation::evaluate(const std::vector<double> &gap,
                       const std::vector<double> &contact_pressure,
                       const std::vector<double> &total_traction,
                       const std::vector<double> &area) const
  {
    const std::vector<double> contact  = average(contact_pressure, area);
    const std::vector<double> traction = average(total_traction, area);
    std::vector<bool> coapts(gap.size());
    CoaptationResult result;
    for (unsigned int c = 0; c < gap.size(); ++c)
      {
        coapts[c] = gap[c] <= settings.gap_limit &&
          traction[c] >= settings.least_traction;
        if (!coapts[c])
          continue;
        result.area += 0.5 * area[c];
        result.force += 0.5 * area[c] * total_traction[c];
        result.contact_force += 0.5 * area[c] * contact_pressure[c];
        result.max_traction = std::max(result.max_traction, traction[c]);
        result.max_contact_pressure =
          std::max(result.max_contact_pressure, contact[c]);
      }
    if (result.force > 0)
      result.contact_fraction = result.contact_force / result.force;
    result.anterior  = belt(anterior_lines, coapts);
    result.posterior = belt(posterior_lines, coapts);
    result.continuous =
      result.anterior.continuous && result.posterior.continuous;
    result.longest_gap =
      std::max(result.anterior.longest_gap, result.posterior.longest_gap);
    return result;
  }
} // namespace coapt
