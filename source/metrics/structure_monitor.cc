#include <coapt/metrics/structure_monitor.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  namespace
  {
    CoaptationSettings
    settings_for(const ModelParameters &parameters)
    {
      CoaptationSettings settings;
      settings.gap_limit =
        std::max(settings.gap_limit, parameters.contact.clearance);
      return settings;
    }

    /** One half of a state. @{ */
    std::vector<double>
    positions(const std::vector<double> &state)
    {
      return std::vector<double>(state.begin(),
                                 state.begin() + state.size() / 2);
    }

    std::vector<double>
    velocities(const std::vector<double> &state)
    {
      return std::vector<double>(state.begin() + state.size() / 2, state.end());
    }
    /** @} */
  } // namespace



  StructureMonitor::StructureMonitor(ValveStructure &valve,
                                     const StructureSystem &system)
    : LeafletMonitor(valve,
                     settings_for(valve.parameters),
                     2e-3 + valve.parameters.contact.clearance)
    , valve(valve)
    , system(system)
  {
  }



  EnergyAudit<3>::Energies
  StructureMonitor::energies(const std::vector<double> &X,
                             const std::vector<double> &V) const
  {
    EnergyAudit<3>::Energies energies;
    energies.solid_kinetic = valve.solid->kinetic_energy(V.data());
    energies.elastic       = valve.solid->elastic_energy(X.data());
    return energies;
  }



  void
  StructureMonitor::accumulate(const double t, const std::vector<double> &state)
  {
    const auto X = positions(state), V = velocities(state);
    const auto now = system.powers(t, X.data(), V.data());
    if (last_time < 0)
      initial_energy = energies(X, V).total();
    else
      {
        const double half = 0.5 * (t - last_time);
        works.ends += half * (last.load + now.load);
        works.loads += half * (last.chordae + now.chordae);
        works.solid_losses += half * (last.damping + now.damping);
        works.motion = system.work_of_motion();
        largest_work =
          std::max(largest_work, std::abs(works.ends + works.motion));
      }
    works.contact = system.contact_work();
    accumulate_motion(t, X, V);
    last      = now;
    last_time = t;
  }



  void
  StructureMonitor::measure_tractions()
  {
    const double window = valve.contact->accumulated_time();
    const auto &impulse = valve.contact->state().pressure_impulse;
    for (unsigned int c = 0; c < impulse.size(); ++c)
      column_contact_pressure[c] = window > 0 ? impulse[c] / window : 0.;
    column_traction = column_contact_pressure;
    valve.contact->clear_accumulators();
  }



  ValveSample
  StructureMonitor::sample(const double t, const std::vector<double> &state)
  {
    if (t > last_time)
      accumulate(t, state);
    const auto X = positions(state), V = velocities(state);
    ValveSample sample;
    sample.time     = t;
    sample.pressure = valve.ventricular_pressure(t);
    measure_solid(t, X, V, system.load(t, X.data()), sample);
    measure_tractions();
    measure_coaptation(sample);

    for (unsigned int i = 0; i < V.size(); i += 3)
      sample.largest_velocity =
        std::max(sample.largest_velocity, std::hypot(V[i], V[i + 1], V[i + 2]));
    sample.works    = works;
    sample.energies = energies(X, V);
    sample.closure_error =
      works.input() - works.losses() - sample.energies.total() + initial_energy;
    if (largest_work > 0)
      sample.energy_error = std::abs(sample.closure_error) / largest_work;
    return sample;
  }
} // namespace coapt
