#ifndef coapt_io_closure_figures_h
#define coapt_io_closure_figures_h

#include <coapt/io/closure_maps.h>
#include <coapt/io/summary.h>

namespace coapt
{
  /** Height in contact and apposition of the segments A1 to P3 (mm). */
  Summary
  segment_figures(const ValveStructure &valve,
                  const LeafletMonitor &monitor,
                  const MeanTractions &tractions);

  /** Their number, and leaflet, position on the free edge, place and length
   * (mm) of each gap in the belts of coaptation. */
  Summary
  gap_figures(const ValveStructure &valve,
              const LeafletMonitor &monitor,
              const MeanTractions &tractions);

  /** Bulging volume (mL), mean von Mises stress (kPa) and largest strain, and
   * what 5 % of the volume exceed, of the regions of the leaflets at the last
   * sample. */
  Summary
  region_figures(const ValveStructure &valve, const LeafletMonitor &monitor);
} // namespace coapt

#endif
