#include <deal.II/numerics/rtree.h>

#include <coapt/metrics/contact_history.h>

#include <cmath>
#include <limits>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  ContactHistory::ContactHistory(const unsigned int n_columns,
                                 const double clearance,
                                 const double thickness)
    : clearance(clearance)
    , thickness(thickness)
    , first(n_columns, std::numeric_limits<double>::quiet_NaN())
    , slip(n_columns, 0.)
  {
  }



  void
  ContactHistory::update(const double time, const ColumnMotion &motion)
  {
    std::vector<unsigned int> touching;
    for (unsigned int c = 0; c < motion.gap.size(); ++c)
      if (motion.gap[c] <= clearance && motion.normals[c].norm_square() > 0)
        touching.push_back(c);
    const double dt = time - last_time;
    last_time       = time;
    if (touching.empty())
      return;

    std::vector<std::pair<Point<3>, unsigned int>> columns;
    for (unsigned int c = 0; c < motion.points.size(); ++c)
      columns.emplace_back(motion.points[c], c);
    const auto tree = dealii::pack_rtree(columns);
    for (const unsigned int c : touching)
      {
        if (std::isnan(first[c]))
          first[c] = time;
        const Tensor<1, 3> &n     = motion.normals[c];
        const Tensor<1, 3> across = (motion.gap[c] + thickness) * n;
        std::vector<std::pair<Point<3>, unsigned int>> nearest;
        tree.query(boost::geometry::index::nearest(motion.points[c] + across,
                                                   1),
                   std::back_inserter(nearest));
        const Point<3> half_way     = motion.points[c] + 0.5 * across;
        const auto velocity_of_side = [&](const unsigned int column) {
          return motion.velocities[column] +
            cross_product_3d(motion.spins[column],
                             half_way - motion.points[column]);
        };
        const Tensor<1, 3> relative =
          velocity_of_side(c) - velocity_of_side(nearest[0].second);
        slip[c] += dt * (relative - (relative * n) * n).norm();
      }
  }
} // namespace coapt
