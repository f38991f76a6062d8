#ifndef coapt_metrics_region_volumes_h
#define coapt_metrics_region_volumes_h

#include <coapt/geometry/leaflet.h>

#include <vector>

namespace coapt
{
  /** The @p volumes (m^3) of those cells of the leaflet that belong to the
   * @p region, and zero for all others: weights for the mean or a quantile of
   * what the cells have there (weighted_mean(), weighted_quantile()). */
  std::vector<double>
  volumes_in_region(const Leaflet &leaflet,
                    const Region region,
                    const std::vector<double> &volumes);
} // namespace coapt

#endif
