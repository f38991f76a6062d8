#ifndef coapt_fluid_fluid_grid_h
#define coapt_fluid_fluid_grid_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <deal.II/distributed/tria.h>

#include <array>
#include <functional>
#include <vector>

namespace coapt
{
  template <int dim>
  class FluidOperator;

  /**
   * The octree of the fluid: an axis-aligned box of cubes, refined locally,
   * balanced (neighbours differ by one level, across corners too) and
   * distributed by p4est.
   */
  template <int dim>
  class FluidGrid
  {
  public:
    /**
     * Desired level of a cell, given the center of its box and its size
     * (m). It is also asked for parents of cells, and must not depend
     * on the rank.
     */
    using WantedLevel =
      std::function<unsigned int(const dealii::Point<dim> &center,
                                 const double size)>;

    /** Work that a cell causes, in any unit, given the center of its box and
     * its size (m). */
    using Work = std::function<unsigned int(const dealii::Point<dim> &center,
                                            const double size)>;

    /** The deepest level a cell can have. */
    static constexpr unsigned int max_level = 14;

    /**
     * A box from @p lower to @p upper with @p coarse_cells cells of level 0.
     * Sides are numbered 2 d (lower) and 2 d + 1 (upper in direction d).
     * Throws InputError unless these cells are cubes (to 1e-6).
     */
    FluidGrid(const MPI_Comm comm,
              const dealii::Point<dim> &lower,
              const dealii::Point<dim> &upper,
              const std::array<unsigned int, dim> &coarse_cells);

    /** The distributed octree. */
    dealii::parallel::distributed::Triangulation<dim> &
    triangulation();

    /** The distributed octree. */
    const dealii::parallel::distributed::Triangulation<dim> &
    triangulation() const;

    /** Lower corner of the box. */
    const dealii::Point<dim> &
    lower() const;

    /** Upper corner of the box. */
    const dealii::Point<dim> &
    upper() const;

    /** Whether a point lies on a side of the box. */
    bool
    is_on_side(const dealii::Point<dim> &point, const unsigned int side) const;

    /** Size (m) of the cells of a level. */
    double
    cell_size(const unsigned int level) const;

    /** From now on, cells are divided among the ranks such that all have about
     * the same @p work; without it, the same number of cells. */
    void
    divide_by(const Work &work);

    /** Refines and coarsens, without data, until every cell has its desired
     * level, or a finer one that the balance demands. Collective. */
    void
    refine_to(const WantedLevel &wanted_level);

    /**
     * Changes cells by up to one level towards the desired one and transfers
     * the state: @p velocity_owned (dim entries a node) is interpolated,
     * and @p pressure_owned is copied to children and averaged over them, so
     * that the sum of pressure times volume stays. Both are resized to
     * the new numbering of @p op, which is set up anew. Returns false, with
     * nothing changed, if no cell changes. Collective.
     */
    bool
    adapt(const WantedLevel &wanted_level,
          FluidOperator<dim> &op,
          std::vector<double> &velocity_owned,
          std::vector<double> &pressure_owned);

  private:
    /** Sets refinement flags; whether any rank has one. */
    bool
    flag_cells(const WantedLevel &wanted_level);

    dealii::parallel::distributed::Triangulation<dim> octree;
    dealii::Point<dim> lower_corner;
    dealii::Point<dim> upper_corner;
    double coarse_size;
  };
} // namespace coapt

#endif
