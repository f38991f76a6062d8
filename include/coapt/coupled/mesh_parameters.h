#ifndef coapt_coupled_mesh_parameters_h
#define coapt_coupled_mesh_parameters_h

#include <deal.II/base/parameter_handler.h>

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

    /** Level of the cells that the wall of the lumen cuts, if it is above the
     * lumen's. */
    unsigned int wall_level = 0;

    /** Half width of the band around the leaflet, in its cells. */
    double band = 2.5;

    /** By how many levels the band is coarser where no other part of the
     * leaflet is within the facing distance (m). */
    unsigned int levels_coarser_apart = 0;
    double facing_distance            = 4e-3;

    /** Whether coupling points are sparser there, too. */
    bool sparser_points_apart = false;

    /** Deepest level of cells that are refined for the flow; none are if it is
     * not above the lumen's. */
    unsigned int flow_level = 0;

    /** Change of velocity over a cell (m/s) above which it is refined for the
     * flow. */
    double flow_jump = 0.1;

    /** Time between two adaptations to the flow (s). */
    double flow_interval = 2e-3;

    /** Cells with fluid beyond which no more are refined for the flow. */
    unsigned int max_cells = 1000000;

    /** Whether the octree follows the flow. */
    bool
    follows_flow() const
    {
      return flow_level > lumen_level;
    }

    /** Edge of a cell of the @p level (m). */
    double
    cell_size(const unsigned int level) const
    {
      return coarse_cell / (1u << level);
    }

    /** Level of the band where no other part of the leaflet is near. */
    unsigned int
    level_apart() const
    {
      return leaflet_level - levels_coarser_apart;
    }

    /** Edge of the finest cell (m). */
    double
    finest_cell() const
    {
      return cell_size(leaflet_level);
    }

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them; throws InputError if the levels are out of order. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
