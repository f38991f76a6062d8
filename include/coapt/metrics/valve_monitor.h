#ifndef coapt_metrics_valve_monitor_h
#define coapt_metrics_valve_monitor_h

#include <coapt/coupled/valve_model.h>
#include <coapt/metrics/leaflet_monitor.h>
#include <coapt/metrics/plane_flux.h>

#include <vector>

namespace coapt
{
  /**
   * Observes a valve in blood during a run: integrates flows between outputs
   * and samples everything else at outputs. Tractions of coaptation
   * (coaptation_traction) are those of contact and film: fluid that is trapped
   * between the leaflets below the resolution carries load in the place of
   * contact, and only the sum is independent of the mesh.
   */
  class ValveMonitor : public LeafletMonitor
  {
  public:
    /** Measures the flow through @p planes, too. */
    ValveMonitor(ValveModel &model, const std::vector<Plane> &planes);

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

    /** Force of the blood on each column over its reference area, mean over
     * the window that the last sample ended (Pa), and that window's length
     * (s). @{ */
    const std::vector<dealii::Tensor<1, 3>> &
    surface_load() const
    {
      return column_load;
    }

    double
    load_window() const
    {
      return window;
    }
    /** @} */

    /** Saves or restores what has been so far. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int version)
    {
      LeafletMonitor::serialize(archive, version);
      archive &audit &started &last_time &last_outflow &outflow_volume;
      archive &largest_outflow &window &column_load;
    }

  private:
    /** Load of the blood on all nodes (N, triples), the mean since the last
     * sample; begins the next window. Collective. */
    std::vector<double>
    mean_load();

    void
    measure_tractions(const double *y,
                      const std::vector<double> &X,
                      const std::vector<double> &load);

    std::vector<double>
    ventricular_pressure(const double *y, const std::vector<double> &X) const;

    void
    measure_flow(const std::vector<double> &u,
                 const std::vector<dealii::Tensor<1, 3>> &velocities,
                 ValveSample &sample) const;

    void
    measure_noise(const double *y, ValveSample &sample) const;

    ValveModel &model;
    const std::vector<Plane> planes;
    EnergyAudit<3> audit;

    bool started           = false;
    double last_time       = 0;
    double last_outflow    = 0;
    double outflow_volume  = 0;
    double largest_outflow = 0;

    double window = 0;
    std::vector<dealii::Tensor<1, 3>> column_load;
  };
} // namespace coapt

#endif
