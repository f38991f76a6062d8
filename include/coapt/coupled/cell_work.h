#ifndef coapt_coupled_cell_work_h
#define coapt_coupled_cell_work_h

#include <deal.II/base/point.h>

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
    /** Coupling points in the lumen lie in cells of size @p finest (m) or twice
     * that, in a box with the corner @p lower; those in the wall are idle.
     * @p lumen is the signed distance to the wall, negative inside; empty if
     * the whole box is lumen. */
    CellWork(const dealii::Point<dim> &lower,
             const double finest,
             const std::function<double(const dealii::Point<dim> &)> &lumen);

    /** The coupling points have moved to @p points (m). In cells twice as large
     * as the finest ones, there are @p share_in_large times as many. */
    void
    place(const std::vector<dealii::Point<dim>> &points,
          const double share_in_large = 1);

    /** Work of a cell of this @p center and @p size (m), in nanoseconds an
     * evaluation on the machine where it was measured. */
    unsigned int
    operator()(const dealii::Point<dim> &center, const double size) const;

  private:
    /** Number of the finest cell that contains @p x. */
    std::uint64_t
    number(const dealii::Point<dim> &x) const;

    dealii::Point<dim> lower;
    double finest;
    double share_in_large = 1;
    std::function<double(const dealii::Point<dim> &)> lumen;
    std::unordered_map<std::uint64_t, unsigned int> n_points;
  };
} // namespace coapt

#endif
