#ifndef coapt_io_valve_report_h
#define coapt_io_valve_report_h

#include <coapt/io/closure_maps.h>
#include <coapt/io/statistics.h>
#include <coapt/io/summary.h>
#include <coapt/metrics/closure_volumes.h>
#include <coapt/metrics/leaflet_monitor.h>

#include <algorithm>
#include <string>
#include <vector>

namespace coapt
{
  /** What a computation has cost. */
  struct RunCost
  {
    unsigned int fluid_cells     = 0;
    unsigned int solid_tets      = 0;
    unsigned int coupling_points = 0;
    unsigned long steps          = 0;
    unsigned long evaluations    = 0; // of the right-hand side
    double wall_seconds          = 0;
    unsigned int ranks           = 1;
    double step_length           = 0; // s, the present one
  };

  /** The books of energy (J) at the time of a sample: works, losses, energies
   * and what is left over. */
  std::vector<Statistics::Entry>
  energy_books(const ValveSample &sample, const bool in_blood);

  /** A row of statistics.csv: names with units, and values in them; without
   * blood, what concerns it is left out. */
  std::vector<Statistics::Entry>
  statistics_row(const ValveSample &sample,
                 const RunCost &cost,
                 const bool in_blood);

  /** A row of chordae.csv: the time and the tension (N) of each chorda, by its
   * name. */
  std::vector<Statistics::Entry>
  chordae_row(const ValveSample &sample, const std::vector<Chorda> &chordae);

  /** How a run is judged. */
  struct ReportSettings
  {
    /** End of the run (s). */
    double end_time = 0;

    /** Width (m) beyond the contact clearance below which a path through the
     * valve is shut. */
    double shut_width = 0;

    /** Whether there is blood that may leak. */
    bool in_blood = true;
  };

  /**
   * Collects the samples of a run and draws the verdict from them.
   *
   * Surfaces of the leaflet that are nearer to each other than the contact
   * clearance touch, so the width of a path is that beyond the clearance.
   * Closing time: the first sample from which on the widest path through the
   * valve stays below the width that is called shut, half a fluid cell or
   * half the clearance. Leak: what leaves the ventricle, by the atrial end or
   * drained from films, minus what the leaflets sweep, mean over the last 20
   * ms; coaptation is that of the mean tractions over the same window. Sealed:
   * the widest path is shut at the end, and the leak at most 1 mL/s.
   */
  class ValveReport
  {
  public:
    /** Length of the window of the final means (s), and the largest leak of a
     * sealed valve (m^3/s). @{ */
    static constexpr double window       = 20e-3;
    static constexpr double largest_leak = 1e-6;
    /** @} */

    /** Factor by which the orifice that is seen and that which the leak
     * belongs to may differ without a warning. */
    static constexpr double orifice_factor = 3;

    explicit ValveReport(const ReportSettings &settings);

    /** Takes the sample that @p monitor has just made. */
    void
    add(const ValveSample &sample, const LeafletMonitor &monitor);

    /** All figures of the run until the last sample. */
    Summary
    summary(const ValveStructure &valve,
            const LeafletMonitor &monitor,
            const RunCost &cost,
            const std::vector<std::string> &warnings) const;

    /** The balance of energy at the last sample, as a table for people. */
    std::string
    energy_balance() const;

    /** Mean tractions over the window. */
    MeanTractions
    mean_tractions() const;

    /** What is to be said if the leak through gaps does not fit the orifice
     * that is seen, in blood of this @p density (kg/m^3); empty if it does, or
     * if the leak is that of a sealed valve. */
    std::string
    doubt_about_orifice(const double density) const;

    /** Saves or restores what has been collected. If the end of the run has
     * been changed, sums over the window at the end begin anew. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      double end_time = settings.end_time;
      archive &end_time &samples &n_in_window &contact_pressure &total_traction;
      if (end_time != settings.end_time)
        {
          n_in_window = 0;
          std::fill(contact_pressure.begin(), contact_pressure.end(), 0.);
          std::fill(total_traction.begin(), total_traction.end(), 0.);
        }
    }

  private:
    /** Mean leak over the window. */
    Leak
    leak() const;

    /** Whether the widest path is shut and the leak within its bound. */
    bool
    sealed() const;

    /** Sets whether and when the valve has closed, and the flows and volumes
     * that tell how well. */
    void
    set_volumes(Summary &result) const;

    /** Largest Reynolds number so far. */
    double
    peak_reynolds() const;

    /** Sets the smallest stretch of the run, where in the mesh and when, and
     * how many cells were distorted at a time. */
    void
    set_distortion(Summary &result) const;

    /** Flow through each plane, mean over the window, and the same without
     * what the leaflets sweep. */
    Summary
    plane_figures() const;

    /** Area (m^2) of the jet that the leak through gaps makes of blood of this
     * @p density. */
    double
    effective_area(const double density) const;

    /** What can be seen of the orifice; in blood, also what its jet tells, with
     * the @p density of the blood. */
    Summary
    orifice_figures(const double density) const;

    const ReportSettings settings;
    std::vector<ValveSample> samples;

    // Sums over the window.
    unsigned int n_in_window = 0;
    std::vector<double> contact_pressure, total_traction;
  };

  /** Where a point of the valve is, in words: "right commissure" and so on.
   * The right side is +x, the anterior one +y. */
  std::string
  place_name(const dealii::Point<3> &x);
} // namespace coapt

#endif
