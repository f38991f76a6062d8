#include <coapt/coupled/solid_band.h>

#include <algorithm>
#include <cmath>

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
                        const std::vector<Point<dim>> &v)
  {
    const double time = 2e-3, furthest = 1.5 * parameters.finest_cell();
    placed = ahead = x;
    for (unsigned int q = 0; q < v.size(); ++q)
      {
        const double way = time * v[q].norm();
        if (way > 0)
          ahead[q] += std::min(1., furthest / way) * time * v[q];
      }

    std::vector<Point<dim>> all = x;
    for (unsigned int q = 0; q < v.size(); ++q)
      if (ahead[q].distance(x[q]) > 0.1 * parameters.finest_cell())
        all.push_back(ahead[q]);
    tree = dealii::pack_rtree(all);
  }



  template <int dim>
  double
  SolidBand<dim>::distance(const Point<dim> &x) const
  {
    std::vector<Point<dim>> nearest;
    tree.query(boost::geometry::index::nearest(x, 1),
               std::back_inserter(nearest));
    return x.distance(nearest[0]);
  }



  template <int dim>
  bool
  SolidBand<dim>::is_near(const Point<dim> &x) const
  {
    return !placed.empty() &&
      distance(x) < (parameters.band + 1) * parameters.finest_cell();
  }



  template <int dim>
  unsigned int
  SolidBand<dim>::wanted_level(const Point<dim> &center,
                               const double size) const
  {
    const double half_diagonal = 0.5 * std::sqrt(double(dim)) * size;
    // All its nodes are held, also where the root of the solid lies in it.
    if (lumen && lumen(center) > half_diagonal)
      return 0;
    if (!placed.empty())
      {
        // A larger cell is refined if one of its parts may lie in the band.
        const double margin =
          half_diagonal * (1 - parameters.finest_cell() / size);
        if (distance(center) <
            parameters.band * parameters.finest_cell() + margin)
          return parameters.leaflet_level;
      }
    return parameters.lumen_level;
  }



  template <int dim>
  bool
  SolidBand<dim>::is_used_up(const std::vector<Point<dim>> &x) const
  {
    // What remains is the half diagonal of the cell that a point lies in, and
    // half a cell.
    const double allowed =
      (parameters.band - 0.5 - 0.5 * std::sqrt(double(dim))) *
      parameters.finest_cell();
    for (unsigned int q = 0; q < x.size(); ++q)
      {
        // The nearest point on the way.
        const dealii::Tensor<1, dim> way = ahead[q] - placed[q];
        const double part =
          way * (x[q] - placed[q]) / std::max(way.norm_square(), 1e-30);
        if (x[q].distance_square(placed[q] + std::clamp(part, 0., 1.) * way) >
            allowed * allowed)
          return true;
      }
    return false;
  }



  template class SolidBand<2>;
  template class SolidBand<3>;
} // namespace coapt
