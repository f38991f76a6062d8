#include <coapt/base/units.h>
#include <coapt/io/closure_figures.h>
#include <coapt/metrics/distribution.h>
#include <coapt/metrics/region_volumes.h>

#include <algorithm>

namespace coapt
{
  using namespace units;

  namespace
  {
    const std::array<std::string, 2> leaflet_names = {
      {"anterior", "posterior"}};
  } // namespace



  Summary
  segment_figures(const ValveStructure &valve,
                  const LeafletMonitor &monitor,
                  const MeanTractions &tractions)
  {
    const auto &state  = valve.contact->state();
    const auto profile = monitor.coaptation().profile(monitor.coaptation_gaps(),
                                                      tractions.total,
                                                      state.current_area,
                                                      monitor.mid_surface());
    Summary result;
    for (unsigned int leaflet = 0; leaflet < 2; ++leaflet)
      for (const SegmentCoaptation &segment :
           coaptation_by_segment(profile[leaflet], leaflet == 0 ? 'A' : 'P'))
        {
          Summary figures;
          figures.set("contact_height_mm", segment.contact_height / millimetre);
          figures.set("contact_height_min_mm",
                      segment.min_contact_height / millimetre);
          figures.set("apposition_mm", segment.apposition / millimetre);
          result.set(segment.name, figures);
        }
    return result;
  }



  Summary
  gap_figures(const ValveStructure &valve,
              const LeafletMonitor &monitor,
              const MeanTractions &tractions)
  {
    const auto &state = valve.contact->state();
    const auto gaps   = monitor.coaptation().gaps(monitor.coaptation_gaps(),
                                                tractions.total,
                                                state.current_area,
                                                monitor.mid_surface());
    Summary result;
    result.set("number", unsigned(gaps[0].size() + gaps[1].size()));
    unsigned int n = 0;
    for (unsigned int leaflet = 0; leaflet < 2; ++leaflet)
      for (const BeltGap &gap : gaps[leaflet])
        {
          Summary figures;
          figures.set("leaflet", leaflet_names[leaflet]);
          figures.set("position_mm", gap.position / millimetre);
          figures.set("length_mm", gap.length / millimetre);
          figures.set("x_mm", gap.place[0] / millimetre);
          figures.set("y_mm", gap.place[1] / millimetre);
          figures.set("z_mm", gap.place[2] / millimetre);
          result.set("gap_" + std::to_string(++n), figures);
        }
    return result;
  }



  Summary
  region_figures(const ValveStructure &valve, const LeafletMonitor &monitor)
  {
    const std::array<std::string, n_regions> names = {
      {"anterior", "posterior", "commissures", "root", "septal"}};
    const auto bulging = monitor.bulging_by_region();
    Summary result;
    for (unsigned int region = 0; region < names.size(); ++region)
      {
        const std::vector<double> weights =
          volumes_in_region(valve.leaflet,
                            static_cast<Region>(region),
                            valve.solid->cell_volumes());
        if (std::all_of(weights.begin(), weights.end(), [](const double w) {
              return w == 0;
            }))
          continue; // the valve has no such part
        const CellResults &cells = monitor.cell_results();
        Summary figures;
        figures.set("bulging_volume_mL", bulging[region] / millilitre);
        figures.set("stress_mean_kPa",
                    weighted_mean(cells.von_mises, weights) / kilopascal);
        figures.set("stress_95_percent_kPa",
                    weighted_quantile(cells.von_mises, weights, 0.95) /
                      kilopascal);
        figures.set("principal_stress_mean_kPa",
                    weighted_mean(cells.principal_stress, weights) /
                      kilopascal);
        figures.set("principal_stress_95_percent_kPa",
                    weighted_quantile(cells.principal_stress, weights, 0.95) /
                      kilopascal);
        figures.set("strain_mean",
                    weighted_mean(cells.largest_strain, weights));
        figures.set("strain_95_percent",
                    weighted_quantile(cells.largest_strain, weights, 0.95));
        result.set(names[region], figures);
      }
    return result;
  }
} // namespace coapt
