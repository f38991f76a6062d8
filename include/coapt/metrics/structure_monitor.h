#ifndef coapt_metrics_structure_monitor_h
#define coapt_metrics_structure_monitor_h

#include <coapt/metrics/leaflet_monitor.h>
#include <coapt/structure/structure_system.h>

#include <vector>

namespace coapt
{
  /**
   * Observes a valve without fluid: contact alone carries coaptation, and the
   * work of the load is balanced with energies and losses. States hold the
   * positions of all nodes, then their velocities.
   */
  class StructureMonitor : public LeafletMonitor
  {
  public:
    StructureMonitor(ValveStructure &valve, const StructureSystem &system);

    /** Integrates works and what the leaflets sweep; call every few steps.
     * Collective. */
    void
    accumulate(const double t, const std::vector<double> &state);

    /** All quantities at time @p t; tractions are means since the last
     * sample. Collective. */
    ValveSample
    sample(const double t, const std::vector<double> &state);

  private:
    void
    measure_tractions();

    /** Energies stored at the positions @p X with the velocities @p V. */
    EnergyAudit<3>::Energies
    energies(const std::vector<double> &X, const std::vector<double> &V) const;

    ValveStructure &valve;
    const StructureSystem &system;
    EnergyAudit<3>::Works works;
    StructureSystem::Powers last;
    double initial_energy = 0;
    double largest_work   = 0;
    double last_time      = -1; // before the start
  };
} // namespace coapt

#endif
