#ifndef coapt_metrics_coaptation_h
#define coapt_metrics_coaptation_h

#include <coapt/geometry/leaflet.h>

#include <array>
#include <vector>

namespace coapt
{
  /** What counts as coaptation. */
  struct CoaptationSettings
  {
    /** Tractions are averaged over columns within this distance in the
     * reference configuration (m); at least two fluid cells, since traction at
     * single columns is noise. */
    double filter_radius = 2e-3;

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

    /** Mean and largest height of the coapting part of a line (m), in the
     * reference configuration. */
    double mean_height = 0, max_height = 0;
  };

  /** Coaptation of the whole valve. */
  struct CoaptationResult
  {
    double area                 = 0; // m^2, of one side
    double force                = 0; // N, total traction on one side
    double contact_force        = 0; // N, the part that contact carries
    double contact_fraction     = 0; // contact force over force
    double max_traction         = 0; // Pa, of averaged total traction
    double max_contact_pressure = 0; // Pa, averaged

    LeafletCoaptation anterior, posterior;

    bool continuous          = false; // both leaflets
    unsigned int longest_gap = 0;     // elements, the longer of both
  };

  /**
   * Measures where and how firmly the leaflets meet. Columns are grouped into
   * lines from annulus to free edge, one for each column of the free edge, by
   * their angle. The belt is looked for on the lines of each leaflet, which
   * are those that touch one of its quadrilaterals.
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

    /** Area-weighted mean of @p values over the neighbourhood of each column.
     */
    std::vector<double>
    average(const std::vector<double> &values,
            const std::vector<double> &area) const;

  private:
    /** Lines of a leaflet in order, each with its columns. */
    using Lines = std::vector<std::vector<unsigned int>>;

    void
    set_up_neighbourhoods(const Leaflet &leaflet);

    void
    set_up_lines(const Leaflet &leaflet);

    void
    set_up_heights(const Leaflet &leaflet, const Lines &all_lines);

    LeafletCoaptation
    belt(const Lines &lines, const std::vector<bool> &coapts) const;

    unsigned int
    missing_columns(const Lines &lines, const std::vector<bool> &coapts) const;

    const CoaptationSettings settings;

    std::vector<std::vector<unsigned int>> neighbourhood; // within the radius
    std::vector<std::vector<unsigned int>> adjacent;      // share an element
    std::vector<double> height; // of a line, by column, m
    Lines anterior_lines, posterior_lines;
  };
} // namespace coapt

#endif
