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
  CellWork<dim>::number(const Point<dim> &x) const
  {
    std::uint64_t result = 0;
    for (unsigned int d = 0; d < dim; ++d)
      result = (result << 21) +
        static_cast<std::uint64_t>(std::max(0., (x[d] - lower[d]) / finest));
    return result;
  }



  template <int dim>
  void
  CellWork<dim>::place(const std::vector<Point<dim>> &points,
                       const double share_in_large)
  {
    this->share_in_large = share_in_large;
    n_points.clear();
    for (const Point<dim> &point : points)
      ++n_points[number(point)];
  }



  template <int dim>
  unsigned int
  CellWork<dim>::operator()(const Point<dim> &center, const double size) const
  {
    // Only their ratios matter; shares of integrator and exchange included.
    const unsigned int of_cell = 40, of_idle_cell = 12, of_point = 31;
    if (lumen && lumen(center) > 0.5 * std::sqrt(double(dim)) * size)
      return of_idle_cell;
    if (size > 3 * finest)
      return of_cell;
    const bool large = size > 1.5 * finest;
    double points    = 0;
    for (unsigned int part = 0; part < (large ? 1u << dim : 1u); ++part)
      {
        Point<dim> middle = center;
        for (unsigned int d = 0; d < dim && large; ++d)
          middle[d] += ((part >> d) & 1 ? 0.25 : -0.25) * size;
        const auto found = n_points.find(number(middle));
        points += found == n_points.end() ? 0 : found->second;
      }
    return of_cell +
      std::lround((large ? share_in_large : 1.) * points * of_point);
  }



  template class CellWork<2>;
  template class CellWork<3>;
} // namespace coapt
