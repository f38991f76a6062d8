#ifndef coapt_io_valve_warnings_h
#define coapt_io_valve_warnings_h

#include <coapt/metrics/leaflet_monitor.h>

#include <string>
#include <vector>

namespace coapt
{
  /** Something wrong with a valve: a key for the kind, and what is to be
   * said. */
  struct ValveWarning
  {
    std::string key, text;
  };

  /**
   * What is wrong with a @p sample of a valve whose leaflets have the given
   * @p thickness (m) in blood with the given @p finest_cell (m; zero without
   * blood): leaflets that penetrate each other by more than half their
   * thickness; coupling points more than 0.9 cells apart, where it begins to
   * leak; and, in a valve that is shut (no way is half a cell wide), noise of
   * more than 10 Pa or 1 mm/s away from the leaflet, and velocities above
   * 1 m/s. Before, the inflow itself has such noise.
   *
   * @throws NumericalError if coupling points are 1.4 cells apart or more,
   * which is unstable.
   */
  std::vector<ValveWarning>
  valve_warnings(const ValveSample &sample,
                 const double thickness,
                 const double finest_cell);
} // namespace coapt

#endif
