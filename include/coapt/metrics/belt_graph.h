#ifndef coapt_metrics_belt_graph_h
#define coapt_metrics_belt_graph_h

#include <coapt/metrics/leaflet_lines.h>

#include <vector>

namespace coapt
{
  /** A place where the belt of coaptation is interrupted. */
  struct BeltGap
  {
    /** Where on the free edge: its distance from the left end of the leaflet
     * along the edge (m), and the point of the mid-surface (m). */
    double position = 0;
    dealii::Point<3> place;

    /** Length of the way from one side of the gap to the other (m). */
    double length = 0;

    /** Number of columns on it. */
    unsigned int columns = 0;
  };

  /**
   * Belts of coaptation as ways in the graph of columns, where those that share
   * a quadrilateral are neighbours. A leaflet is sealed if a way of columns
   * that coapt leads from its first line to its last one. Otherwise the gaps
   * are where the way with the fewest other columns leaves the belt.
   */
  class BeltGraph
  {
  public:
    explicit BeltGraph(const Leaflet &leaflet);

    /**
     * The way from the first of the @p lines to the last one with the fewest
     * columns that do not coapt, and of those the shortest between the @p
     * points (m) of the columns; empty if there is none (Dijkstra, 1959).
     */
    std::vector<unsigned int>
    way(const LeafletLines::Lines &lines,
        const std::vector<bool> &coapts,
        const std::vector<dealii::Point<3>> &points) const;

    /** The gaps on such a way, from left to right, for the mid-surface
     * @p points (m) of the columns. */
    std::vector<BeltGap>
    gaps(const LeafletLines::Lines &lines,
         const std::vector<bool> &coapts,
         const std::vector<dealii::Point<3>> &points) const;

  private:
    std::vector<std::vector<unsigned int>> adjacent;
  };
} // namespace coapt

#endif
