#ifndef coapt_metrics_past_edge_h
#define coapt_metrics_past_edge_h

#include <coapt/geometry/leaflet.h>

#include <vector>

namespace coapt
{
  /**
   * Tells which columns hang past the free edge of what faces them: coaptation
   * ends where the shorter leaflet ends, and the rest of the longer one has
   * the blood of the ventricle on both sides, although the edge may still be
   * its nearest neighbour.
   */
  class PastEdge
  {
  public:
    explicit PastEdge(const Leaflet &leaflet);

    /**
     * Evaluates mid-surface @p points (m) and the nearest facing triangle of
     * each column, @p partner (MidSurfaceContact::ColumnState). A column is
     * past an edge if the closest point lies on it, and the column further
     * than half a thickness outside of it, measured in the plane of the
     * partner.
     */
    std::vector<bool>
    operator()(const std::vector<dealii::Point<3>> &points,
               const std::vector<unsigned int> &partner) const;

  private:
    const double thickness;
    const std::vector<std::array<unsigned int, 3>> triangles;
    std::vector<bool> on_edge; // columns
  };
} // namespace coapt

#endif
