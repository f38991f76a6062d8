#include <coapt/geometry/triangle.h>
#include <coapt/metrics/past_edge.h>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  PastEdge::PastEdge(const Leaflet &leaflet)
    : thickness(leaflet.thickness)
    , triangles(triangulate(leaflet.quads))
    , on_edge(leaflet.columns.size(), false)
  {
    for (const unsigned int column : leaflet.free_edge_columns)
      on_edge[column] = true;
  }



  std::vector<bool>
  PastEdge::operator()(const std::vector<Point<3>> &points,
                       const std::vector<unsigned int> &partner) const
  {
    std::vector<bool> result(points.size(), false);
    for (unsigned int column = 0; column < points.size(); ++column)
      {
        if (partner[column] >= triangles.size())
          continue;
        const auto &[a, b, c] = triangles[partner[column]];
        double weights[3];
        const Point<3> closest = closest_point_on_triangle(
          points[column], points[a], points[b], points[c], weights);
        const double inside = (on_edge[a] ? 0 : weights[0]) +
          (on_edge[b] ? 0 : weights[1]) + (on_edge[c] ? 0 : weights[2]);
        if (inside > 0)
          continue;
        const Tensor<1, 3> away = points[column] - closest;
        const Tensor<1, 3> normal =
          cross_product_3d(points[b] - points[a], points[c] - points[a]);
        const double across = away * normal / normal.norm();
        result[column] =
          away.norm_square() - across * across > 0.25 * thickness * thickness;
      }
    return result;
  }
} // namespace coapt
