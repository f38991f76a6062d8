#include <coapt/metrics/region_volumes.h>

namespace coapt
{
  std::vector<double>
  volumes_in_region(const Leaflet &leaflet,
                    const Region region,
                    const std::vector<double> &volumes)
  {
    std::vector<double> result(volumes.size(), 0.);
    for (unsigned int c = 0; c < volumes.size(); ++c)
      if (leaflet.quad_region[leaflet.cell_quad[c]] == region)
        result[c] = volumes[c];
    return result;
  }
} // namespace coapt
