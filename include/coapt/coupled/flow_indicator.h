#ifndef coapt_coupled_flow_indicator_h
#define coapt_coupled_flow_indicator_h

#include <coapt/coupled/mesh_parameters.h>
#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>

#include <array>
#include <functional>
#include <vector>

namespace coapt
{
  /**
   * Where the flow wants finer cells: jets, shear layers and vortices, by the
   * change of velocity over a cell, h |grad u|, the indicator of explicit
   * hydrocodes. It is kept as the largest gradient in each box of a regular
   * grid, the size of the lumen's cells. So it is the same function of
   * the position on all ranks, and a cell and its parent see the same.
   */
  template <int dim>
  class FlowIndicator
  {
  public:
    /** Whether not to look at a place. */
    using Mask = std::function<bool(const dealii::Point<dim> &)>;

    explicit FlowIndicator(const MeshParameters &parameters);

    /**
     * Looks at a velocity, dim values for each local node (m/s), outside of
     * @p masked, for there may be refinement for other reasons. Raises the
     * velocity jump that is tolerated if there are too many cells with fluid,
     * and returns whether it has done so. Collective.
     */
    bool
    update(const FluidGrid<dim> &grid,
           const FluidOperator<dim> &fluid,
           const double *velocity_local,
           const Mask &masked);

    /**
     * Level that a cell is to have, given its @p center and present @p size
     * (m): between the level of the lumen and that of the flow. A cell is
     * refined if the velocity changes by more than the tolerated jump over
     * it, and joined with its siblings if it would then change by less than
     * half of that.
     */
    unsigned int
    wanted_level(const dealii::Point<dim> &center, const double size) const;

    /** Change of velocity over a cell that is tolerated now (m/s). */
    double
    tolerated_jump() const
    {
      return jump;
    }

    /** Saves or restores what the last update() has found. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &jump &lower &n_boxes &largest_gradient;
    }

  private:
    /** Number of the box around a point. */
    std::size_t
    box(const dealii::Point<dim> &x) const;

    /** Least level at which a cell sees less than @p jump. */
    unsigned int
    level_for(const double gradient, const double jump) const;

    MeshParameters parameters;
    double jump;
    dealii::Point<dim> lower;
    std::array<unsigned int, dim> n_boxes{};
    std::vector<double> largest_gradient; // 1/s
  };
} // namespace coapt

#endif
