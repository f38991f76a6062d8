#ifndef coapt_coupled_state_layout_h
#define coapt_coupled_state_layout_h

#include <cstddef>

namespace coapt
{
  /**
   * Where the named blocks of the state y = (u, p | X, V, lambda) lie in the
   * contiguous array that one rank owns. SUNDIALS, checkpoints and mesh
   * adaptation all see this one array. All blocks but the pressure hold node
   * (or point) wise groups of dim components.
   */
  template <int dim>
  struct StateLayout
  {
    unsigned int n_fluid_nodes = 0; // owned
    unsigned int n_fluid_cells = 0; // owned
    unsigned int n_solid_nodes = 0; // owned
    unsigned int n_points      = 0; // owned

    /** Offsets of the blocks: fluid velocity (m/s), fluid pressure (Pa), solid
     * position (m), solid velocity (m/s), multiplier (N/m^3). @{ */
    std::size_t
    velocity() const
    {
      return 0;
    }

    std::size_t
    pressure() const
    {
      return std::size_t(dim) * n_fluid_nodes;
    }

    std::size_t
    position() const
    {
      return pressure() + n_fluid_cells;
    }

    std::size_t
    solid_velocity() const
    {
      return position() + std::size_t(dim) * n_solid_nodes;
    }

    std::size_t
    multiplier() const
    {
      return solid_velocity() + std::size_t(dim) * n_solid_nodes;
    }
    /** @} */

    /** Length of the array. */
    std::size_t
    size() const
    {
      return multiplier() + std::size_t(dim) * n_points;
    }
  };
} // namespace coapt

#endif
