#include <coapt/metrics/swept_volume.h>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  double
  swept_rate(const std::vector<Point<3>> &points,
             const std::vector<Tensor<1, 3>> &velocities,
             const std::vector<std::array<unsigned int, 3>> &triangles)
  {
    double rate = 0;
    for (const auto &[a, b, c] : triangles)
      rate -= 0.5 *
        cross_product_3d(points[b] - points[a], points[c] - points[a]) *
        (velocities[a] + velocities[b] + velocities[c]) / 3.;
    return rate;
  }



  double
  swept_volume(const std::vector<Point<3>> &before,
               const std::vector<Point<3>> &after,
               const std::vector<std::array<unsigned int, 3>> &triangles)
  {
    std::vector<Tensor<1, 3>> displacement(before.size());
    std::vector<Point<3>> middle(before.size());
    for (unsigned int i = 0; i < before.size(); ++i)
      {
        displacement[i] = after[i] - before[i];
        middle[i]       = before[i] + 0.5 * displacement[i];
      }
    return (swept_rate(before, displacement, triangles) +
            4 * swept_rate(middle, displacement, triangles) +
            swept_rate(after, displacement, triangles)) /
      6;
  }
} // namespace coapt
