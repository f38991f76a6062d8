#ifndef coapt_coupled_system_snapshot_h
#define coapt_coupled_system_snapshot_h

#include <vector>

namespace coapt
{
  /** What a coupled system needs, besides the state of the fluid, to go on from
   * where it was: the same on all ranks, and for any number of them. */
  struct SystemSnapshot
  {
    std::vector<double> positions, velocities; // of all solid nodes (m, m/s)
    std::vector<double> multiplier;            // of all coupling points (N/m^3)
    std::vector<bool> active;                  // whether these carry coupling
    std::vector<double> impulse_force, impulse_start; // N, m
    double impulse_work = 0, motion_work = 0;         // J
    double step_length = 0;                           // the last one (s)
    bool points_left   = false;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &positions &velocities &multiplier &active &impulse_force;
      archive &impulse_start &impulse_work &motion_work &step_length;
      archive &points_left;
    }
  };
} // namespace coapt

#endif
