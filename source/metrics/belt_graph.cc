#include <coapt/metrics/belt_graph.h>

#include <algorithm>
#include <limits>
#include <set>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** Distance of each line from the first one along the free edge (m), by
     * column; zero for columns in none of the lines. */
    std::vector<double>
    positions_on_edge(const LeafletLines::Lines &lines,
                      const std::vector<Point<3>> &points)
    {
      std::vector<double> position(points.size(), 0.);
      double length = 0;
      for (unsigned int i = 0; i < lines.size(); ++i)
        {
          if (i > 0)
            length +=
              points[lines[i - 1].back()].distance(points[lines[i].back()]);
          for (const unsigned int column : lines[i])
            position[column] = length;
        }
      return position;
    }
  } // namespace



  BeltGraph::BeltGraph(const Leaflet &leaflet)
    : adjacent(leaflet.columns.size())
  {
    for (const auto &quad : leaflet.quads)
      for (const unsigned int a : quad)
        for (const unsigned int b : quad)
          if (a != b)
            adjacent[a].push_back(b);
  }



  std::vector<unsigned int>
  BeltGraph::way(const LeafletLines::Lines &lines,
                 const std::vector<bool> &coapts,
                 const std::vector<Point<3>> &points) const
  {
    if (lines.empty())
      return {};
    // Fewest columns that do not coapt, then least length.
    using Cost              = std::pair<unsigned int, double>;
    const unsigned int none = std::numeric_limits<unsigned int>::max();
    std::vector<Cost> cost(coapts.size(), {none, 0.});
    std::vector<unsigned int> before(coapts.size(), none);
    std::vector<bool> belongs(coapts.size(), false);
    for (const auto &line : lines)
      for (const unsigned int column : line)
        belongs[column] = true;

    std::set<std::pair<Cost, unsigned int>> queue;
    const auto reach = [&](const unsigned int column,
                           const unsigned int from,
                           const Cost &so_far,
                           const double distance) {
      const Cost total = {so_far.first + (coapts[column] ? 0 : 1),
                          so_far.second + distance};
      if (!belongs[column] || total >= cost[column])
        return;
      queue.erase({cost[column], column});
      cost[column]   = total;
      before[column] = from;
      queue.insert({total, column});
    };
    for (const unsigned int column : lines.front())
      reach(column, none, {0, 0.}, 0.);
    while (!queue.empty())
      {
        const unsigned int column = queue.begin()->second;
        queue.erase(queue.begin());
        for (const unsigned int other : adjacent[column])
          reach(other,
                column,
                cost[column],
                points[column].distance(points[other]));
      }

    unsigned int end = lines.back().front();
    for (const unsigned int column : lines.back())
      if (cost[column] < cost[end])
        end = column;
    std::vector<unsigned int> result;
    if (cost[end].first < none)
      for (; end != none; end = before[end])
        result.push_back(end);
    std::reverse(result.begin(), result.end());
    return result;
  }



  std::vector<BeltGap>
  BeltGraph::gaps(const LeafletLines::Lines &lines,
                  const std::vector<bool> &coapts,
                  const std::vector<Point<3>> &points) const
  {
    const std::vector<unsigned int> columns = way(lines, coapts, points);
    const std::vector<double> position      = positions_on_edge(lines, points);
    std::vector<BeltGap> result;
    for (unsigned int i = 0; i < columns.size(); ++i)
      {
        if (coapts[columns[i]])
          continue;
        // from the column before the gap to the one behind it
        const unsigned int begin = i;
        while (i < columns.size() && !coapts[columns[i]])
          ++i;
        const unsigned int last = std::min<unsigned int>(i, columns.size() - 1);
        BeltGap gap;
        gap.columns = i - begin;
        for (unsigned int k = begin > 0 ? begin : 1; k <= last; ++k)
          gap.length += points[columns[k - 1]].distance(points[columns[k]]);
        const unsigned int middle = columns[(begin + i - 1) / 2];
        gap.position              = position[middle];
        gap.place                 = points[middle];
        result.push_back(gap);
      }
    return result;
  }
} // namespace coapt
