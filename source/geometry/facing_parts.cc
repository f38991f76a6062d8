#include <coapt/geometry/facing_parts.h>

#include <deal.II/numerics/rtree.h>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  std::vector<bool>
  facing_parts(const std::vector<Point<3>> &x,
               const std::vector<Tensor<1, 3>> &normals,
               const double distance)
  {
    const auto tree = dealii::pack_rtree(x);
    Tensor<1, 3> reach;
    for (unsigned int d = 0; d < 3; ++d)
      reach[d] = distance;

    std::vector<bool> result(x.size());
    for (unsigned int i = 0; i < x.size(); ++i)
      {
        const double half_length = 0.5 * normals[i].norm();
        const auto faces         = [&](const Point<3> &other) {
          const Tensor<1, 3> way = other - x[i];
          return way.norm() < distance &&
            std::abs(way * normals[i]) > half_length * way.norm();
        };
        namespace bgi = boost::geometry::index;
        const dealii::BoundingBox<3> box({x[i] - reach, x[i] + reach});
        result[i] = tree.qbegin(bgi::intersects(box) &&
                                bgi::satisfies(faces)) != tree.qend();
      }
    return result;
  }
} // namespace coapt
