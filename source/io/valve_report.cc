#include <coapt/base/units.h>
#include <coapt/io/valve_report.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  using namespace units;

  std::vector<Statistics::Entry>
  statistics_row(const ValveSample &s, const RunCost &cost, const bool in_blood)
  {
    std::vector<Statistics::Entry> row = {{"time_s", s.time},
                                          {"step_s", cost.step_length},
                                          {"ventricular_pressure_Pa",
                                           s.pressure}};
    const auto add = [&row](const std::vector<Statistics::Entry> &entries) {
      row.insert(row.end(), entries.begin(), entries.end());
    };
    if (in_blood)
      add({{"inflow_mL_per_s", s.inflow / millilitre},
           {"outflow_mL_per_s", s.outflow / millilitre}});
    add({{"swept_flow_mL_per_s", s.swept_flow / millilitre}});
    if (in_blood)
      add({{"outflow_volume_mL", s.outflow_volume / millilitre}});
    add({{"swept_volume_mL", s.swept_volume / millilitre},
         {"coaptation_force_N", s.coaptation_force},
         {"contact_force_N", s.contact_force},
         {"coaptation_area_mm2", s.coaptation_area / square_millimetre},
         {"coaptation_pressure_max_kPa", s.coaptation_pressure / kilopascal},
         {"gap_min_mm", s.min_gap / millimetre},
         {"widest_path_mm", s.path_width / millimetre},
         {"widest_path_gap_mm", s.path_gap / millimetre},
         {"bulging_volume_mL", s.bulging_volume / millilitre}});
    for (unsigned int c = 0; c < s.chordae_tension.size(); ++c)
      row.emplace_back("chordae_" + name_of(static_cast<ChordaClass>(c)) + "_N",
                       s.chordae_tension[c]);
    add({{"stress_mean_kPa", s.mean_stress / kilopascal},
         {"strain_mean", s.mean_strain},
         {"velocity_max_m_per_s", s.largest_velocity}});
    if (in_blood)
      add({{"slip_rms_m_per_s", s.slip_rms},
           {"hourglass_rms_m_per_s", s.hourglass_rms},
           {"checkerboard_rms_Pa", s.checkerboard_rms},
           {"point_spacing_cells", s.point_spacing}});
    if (in_blood)
      add(EnergyAudit<3>::entries(s.works, s.energies));
    else
      add({{"work_of_load_J", s.works.ends},
           {"work_of_chordae_J", s.works.loads},
           {"work_of_contact_J", s.works.contact},
           {"losses_J", s.works.solid_losses},
           {"energy_kinetic_J", s.energies.solid_kinetic},
           {"energy_elastic_J", s.energies.elastic}});
    add({{"energy_error_relative", s.energy_error}});
    if (in_blood)
      add({{"fluid_cells", double(cost.fluid_cells)}});
    add({{"steps", double(cost.steps)}});
    return row;
  }



  std::string
  place_name(const dealii::Point<3> &x)
  {
    const double middle = 6 * millimetre, end = 10 * millimetre;
    const std::string side = x[0] > 0 ? "right" : "left";
    if (std::abs(x[0]) > end)
      return side + " commissure";
    if (std::abs(x[0]) > middle)
      return side + " third of the coaptation line";
    return "middle of the coaptation line";
  }



  ValveReport::ValveReport(const ReportSettings &settings) : settings(settings)
  {
  }



  void
  ValveReport::add(const ValveSample &sample, const LeafletMonitor &monitor)
  {
    samples.push_back(sample);
    if (sample.time < settings.end_time - window)
      return;
    const std::vector<double> &contact = monitor.contact_pressure();
    const std::vector<double> &total   = monitor.total_traction();
    contact_pressure.resize(contact.size(), 0.);
    total_traction.resize(total.size(), 0.);
    for (unsigned int c = 0; c < contact.size(); ++c)
      {
        contact_pressure[c] += contact[c];
        total_traction[c] += total[c];
      }
    ++n_in_window;
  }



  ValveReport::Closing
  ValveReport::closing() const
  {
    Closing result;
    for (const ValveSample &sample : samples)
      if (sample.path_width >= settings.shut_width)
        result.closed = false;
      else if (!result.closed)
        {
          result.closed = true;
          result.time   = sample.time;
          result.volume = sample.outflow_volume;
        }
    return result;
  }



  double
  ValveReport::leak() const
  {
    const ValveSample &last  = samples.back();
    const ValveSample *first = &samples.front();
    for (const ValveSample &sample : samples)
      if (sample.time <= last.time - window * (1 - 1e-6))
        first = &sample;
    if (!(first->time < last.time))
      return std::numeric_limits<double>::quiet_NaN();
    return ((last.outflow_volume - first->outflow_volume) -
            (last.swept_volume - first->swept_volume)) /
      (last.time - first->time);
  }



  Summary
  ValveReport::summary(const LeafletMonitor &monitor,
                       const RunCost &cost,
                       const std::vector<std::string> &warnings) const
  {
    const ValveSample &last = samples.back();
    const Closing shut      = closing();
    const double none       = std::numeric_limits<double>::quiet_NaN();

    std::vector<double> contact = contact_pressure, total = total_traction;
    contact.resize(monitor.contact_pressure().size(), 0.);
    total.resize(contact.size(), 0.);
    for (unsigned int c = 0; c < contact.size(); ++c)
      {
        contact[c] /= std::max(1u, n_in_window);
        total[c] /= std::max(1u, n_in_window);
      }
    const CoaptationResult belt = monitor.coaptation(contact, total);

    Summary result;
    result.set("sealed",
               shut.closed && (!settings.in_blood || leak() <= largest_leak));
    result.set("closing_time_s", shut.closed ? shut.time : none);
    if (settings.in_blood)
      {
        result.set("leak_mL_per_s", leak() / millilitre);
        result.set("flow_peak_mL_per_s", last.peak_outflow / millilitre);
        result.set("closing_volume_mL",
                   shut.closed ? shut.volume / millilitre : none);
      }
    result.set("bulging_volume_mL", last.bulging_volume / millilitre);
    result.set("coaptation_area_mm2", belt.area / square_millimetre);
    result.set("coaptation_force_N", belt.force);
    result.set("contact_force_N", belt.contact_force);
    result.set("contact_fraction", belt.contact_fraction);
    result.set("coaptation_pressure_max_kPa", belt.max_traction / kilopascal);
    result.set("coaptation_belt_continuous", belt.continuous);
    result.set("coaptation_belt_longest_gap_elements", belt.longest_gap);
    result.set("coaptation_height_anterior_mm",
               belt.anterior.mean_height / millimetre);
    result.set("coaptation_height_posterior_mm",
               belt.posterior.mean_height / millimetre);

    Summary path;
    path.set("width_mm", last.path_width / millimetre);
    path.set("gap_mm", last.path_gap / millimetre);
    path.set("place", place_name(last.path.position));
    path.set("x_mm", last.path.position[0] / millimetre);
    path.set("y_mm", last.path.position[1] / millimetre);
    path.set("z_mm", last.path.position[2] / millimetre);
    result.set("widest_path", path);

    Summary chordae;
    for (unsigned int c = 0; c < ChordaePeaks::n_classes; ++c)
      chordae.set(
        name_of(static_cast<ChordaClass>(c)),
        monitor.chordae_peaks().peak(static_cast<ChordaClass>(c)).tension);
    result.set("chordae_peak_N", chordae);

    result.set("stress_mean_kPa", last.mean_stress / kilopascal);
    result.set("strain_mean", last.mean_strain);
    result.set("end_time_s", last.time);
    if (settings.in_blood)
      result.set("fluid_cells", cost.fluid_cells);
    result.set("solid_tets", cost.solid_tets);
    if (settings.in_blood)
      result.set("coupling_points", cost.coupling_points);
    result.set("steps", cost.steps);
    result.set("rhs_evaluations", cost.evaluations);
    result.set("wall_s", cost.wall_seconds);
    result.set("core_hours", cost.wall_seconds * cost.ranks / 3600);
    result.set("energy_error_relative", last.energy_error);
    result.set("warnings", warnings);
    return result;
  }
} // namespace coapt
