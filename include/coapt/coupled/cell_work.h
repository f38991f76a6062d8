#ifndef coapt_coupled_cell_work_h
#define coapt_coupled_cell_work_h

#include <deal.II/base/point.h>

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace coapt
{
  /**
   * An estimate of the work that a cell causes, by which the octree is divided
   * among the ranks: cells with coupling points cost several times what
   * cells of fluid alone do, and cells outside of the lumen much less.
   */
  template <int dim>
  class CellWork
  {
  public:
    /** The finest cells have the size @p finest (m), in a box with the corner
     * @p lower. Cells in the wall are idle: @p lumen is the signed distance to
     * it, negative inside; empty if the whole box is lumen. */
    CellWork(const dealii::Point<dim> &lower,
             const double finest,
             const std::function<double(const dealii::Point<dim> &)> &lumen);

    /** The coupling points have moved to @p dense (m), which is where they are
     * in finest cells, and those that carry coupling now to @p active, which
     * counts in larger ones. */
    void
    place(const std::vector<dealii::Point<dim>> &dense,
          const std::vector<dealii::Point<dim>> &active);

    /** Work of a cell of this @p center and @p size (m), in nanoseconds an
     * evaluation on the machine where it was measured. */
    unsigned int
    operator()(const dealii::Point<dim> &center, const double size) const;

  private:
    /** Number of the cell that contains @p x, of those whose size is that of
     * the finest ones doubled so many times. */
    std::uint64_t
    number(const dealii::Point<dim> &x, const unsigned int doublings) const;

    dealii::Point<dim> lower;
    double finest;
    std::function<double(const dealii::Point<dim> &)> lumen;

    /** Points in each cell, for the finest cells and three larger sizes. */
    std::array<std::unordered_map<std::uint64_t, unsigned int>, 4> n_points;
  };
} // namespace coapt

#endif
