#ifndef coapt_coupled_solid_band_h
#define coapt_coupled_solid_band_h

#include <coapt/coupled/mesh_parameters.h>

#include <deal.II/base/point.h>

#include <deal.II/numerics/rtree.h>

#include <functional>
#include <vector>

namespace coapt
{
  /**
   * The refinement that follows the solid: the finest level within a band
   * around what faces other parts of the solid, the level of parts that are
   * apart within a band around the rest, the level of the wall where it cuts
   * cells, the lumen's level elsewhere, and no refinement outside the lumen.
   */
  template <int dim>
  class SolidBand
  {
  public:
    /** @p lumen is the signed distance to the wall, negative inside; empty if
     * the whole box is lumen. */
    SolidBand(const MeshParameters &parameters,
              const std::function<double(const dealii::Point<dim> &)> &lumen);

    /**
     * Places the band around the solid whose points are @p x (m), close
     * enough to each other to leave no gap, and around where they will be with
     * the velocities @p v (m/s), at most 1.5 finest cells further: a moving
     * solid takes longer to use up its band. Without velocities it rests.
     * @p faces says of each point whether it faces another part; all do
     * if it is empty.
     */
    void
    place(const std::vector<dealii::Point<dim>> &x,
          const std::vector<dealii::Point<dim>> &v = {},
          const std::vector<bool> &faces           = {});

    /** Level that a cell of this @p center and @p size (m) is to have. */
    unsigned int
    wanted_level(const dealii::Point<dim> &center, const double size) const;

    /** Whether @p x is within the band, or a cell beside it. */
    bool
    is_near(const dealii::Point<dim> &x) const;

    /** Whether the solid, now at @p x, has used up its band, of which half a
     * cell beside those that it lies in must remain. */
    bool
    is_used_up(const std::vector<dealii::Point<dim>> &x) const;

  private:
    using Tree = dealii::RTree<dealii::Point<dim>>;

    /** Whether a cell is within the band of cells of a level around the points
     * of @p tree, or one of its parts may be. */
    bool
    is_in_band(const dealii::Point<dim> &center,
               const double size,
               const Tree &tree,
               const unsigned int level) const;

    MeshParameters parameters;
    std::function<double(const dealii::Point<dim> &)> lumen;
    std::vector<dealii::Point<dim>> placed, ahead;
    std::vector<double> cell_at; // size of the cells around each point
    Tree facing, apart;
  };
} // namespace coapt

#endif
