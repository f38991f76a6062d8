#include <coapt/fluid/cell_locator.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  template <int dim>
  void
  CellLocator<dim>::reinit(const dealii::Point<dim> &lower,
                           const dealii::Point<dim> &upper,
                           const double size)
  {
    origin              = lower;
    end                 = upper;
    coarse_size         = size;
    inverse_finest_size = (1 << finest_level) / size;
    cell_coordinates.clear();
    cell_level.clear();
    cell_key.clear();
    levels_present.clear();
    cell_of_key.clear();
  }



  template <int dim>
  typename CellLocator<dim>::Coordinates
  CellLocator<dim>::coordinates(const dealii::Point<dim> &point) const
  {
    Coordinates result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = static_cast<std::int64_t>(
        std::floor((point[d] - origin[d]) * inverse_finest_size));
    return result;
  }



  template <int dim>
  std::uint64_t
  CellLocator<dim>::key(const Coordinates &finest, const unsigned int level)
  {
    // 4 bits for the level, 20 for each direction
    std::uint64_t result = level;
    for (unsigned int d = 0; d < dim; ++d)
      result =
        (result << 20) | ((finest[d] >> (finest_level - level)) & 0xfffff);
    return result;
  }



  template <int dim>
  void
  CellLocator<dim>::add_cell(const dealii::Point<dim> &inside,
                             const unsigned int level)
  {
    Coordinates finest = coordinates(inside);
    cell_key.push_back(key(finest, level));
    cell_of_key[cell_key.back()] = cell_key.size() - 1;
    for (unsigned int d = 0; d < dim; ++d)
      finest[d] >>= finest_level - level;
    cell_coordinates.push_back(finest);
    cell_level.push_back(level);
    if (std::find(levels_present.begin(), levels_present.end(), level) ==
        levels_present.end())
      {
        levels_present.push_back(level);
        // finest first: most points of interest are in the finest cells
        std::sort(levels_present.rbegin(), levels_present.rend());
      }
  }



  template <int dim>
  int
  CellLocator<dim>::locate(const dealii::Point<dim> &point,
                           const int hint) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (!(point[d] >= origin[d] && point[d] < end[d])) // or not a number
        return -1;
    const Coordinates finest = coordinates(point);
    if (hint >= 0 && static_cast<std::size_t>(hint) < cell_key.size() &&
        key(finest, cell_level[hint]) == cell_key[hint])
      return hint;
    for (const unsigned int level : levels_present)
      {
        const auto found = cell_of_key.find(key(finest, level));
        if (found != cell_of_key.end())
          return found->second;
      }
    return -1;
  }



  template <int dim>
  dealii::Point<dim>
  CellLocator<dim>::lower_corner(const unsigned int cell) const
  {
    const double size = coarse_size / (1 << cell_level[cell]);
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = origin[d] + size * cell_coordinates[cell][d];
    return result;
  }

  template class CellLocator<2>;
  template class CellLocator<3>;
} // namespace coapt
