#ifndef coapt_coupled_valve_snapshot_h
#define coapt_coupled_valve_snapshot_h

#include <coapt/contact/mid_surface_contact.h>
#include <coapt/coupled/sub_grid_film.h>
#include <coapt/coupled/system_snapshot.h>

#include <vector>

namespace coapt
{
  /** What a valve in blood needs, besides the state of the fluid, to go on from
   * where it was, on any number of ranks. */
  struct ValveSnapshot
  {
    unsigned int coarse_cells = 0; // of the octree
    double coarse_size        = 0; // m
    unsigned int n_chordae    = 0;
    SystemSnapshot system;
    MidSurfaceContact::Snapshot contact;

    /** Empty if films were not drained. */
    SubGridFilm::History film;
    double time_of_film = 0;

    /** Positions (m) and velocities (m/s) of the solid's nodes when the octree
     * was adapted to them. @{ */
    std::vector<double> adapted_positions, adapted_velocities;
    /** @} */

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &coarse_cells &coarse_size &n_chordae &system &contact &film;
      archive &time_of_film &adapted_positions &adapted_velocities;
    }
  };
} // namespace coapt

#endif
