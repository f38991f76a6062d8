#ifndef coapt_metrics_coaptation_profile_h
#define coapt_metrics_coaptation_profile_h

#include <coapt/metrics/leaflet_lines.h>

#include <string>
#include <vector>

namespace coapt
{
  /** Coaptation at one position along a leaflet. */
  struct LineCoaptation
  {
    /** Fraction of the leaflet's attachment to the annulus, 0 at the left
     * commissure, 1 at the right one. */
    double position = 0;

    /** Width of the belt: height of the tissue that coapts, in the reference
     * configuration (m). */
    double contact_height = 0;

    /** What an echocardiogram shows: length of the closed leaflet that lies
     * beside the other one, whether they press on each other or not (m). */
    double apposition = 0;

    /** Largest traction (Pa). */
    double max_traction = 0;
  };

  /** Coaptation of one third of a leaflet: A1 to A3, P1 to P3, with 1 at the
   * left commissure. */
  struct SegmentCoaptation
  {
    std::string name;
    double contact_height     = 0; // mean over its lines, m
    double min_contact_height = 0; // of a line, m
    double apposition         = 0; // mean over its lines, m
  };

  /**
   * The coaptation of each line of a leaflet, from left to right.
   *
   * @param lines of the leaflet, from annulus to free edge.
   * @param height that each column stands for (m, reference).
   * @param coapts,apposed whether a column coapts, and whether the other side
   *   is near.
   * @param traction of each column (Pa).
   * @param reference,current mid-surface points of the columns (m).
   */
  std::vector<LineCoaptation>
  coaptation_profile(const LeafletLines::Lines &lines,
                     const std::vector<double> &height,
                     const std::vector<bool> &coapts,
                     const std::vector<bool> &apposed,
                     const std::vector<double> &traction,
                     const std::vector<dealii::Point<3>> &reference,
                     const std::vector<dealii::Point<3>> &current);

  /** The thirds of a profile, by position, named with @p letter. A third
   * without lines has zeros. */
  std::vector<SegmentCoaptation>
  coaptation_by_segment(const std::vector<LineCoaptation> &profile,
                        const char letter);
} // namespace coapt

#endif
