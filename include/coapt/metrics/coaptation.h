#ifndef coapt_metrics_coaptation_h
#define coapt_metrics_coaptation_h

#include <coapt/geometry/leaflet.h>
#include <coapt/metrics/belt_graph.h>
#include <coapt/metrics/coaptation_profile.h>
#include <coapt/metrics/leaflet_lines.h>

#include <array>
#include <vector>

namespace coapt
{
  /** What counts as coaptation. */
  struct CoaptationSettings
  {
    /** Values of single columns are noise: they are averaged over columns
     * within this distance in the reference configuration (m), in blood two
     * fluid cells; a wider mean takes from the peaks. */
    double filter_radius = 2e-3;

    /** For the belt, tractions are averaged over columns within this distance
     * (m): a spot without pressure that is smaller is no gap. */
    double belt_radius = 2e-3;

    /** Columns with a larger gap to the other side do not coapt (m). */
    double gap_limit = 1.5e-3;

    /** Least averaged traction of a column that coapts (Pa). */
    double least_traction = 200;
  };

  /** Coaptation along one leaflet, from commissure to commissure. */
  struct LeafletCoaptation
  {
    /** Whether columns that coapt are connected from one end to the other. */
    bool continuous = false;

    /** Longest run of lines from annulus to free edge that do not coapt
     * anywhere (elements). */
    unsigned int longest_gap = 0;

    /** Least number of columns that do not coapt on a way along the leaflet;
     * zero exactly if the belt is continuous. */
    unsigned int missing_columns = 0;

    /** Mean height of the coapting part of the lines (m), in the reference
     * configuration. */
    double mean_height = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &continuous &longest_gap &missing_columns &mean_height;
    }
  };

  /** Coaptation of the whole valve. */
  struct CoaptationResult
  {
    double area             = 0; // m^2, of one side
    double force            = 0; // N, total traction on one side
    double contact_force    = 0; // N, the part that contact carries
    double contact_fraction = 0; // contact force over force
    double max_traction     = 0; // Pa, of averaged total traction

    LeafletCoaptation anterior, posterior;

    bool continuous          = false; // both leaflets
    unsigned int longest_gap = 0;     // elements, the longer of both

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &area &force &contact_force &contact_fraction &max_traction;
      archive &anterior &posterior &continuous &longest_gap;
    }
  };

  /**
   * Measures where and how firmly the leaflets meet. The belt is looked for on
   * the lines of each leaflet (LeafletLines), as a way in a graph (BeltGraph).
   */
  class Coaptation
  {
  public:
    /** Throws InputError if the leaflet has no free edge or no coordinates. */
    Coaptation(const Leaflet &leaflet,
               const CoaptationSettings &settings = CoaptationSettings());

    /**
     * Evaluates arrays with one value a column: @p gap to the other side (m),
     * mean @p contact_pressure and @p total_traction (contact and film, Pa),
     * current @p area (m^2).
     */
    CoaptationResult
    evaluate(const std::vector<double> &gap,
             const std::vector<double> &contact_pressure,
             const std::vector<double> &total_traction,
             const std::vector<double> &area) const;

    /** Area-weighted mean of @p values over the neighbourhood of each column
     * that is apposed, of apposed ones only, so that the width of a belt does
     * not change the mean; zero for others. */
    std::vector<double>
    average(const std::vector<double> &values,
            const std::vector<double> &gap,
            const std::vector<double> &area) const;

    /** Which columns coapt, by gap and averaged traction. */
    std::vector<bool>
    coapting(const std::vector<double> &gap,
             const std::vector<double> &total_traction,
             const std::vector<double> &area) const;

    /** Which columns lie beside another part of the leaflets, pressed or not.
     */
    std::vector<bool>
    apposed(const std::vector<double> &gap) const;

    /** Position by position from left to right, for the mid-surface @p points
     * (m) of the columns: of the anterior and the posterior leaflet. */
    std::array<std::vector<LineCoaptation>, 2>
    profile(const std::vector<double> &gap,
            const std::vector<double> &total_traction,
            const std::vector<double> &area,
            const std::vector<dealii::Point<3>> &points) const;

    /** Gaps in the belts of the anterior and the posterior leaflet. */
    std::array<std::vector<BeltGap>, 2>
    gaps(const std::vector<double> &gap,
         const std::vector<double> &total_traction,
         const std::vector<double> &area,
         const std::vector<dealii::Point<3>> &points) const;

    /** Columns with a larger gap do not coapt (m). */
    double
    gap_limit() const
    {
      return settings.gap_limit;
    }

    /** The lines from annulus to free edge. */
    const LeafletLines &
    leaflet_lines() const
    {
      return lines;
    }

  private:
    /** Columns around each column, in the reference configuration. */
    using Neighbourhoods = std::vector<std::vector<unsigned int>>;

    Neighbourhoods
    columns_within(const double radius) const;

    /** Means over these columns as average() takes them. */
    std::vector<double>
    average(const Neighbourhoods &around,
            const std::vector<double> &values,
            const std::vector<double> &gap,
            const std::vector<double> &area) const;

    LeafletCoaptation
    belt(const LeafletLines::Lines &of_leaflet,
         const std::vector<bool> &coapts) const;

    const CoaptationSettings settings;

    const LeafletLines lines;
    const BeltGraph graph;
    std::vector<dealii::Point<3>> reference; // of columns
    Neighbourhoods around_value, around_belt;
  };
} // namespace coapt

#endif
