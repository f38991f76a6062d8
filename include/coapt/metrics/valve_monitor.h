#ifndef coapt_metrics_valve_monitor_h
#define coapt_metrics_valve_monitor_h

#include <coapt/coupled/valve_model.h>
#include <coapt/geometry/widest_path.h>
#include <coapt/metrics/chordae_peaks.h>
#include <coapt/metrics/coaptation.h>
#include <coapt/metrics/contact_history.h>
#include <coapt/metrics/energy_audit.h>
#include <coapt/metrics/orifice.h>

#include <vector>

namespace coapt
{
  /** What a valve does at one time. SI. */
  struct ValveSample
  {
    double time                = 0;
    double pressure            = 0; // at the ventricular end
    double inflow              = 0; // at the ventricular end
    double outflow             = 0; // at the atrial end
    double swept_flow          = 0; // volume swept by the leaflets, a second
    double outflow_volume      = 0; // since the start
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
    double annulus_force       = 0; // of the tissue on its support
    double largest_velocity    = 0;
    double slip_rms            = 0;
    double hourglass_rms       = 0; // away from the leaflet
    double checkerboard_rms    = 0; // away from the leaflet
    double point_spacing       = 0; // largest, in finest fluid cells
    double mean_stress         = 0; // von Mises
    double mean_strain         = 0; // largest logarithmic
    double energy_error        = 0;
    EnergyAudit<3>::Works works;
    EnergyAudit<3>::Energies energies;
    std::array<double, ChordaePeaks::n_classes> chordae_tension{};
    std::vector<double> chorda_tension; // of each
    WidestPath path;
    Orifice orifice;
    CoaptationResult coaptation;
  };

  /**
   * Observes a valve during a run: integrates flows between outputs and
   * samples everything else at outputs. The traction of coaptation is
   * t_co = p_c + p_film: the contact pressure (impulse over every step), and
   * p_film = p_v - t_f . n with the coupling force t_f per area and the
   * pressure p_v behind the ventricular face; fluid that is trapped between
   * the leaflets below the resolution carries load in the place of contact,
   * and only the sum is independent of the mesh.
   */
  class ValveMonitor
  {
  public:
    explicit ValveMonitor(ValveModel &model);

    /** Integrates the flows; call every few steps. Collective. */
    void
    accumulate(const double t, const double *y);

    /** Tells that the mesh has been re-adapted, from energies @p before. */
    void
    note_adaptation(const double energy_before, const double *y);

    /** Stored energy (J). Collective. */
    double
    stored_energy(const double *y) const;

    /** All quantities at time @p t; tractions are means since the last
     * sample. Collective. */
    ValveSample
    sample(const double t, const double *y);

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

    /** Measures the belt of coaptation. */
    const Coaptation &
    coaptation() const
    {
      return belt;
    }

    /** Von Mises stress (Pa) and largest logarithmic strain of each cell of the
     * solid at the last sample. @{ */
    const std::vector<double> &
    cell_stress() const
    {
      return stress;
    }

    const std::vector<double> &
    cell_strain() const
    {
      return strain;
    }
    /** @} */

    /** Bulging volume of the parts of the leaflet, by Region (m^3). */
    std::array<double, 4>
    bulging_by_region() const;

    /** Largest tension of a chorda in each class so far. */
    const ChordaePeaks &
    chordae_peaks() const
    {
      return peaks;
    }

    /** Largest flow out at the atrial end so far (m^3/s). */
    double
    peak_outflow() const
    {
      return largest_outflow;
    }

    /** Evaluates coaptation from given mean tractions of the columns. */
    CoaptationResult
    coaptation(const std::vector<double> &contact_pressure,
               const std::vector<double> &total_traction) const;

  private:
    void
    measure_tractions(const double *y, const std::vector<double> &X);

    std::vector<double>
    ventricular_pressure(const double *y, const std::vector<double> &X) const;

    void
    measure_flow(const std::vector<double> &u,
                 const std::vector<dealii::Tensor<1, 3>> &velocities,
                 ValveSample &sample) const;

    void
    measure_support(const std::vector<double> &X,
                    const std::vector<double> &V,
                    ValveSample &sample) const;

    /** Velocity of the mid-surface, by column. */
    std::vector<dealii::Tensor<1, 3>>
    mid_velocities(const double *y) const;

    std::vector<dealii::Point<3>>
    annulus() const;

    void
    measure_noise(const double *y, ValveSample &sample) const;

    void
    measure_solid(const double t,
                  const std::vector<double> &X,
                  const std::vector<double> &V,
                  ValveSample &sample);

    ValveModel &model;
    EnergyAudit<3> audit;
    ChordaePeaks peaks;
    Coaptation belt;
    ContactHistory history;
    std::vector<std::array<unsigned int, 3>> outer_faces; // of the mesh

    bool started           = false;
    double last_time       = 0;
    double last_outflow    = 0;
    double outflow_volume  = 0;
    double total_swept     = 0;
    double largest_outflow = 0;
    std::vector<dealii::Point<3>> surface_points;

    std::vector<double> column_contact_pressure;
    std::vector<double> column_traction;
    std::vector<double> stress, strain;
  };
} // namespace coapt

#endif
