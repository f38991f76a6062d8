#include <coapt/metrics/fold_crest.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  std::vector<double>
  gaps_with_fold_crests(const std::vector<double> &gap,
                        const std::vector<Tensor<1, 3>> &normals,
                        const std::vector<Point<3>> &points,
                        const double thickness,
                        const double limit)
  {
    const double reach = (thickness + limit) * (thickness + limit);
    const auto near    = [&](const unsigned int a, const unsigned int b) {
      return points[a].distance_square(points[b]) <= reach;
    };
    std::vector<unsigned int> sides;
    for (unsigned int c = 0; c < gap.size(); ++c)
      if (gap[c] <= limit)
        sides.push_back(c);

    std::vector<double> result = gap;
    std::vector<unsigned int> around;
    for (unsigned int c = 0; c < gap.size(); ++c)
      {
        if (gap[c] <= limit)
          continue;
        around.clear();
        for (const unsigned int side : sides)
          if (near(c, side))
            around.push_back(side);
        for (const unsigned int a : around)
          for (const unsigned int b : around)
            if (normals[a] * normals[b] < -0.5 && near(a, b))
              result[c] = std::min(result[c], std::max(gap[a], gap[b]));
      }
    return result;
  }
} // namespace coapt
