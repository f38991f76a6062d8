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
   * around it, the lumen's level elsewhere, no refinement outside the lumen.
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
     */
    void
    place(const std::vector<dealii::Point<dim>> &x,
          const std::vector<dealii::Point<dim>> &v = {});

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
    /** Distance (m) of @p x from the solid. */
    double
    distance(const dealii::Point<dim> &x) const;

    MeshParameters parameters;
    std::function<double(const dealii::Point<dim> &)> lumen;
    std::vector<dealii::Point<dim>> placed, ahead;
    dealii::RTree<dealii::Point<dim>> tree;
  };
} // namespace coapt

#endif
