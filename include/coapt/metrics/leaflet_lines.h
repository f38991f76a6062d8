#ifndef coapt_metrics_leaflet_lines_h
#define coapt_metrics_leaflet_lines_h

#include <coapt/geometry/leaflet.h>

#include <vector>

namespace coapt
{
  /** Position of a column in the middle of the thickness, in the reference
   * configuration (m). */
  dealii::Point<3>
  middle_of_column(const Leaflet &leaflet, const unsigned int column);

  /**
   * The columns of a leaflet in lines from annulus to free edge, one line for
   * each column of the free edge; a column belongs to the line that is nearest
   * in angle. The root belongs to none.
   */
  struct LeafletLines
  {
    using Lines = std::vector<std::vector<unsigned int>>;

    /** Throws InputError if the leaflet has no free edge or no coordinates. */
    explicit LeafletLines(const Leaflet &leaflet);

    /** All lines, in the order of the free edge. */
    Lines all;

    /** Those that touch a quadrilateral of one leaflet, from the left
     * commissure to the right one. @{ */
    Lines anterior, posterior;
    /** @} */

    /** Length of the line that each column stands for, and its distance from
     * the annulus along the line, in the reference configuration (m). In the
     * root both are zero. @{ */
    std::vector<double> height, depth;
    /** @} */
  };
} // namespace coapt

#endif
