#include <coapt/coupled/solid_band.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  using dealii::Point;

  template <int dim>
  SolidBand<dim>::SolidBand(
    const MeshParameters &parameters,
    const std::function<double(const Point<dim> &)> &lumen)
    : parameters(parameters), lumen(lumen)
  {
  }



  template <int dim>
  void
  SolidBand<dim>::place(const std::vector<Point<dim>> &x,
                        const std::vector<Point<dim>> &v,
                        const std::vector<bool> &faces)
  {
    const double time = 2e-3, furthest = 1.5 * parameters.finest_cell();
    placed = ahead = x;
    cell_at.resize(x.size());
    for (unsigned int q = 0; q < x.size(); ++q)
      cell_at[q] = faces.empty() || faces[q]
        ? parameters.finest_cell()
        : parameters.cell_size(parameters.level_apart());
    for (unsigned int q = 0; q < v.size(); ++q)
      {
        const double way = time * v[q].norm();
        if (way > 0)
          ahead[q] += std::min(1., furthest / way) * time * v[q];
      }

    std::vector<Point<dim>> near, far;
    for (unsigned int q = 0; q < x.size(); ++q)
      {
        auto &points = cell_at[q] == parameters.finest_cell() ? near : far;
        points.push_back(x[q]);
        if (ahead[q].distance(x[q]) > 0.1 * parameters.finest_cell())
          points.push_back(ahead[q]);
      }
    facing = dealii::pack_rtree(near);
    apart  = dealii::pack_rtree(far);
  }



  namespace
  {
    /** Whether one of the points is nearer to @p x than @p radius (m). */
    template <int dim>
    bool
    is_one_within(const double radius,
                  const Point<dim> &x,
                  const dealii::RTree<Point<dim>> &points)
    {
      namespace bgi = boost::geometry::index;
      dealii::Tensor<1, dim> reach;
      for (unsigned int d = 0; d < dim; ++d)
        reach[d] = radius;
      const dealii::BoundingBox<dim> box({x - reach, x + reach});
      const auto is_near = [&](const Point<dim> &point) {
        return x.distance(point) < radius;
      };
      return points.qbegin(bgi::intersects(box) && bgi::satisfies(is_near)) !=
        points.qend();
    }
  } // namespace



  template <int dim>
  bool
  SolidBand<dim>::is_near(const Point<dim> &x) const
  {
    const double cells = parameters.band + 1;
    return is_one_within(cells * parameters.finest_cell(), x, facing) ||
      is_one_within(cells * parameters.cell_size(parameters.level_apart()),
                    x,
                    apart);
  }



  template <int dim>
  bool
  SolidBand<dim>::is_in_band(const Point<dim> &center,
                             const double size,
                             const Tree &tree,
                             const unsigned int level) const
  {
    const double cell   = parameters.cell_size(level);
    const double margin = 0.5 * std::sqrt(double(dim)) * (size - cell);
    return is_one_within(parameters.band * cell + std::max(0., margin),
                         center,
                         tree);
  }



  template <int dim>
  unsigned int
  SolidBand<dim>::wanted_level(const Point<dim> &center,
                               const double size) const
  {
    const double half_diagonal = 0.5 * std::sqrt(double(dim)) * size;
    // All its nodes are held, also where the root of the solid lies in it.
    const double to_wall =
      lumen ? lumen(center) : -std::numeric_limits<double>::max();
    if (to_wall > half_diagonal)
      return 0;
    if (is_in_band(center, size, facing, parameters.leaflet_level))
      return parameters.leaflet_level;
    if (is_in_band(center, size, apart, parameters.level_apart()))
      return parameters.level_apart();
    return to_wall > -half_diagonal
      ? std::max(parameters.wall_level, parameters.lumen_level)
      : parameters.lumen_level;
  }



  template <int dim>
  bool
  SolidBand<dim>::is_used_up(const std::vector<Point<dim>> &x) const
  {
    // What remains is the half diagonal of the cell that a point lies in, and
    // half a cell.
    const double cells = parameters.band - 0.5 - 0.5 * std::sqrt(double(dim));
    for (unsigned int q = 0; q < x.size(); ++q)
      {
        // The nearest point on the way.
        const dealii::Tensor<1, dim> way = ahead[q] - placed[q];
        const double part =
          way * (x[q] - placed[q]) / std::max(way.norm_square(), 1e-30);
        if (x[q].distance(placed[q] + std::clamp(part, 0., 1.) * way) >
            cells * cell_at[q])
          return true;
      }
    return false;
  }



  template class SolidBand<2>;
  template class SolidBand<3>;
} // namespace coapt
