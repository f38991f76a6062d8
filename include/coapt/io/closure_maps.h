#ifndef coapt_io_closure_maps_h
#define coapt_io_closure_maps_h

#include <coapt/metrics/leaflet_monitor.h>

#include <functional>
#include <string>
#include <vector>

namespace coapt
{
  /** Mean tractions of the columns over the last part of a run (Pa). */
  struct MeanTractions
  {
    std::vector<double> contact, total;
  };

  /**
   * Writes what is known of the closed valve at the end of a run, each into the
   * file that @p file gives for its name; call it on one rank:
   * - contact_map.vtu and .csv: contact pressure, coaptation pressure, gap and
   *   time of first contact on the reference leaflet, unrolled;
   * - coaptation.csv: the belt by position along each leaflet;
   * - pressure_distribution.csv: shares of the area of coaptation above
   *   pressures;
   * - sections.csv: the leaflets cut at the middle and at a quarter of their
   *   width on both sides, mid-surface.
   */
  void
  write_closure_maps(
    const ValveStructure &valve,
    const LeafletMonitor &monitor,
    const MeanTractions &tractions,
    const std::function<std::string(const std::string &)> &file);
} // namespace coapt

#endif
