#ifndef coapt_metrics_leaflet_monitor_h
#define coapt_metrics_leaflet_monitor_h

#include <coapt/coupled/valve_structure.h>
#include <coapt/geometry/widest_path.h>
#include <coapt/metrics/chordae_peaks.h>
#include <coapt/metrics/coaptation.h>
#include <coapt/metrics/contact_history.h>
#include <coapt/metrics/energy_audit.h>
#include <coapt/metrics/orifice.h>
#include <coapt/metrics/past_edge.h>
#include <coapt/solid/cell_results.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace coapt
{
  /** What a valve does at one time. SI. What concerns the blood is zero in a
   * valve without fluid. */
  struct ValveSample
  {
    double time                = 0;
    double pressure            = 0; // at the ventricular end
    double inflow              = 0; // at the ventricular end
    double outflow             = 0; // at the atrial end
    double swept_flow          = 0; // volume swept by the leaflets, a second
    double peak_outflow        = 0; // since the start
    double outflow_volume      = 0; // since the start
    double drained_volume      = 0; // from films, since the start
    double swept_volume        = 0; // since the start
    double contact_force       = 0;
    double coaptation_force    = 0; // contact and film
    double coaptation_area     = 0;
    double coaptation_pressure = 0; // largest, filtered
    double min_gap             = 0;
    double path_width          = 0; // widest way, clearance counts as shut
    double path_gap            = 0; // the same between the surfaces
    double bulging_volume      = 0;
    double tissue_flow         = 0; // through tissue that is not apposed
    double reynolds            = 0; // of the flow through the annulus
    double displacement        = 0; // largest of the leaflet
    double largest_velocity    = 0;
    double slip_rms            = 0;
    double hourglass_rms       = 0;     // away from the leaflet
    double checkerboard_rms    = 0;     // away from the leaflet
    double point_spacing       = 0;     // largest, in finest fluid cells
    double mean_stress         = 0;     // von Mises
    double mean_principal      = 0;     // largest principal stress
    double mean_strain         = 0;     // largest logarithmic
    double smallest_stretch    = 1;     // of all cells, relative to the mesh
    double distorted_cells     = 0;     // below Solid/Distortion threshold
    double energy_error        = 0;     // relative
    double closure_error       = 0;     // the same in J
    dealii::Point<3> crushed_place;     // of the smallest stretch, in the mesh
    dealii::Tensor<1, 3> annulus_force; // of leaflet and load on its support
    EnergyAudit<3>::Works works;
    EnergyAudit<3>::Energies energies;
    std::array<double, ChordaePeaks::n_classes> chordae_tension{};
    std::vector<double> chorda_tension;              // of each
    std::vector<double> plane_flow;                  // along each normal
    std::map<std::string, double> held_displacement; // largest, by set
    WidestPath path;
    Orifice orifice;
    CoaptationResult coaptation;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &pressure &inflow &outflow;
      archive &swept_flow &peak_outflow &outflow_volume &drained_volume;
      archive &swept_volume &contact_force &coaptation_force &coaptation_area;
      archive &coaptation_pressure &min_gap &path_width &path_gap;
      archive &bulging_volume &tissue_flow &reynolds &displacement;
      archive &largest_velocity &slip_rms &hourglass_rms &checkerboard_rms;
      archive &point_spacing &mean_stress &mean_principal &mean_strain;
      archive &smallest_stretch &distorted_cells &energy_error &closure_error;
      archive &crushed_place &annulus_force &works &energies;
      archive &chordae_tension &chorda_tension &plane_flow &held_displacement;
      archive &path &orifice &coaptation;
    }
  };

  /**
   * Observes the leaflets and chordae of a valve, with or without blood around
   * them: what can be said from positions, velocities and contact alone.
   */
  class LeafletMonitor
  {
  public:
    /** Paths through the valve are looked for up to the width @p widest (m)
     * between the surfaces. */
    LeafletMonitor(ValveStructure &valve,
                   const CoaptationSettings &settings,
                   const double widest);

    virtual ~LeafletMonitor() = default;

    /** Contact pressure and total traction of each column, means since the
     * sample before the last (Pa). @{ */
    const std::vector<double> &
    contact_pressure() const
    {
      return column_contact_pressure;
    }

    const std::vector<double> &
    total_traction() const
    {
      return column_traction;
    }
    /** @} */

    /** When the columns have touched first, and how far they have slid. */
    const ContactHistory &
    contact_history() const
    {
      return history;
    }

    /** Mid-surface at the last sample, by column (m). */
    const std::vector<dealii::Point<3>> &
    mid_surface() const
    {
      return surface_points;
    }

    /** Gap of each column to what it faces, now (m), with the crests of folds
     * that are shut. */
    std::vector<double>
    gaps() const;

    /** The same for coaptation: MidSurfaceContact::no_gap where a column hangs
     * past the edge of what it faces. */
    std::vector<double>
    coaptation_gaps() const;

    /** Measures the belt of coaptation. */
    const Coaptation &
    coaptation() const
    {
      return belt;
    }

    /** Stress and strain of each cell of the solid at the last sample. */
    const CellResults &
    cell_results() const
    {
      return cells;
    }

    /** Bulging volume of the parts of the leaflet, by Region (m^3). */
    std::array<double, n_regions>
    bulging_by_region() const;

    /** Bulging as the reference work measures it (bulging_by_distance(),
     * m^3). */
    double
    bulging_by_distance() const;

    /** Largest tension of a chorda in each class so far. */
    const ChordaePeaks &
    chordae_peaks() const
    {
      return peaks;
    }

    /** Evaluates coaptation from given mean tractions of the columns. */
    CoaptationResult
    coaptation(const std::vector<double> &contact_pressure,
               const std::vector<double> &total_traction) const;

    /** Saves or restores what has been so far. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &peaks &total_swept &surface_points &column_contact_pressure;
      archive &column_traction &history &cells;
    }

  protected:
    /** Adds what the leaflets have swept since the last call, takes the
     * chordae's peaks, and follows contact. */
    void
    accumulate_motion(const double t,
                      const std::vector<double> &X,
                      const std::vector<double> &V);

    /** Shape, stress and chordae under the @p load (N, nodal triples); after
     * accumulate_motion() of the same positions. Collective. */
    void
    measure_solid(const double t,
                  const std::vector<double> &X,
                  const std::vector<double> &V,
                  const std::vector<double> &load,
                  ValveSample &sample);

    /** Velocity of the mid-surface for the nodal velocities @p V, by column. */
    std::vector<dealii::Tensor<1, 3>>
    mid_velocities(const std::vector<double> &V) const;

    /** Coaptation from the tractions of the columns. */
    void
    measure_coaptation(ValveSample &sample) const;

    ChordaePeaks peaks;
    double total_swept = 0;

    /** Mid-surface of the last call of accumulate_motion(), if any. */
    std::vector<dealii::Point<3>> surface_points;

    std::vector<double> column_contact_pressure;
    std::vector<double> column_traction;

  private:
    WidestPath
    find_widest_path() const;

    std::vector<dealii::Point<3>>
    annulus() const;

    /** Whether a point is in the lumen: in the tube, or for an imported valve
     * within the annulus. */
    std::function<bool(const dealii::Point<3> &)>
    in_lumen() const;

    /** Smallest stretch, where it is, and the number of distorted cells. */
    void
    measure_distortion(ValveSample &sample) const;

    /** Largest displacement of the leaflet, and of each set of held nodes. */
    void
    measure_displacements(const std::vector<double> &X,
                          ValveSample &sample) const;

    /** Force of the tissue and its @p load on the support. */
    dealii::Tensor<1, 3>
    annulus_force(const std::vector<double> &X,
                  const std::vector<double> &V,
                  const std::vector<double> &load) const;

    const ValveStructure &valve;
    const Coaptation belt;
    const PastEdge past_edge;
    ContactHistory history;
    std::vector<std::array<unsigned int, 3>> outer_faces; // of the mesh
    CellResults cells;
    const double widest;
  };
} // namespace coapt

#endif
