#include <coapt/coupled/cell_work.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;

  template <int dim>
  CellWork<dim>::CellWork(
    const Point<dim> &lower,
    const double finest,
    const std::function<double(const Point<dim> &)> &lumen)
    : lower(lower), finest(finest), lumen(lumen)
  {
  }



  template <int dim>
  std::uint64_t
  CellWork<dim>::number(const Point<dim> &x, const unsigned int doublings) const
  {
    const double size    = finest * (1u << doublings);
    std::uint64_t result = 0;
    for (unsigned int d = 0; d < dim; ++d)
      result = (result << 21) +
        static_cast<std::uint64_t>(std::max(0., (x[d] - lower[d]) / size));
    return result;
  }



  template <int dim>
  void
  CellWork<dim>::place(const std::vector<Point<dim>> &dense,
                       const std::vector<Point<dim>> &active)
  {
    for (unsigned int i = 0; i < n_points.size(); ++i)
      {
        n_points[i].clear();
        for (const Point<dim> &point : i == 0 ? dense : active)
          ++n_points[i][number(point, i)];
      }
  }



  template <int dim>
  unsigned int
  CellWork<dim>::operator()(const Point<dim> &center, const double size) const
  {
    // Only their ratios matter; shares of integrator and exchange included.
    const unsigned int of_cell = 40, of_idle_cell = 12, of_point = 31;
    if (lumen && lumen(center) > 0.5 * std::sqrt(double(dim)) * size)
      return of_idle_cell;
    const unsigned int doublings = std::lround(std::log2(size / finest));
    if (doublings >= n_points.size())
      return of_cell;
    const auto found = n_points[doublings].find(number(center, doublings));
    return of_cell +
      (found == n_points[doublings].end() ? 0 : found->second * of_point);
  }



  template class CellWork<2>;
  template class CellWork<3>;
} // namespace coapt
