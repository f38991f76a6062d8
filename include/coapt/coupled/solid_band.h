#ifndef coapt_coupled_solid_band_h
#define coapt_coupled_solid_band_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <deal.II/numerics/rtree.h>

#include <functional>
#include <vector>

namespace coapt
{
  /** Resolution of the octree (subsection "Mesh"). */
  struct MeshParameters
  {
    /** Edge of a coarse cell (m). */
    double coarse_cell = 5e-3;

    /** Levels of refinement of the lumen, and of the band around the
     * leaflet. */
    unsigned int lumen_level   = 2;
    unsigned int leaflet_level = 3;

    /** Half width of the band around the leaflet, in its cells. */
    double band = 2.5;

    /** Edge of the finest cell (m). */
    double
    finest_cell() const
    {
      return coarse_cell / (1u << leaflet_level);
    }

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them; throws InputError if the levels are out of order. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

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

    /** Places the band around the solid whose points are @p x (m), close
     * enough to each other to leave no gap. */
    void
    place(const std::vector<dealii::Point<dim>> &x);

    /** Level that a cell of this @p center and @p size (m) is to have. */
    unsigned int
    wanted_level(const dealii::Point<dim> &center, const double size) const;

    /** Whether the solid, now at @p x, has used up its band, of which half a
     * cell beside those that it lies in must remain. */
    bool
    is_used_up(const std::vector<dealii::Point<dim>> &x) const;

  private:
    MeshParameters parameters;
    std::function<double(const dealii::Point<dim> &)> lumen;
    std::vector<dealii::Point<dim>> placed;
    dealii::RTree<dealii::Point<dim>> tree;
  };
} // namespace coapt

#endif
