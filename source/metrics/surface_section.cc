#include <coapt/metrics/surface_section.h>

#include <algorithm>
#include <map>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** An edge of a triangle, the smaller number first. */
    using Edge = std::array<unsigned int, 2>;

    Point<3>
    crossing(const std::vector<Point<3>> &points, const Edge &e, const double x)
    {
      const Point<3> &a = points[e[0]], &b = points[e[1]];
      return a + (x - a[0]) / (b[0] - a[0]) * (b - a);
    }

    /** Edges that meet the plane, each with those that it is linked to. */
    std::map<Edge, std::vector<Edge>>
    linked_edges(const std::vector<Point<3>> &points,
                 const std::vector<std::array<unsigned int, 3>> &triangles,
                 const double x)
    {
      std::map<Edge, std::vector<Edge>> links;
      for (const auto &triangle : triangles)
        {
          std::vector<Edge> crossed;
          for (unsigned int i = 0; i < 3; ++i)
            {
              Edge edge = {{triangle[i], triangle[(i + 1) % 3]}};
              std::sort(edge.begin(), edge.end());
              // A point on the plane counts as beyond it.
              if ((points[edge[0]][0] < x) != (points[edge[1]][0] < x))
                crossed.push_back(edge);
            }
          if (crossed.size() == 2)
            {
              links[crossed[0]].push_back(crossed[1]);
              links[crossed[1]].push_back(crossed[0]);
            }
        }
      return links;
    }
  } // namespace



  std::vector<std::vector<Point<3>>>
  surface_section(const std::vector<Point<3>> &points,
                  const std::vector<std::array<unsigned int, 3>> &triangles,
                  const double x)
  {
    auto links = linked_edges(points, triangles, x);
    std::vector<std::vector<Point<3>>> curves;
    const auto follow = [&](Edge edge) {
      curves.push_back({crossing(points, edge, x)});
      while (!links[edge].empty())
        {
          const Edge next = links[edge].back();
          links[edge].pop_back();
          auto &back = links[next];
          back.erase(std::find(back.begin(), back.end(), edge));
          curves.back().push_back(crossing(points, next, x));
          edge = next;
        }
    };
    std::vector<Edge> ends, others;
    for (const auto &[edge, neighbours] : links)
      (neighbours.size() == 1 ? ends : others).push_back(edge);
    for (const auto &edges : {ends, others}) // open curves from their ends
      for (const Edge &edge : edges)
        if (!links[edge].empty())
          follow(edge);
    return curves;
  }
} // namespace coapt
