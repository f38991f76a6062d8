#ifndef coapt_fluid_cell_locator_h
#define coapt_fluid_cell_locator_h

#include <deal.II/base/point.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace coapt
{
  /**
   * Finds the cell of an octree that contains a point by arithmetic: the
   * integer coordinates of the point on each level that occurs are looked up
   * in a hash table. Cells are half-open boxes.
   */
  template <int dim>
  class CellLocator
  {
  public:
    /** Forgets all cells. The box reaches from @p lower to @p upper, cells of
     * level 0 have the size @p coarse_size. */
    void
    reinit(const dealii::Point<dim> &lower,
           const dealii::Point<dim> &upper,
           const double coarse_size);

    /** Adds the next cell, numbered consecutively from zero, by any point
     * well inside it. */
    void
    add_cell(const dealii::Point<dim> &inside, const unsigned int level);

    /** The number of the cell that contains @p point, -1 if there is none.
     * The cell @p hint (or -1) is tried first. */
    int
    locate(const dealii::Point<dim> &point, const int hint) const;

    /** Lower corner of a cell, computed from its integer coordinates and so
     * the same on all ranks to the last bit. */
    dealii::Point<dim>
    lower_corner(const unsigned int cell) const;

  private:
    using Coordinates = std::array<std::int64_t, dim>;

    /** Level that integer coordinates refer to: finer than any cell. */
    static constexpr unsigned int finest_level = 15;

    Coordinates
    coordinates(const dealii::Point<dim> &point) const;

    /** Level and coordinates of the cell of that level around a point. */
    static std::uint64_t
    key(const Coordinates &finest, const unsigned int level);

    dealii::Point<dim> origin;
    dealii::Point<dim> end;
    double coarse_size         = 1;
    double inverse_finest_size = 1;
    std::vector<Coordinates> cell_coordinates;
    std::vector<unsigned int> cell_level;
    std::vector<std::uint64_t> cell_key;
    std::vector<unsigned int> levels_present;
    std::unordered_map<std::uint64_t, unsigned int> cell_of_key;
  };
} // namespace coapt

#endif
