#ifndef coapt_fluid_octree_file_h
#define coapt_fluid_octree_file_h

#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * Writes the octree to files whose names begin with @p name, and with it,
   * cell by cell, the velocities (m/s) and pressures (Pa) of the nodes and
   * cells that this rank owns. Any number of ranks can read them. Collective.
   */
  template <int dim>
  void
  save_octree(const std::string &name,
              FluidGrid<dim> &grid,
              const FluidOperator<dim> &op,
              const std::vector<double> &velocity_owned,
              const std::vector<double> &pressure_owned);

  /**
   * Reads them, and divides the octree among the ranks by the work that is set
   * in @p grid, which must have the same box. Sets up @p op anew, and the state
   * in its numbering. Collective.
   */
  template <int dim>
  void
  load_octree(const std::string &name,
              FluidGrid<dim> &grid,
              FluidOperator<dim> &op,
              std::vector<double> &velocity_owned,
              std::vector<double> &pressure_owned);
} // namespace coapt

#endif
