#ifndef coapt_metrics_unrolled_leaflet_h
#define coapt_metrics_unrolled_leaflet_h

#include <coapt/metrics/leaflet_lines.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * The leaflet in its reference shape, unrolled into the plane: to the right
   * the angle around the valve times the mean radius of the annulus, zero at
   * mid-anterior and cut open at mid-posterior, down the distance from the
   * annulus along the lines. The sense is that of a look from inside: left is
   * the left commissure of the anterior leaflet. The root is left out.
   */
  struct UnrolledLeaflet
  {
    UnrolledLeaflet(const Leaflet &leaflet, const LeafletLines &lines);

    /** Points in the plane z = 0 (m), and the column that each one shows; those
     * on the cut are there twice. @{ */
    std::vector<dealii::Point<3>> points;
    std::vector<unsigned int> columns;
    /** @} */

    /** Triangles of points, and the quadrilateral that each one is part of. @{
     */
    std::vector<std::array<unsigned int, 3>> triangles;
    std::vector<unsigned int> quads;
    /** @} */

    /** Values of columns for the points. */
    std::vector<double>
    on_points(const std::vector<double> &of_columns) const;
  };
} // namespace coapt

#endif
