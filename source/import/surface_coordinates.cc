#include <coapt/import/surface_coordinates.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

namespace coapt
{
  std::vector<double>
  distances_along_surface(const std::vector<dealii::Point<3>> &points,
                          const std::vector<std::array<unsigned int, 4>> &quads,
                          const std::vector<unsigned int> &sources)
  {
    using Graph =
      boost::adjacency_list<boost::vecS,
                            boost::vecS,
                            boost::undirectedS,
                            boost::no_property,
                            boost::property<boost::edge_weight_t, double>>;
    // One vertex more, from which the way to all sources is free.
    Graph graph(points.size() + 1);
    for (const auto &quad : quads)
      for (unsigned int c = 0; c < 4; ++c)
        {
          const unsigned int a = quad[c], b = quad[(c + 1) % 4];
          boost::add_edge(a, b, points[a].distance(points[b]), graph);
        }
    for (const unsigned int source : sources)
      boost::add_edge(points.size(), source, 0., graph);

    std::vector<double> distances(points.size() + 1);
    boost::dijkstra_shortest_paths(
      graph,
      points.size(),
      boost::distance_map(boost::make_iterator_property_map(
        distances.begin(), boost::get(boost::vertex_index, graph))));
    distances.pop_back();
    return distances;
  }
} // namespace coapt
