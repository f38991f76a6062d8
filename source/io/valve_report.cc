#include <coapt/base/units.h>
#include <coapt/io/closure_figures.h>
#include <coapt/io/energy_table.h>
#include <coapt/io/valve_report.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace coapt
{
  using namespace units;

  std::vector<Statistics::Entry>
  energy_books(const ValveSample &s, const bool in_blood)
  {
    std::vector<Statistics::Entry> books;
    if (in_blood)
      books = EnergyAudit<3>::entries(s.works, s.energies);
    else
      books = {{"work_of_load_J", s.works.ends},
               {"work_of_chordae_J", s.works.loads},
               {"work_of_contact_J", s.works.contact},
               {"work_of_motion_J", s.works.motion},
               {"losses_J", s.works.solid_losses},
               {"energy_kinetic_J", s.energies.solid_kinetic},
               {"energy_elastic_J", s.energies.elastic}};
    books.emplace_back("closure_error_J", s.closure_error);
    return books;
  }



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
      add({{"outflow_volume_mL", s.outflow_volume / millilitre},
           {"drained_volume_mL", s.drained_volume / millilitre}});
    add({{"swept_volume_mL", s.swept_volume / millilitre},
         {"coaptation_force_N", s.coaptation_force},
         {"contact_force_N", s.contact_force},
         {"coaptation_area_mm2", s.coaptation_area / square_millimetre},
         {"coaptation_pressure_max_kPa", s.coaptation_pressure / kilopascal},
         {"gap_min_mm", s.min_gap / millimetre},
         {"widest_path_mm", s.path_width / millimetre},
         {"widest_path_gap_mm", s.path_gap / millimetre},
         {"bulging_volume_mL", s.bulging_volume / millilitre},
         {"orifice_area_mm2", s.orifice.area / square_millimetre},
         {"orifice_disc_mm", s.orifice.disc / millimetre},
         {"annulus_force_N", s.annulus_force.norm()},
         {"annulus_force_x_N", s.annulus_force[0]},
         {"annulus_force_y_N", s.annulus_force[1]},
         {"annulus_force_z_N", s.annulus_force[2]},
         {"largest_displacement_mm", s.displacement / millimetre}});
    if (in_blood)
      add({{"tissue_flow_mL_per_s", s.tissue_flow / millilitre},
           {"reynolds", s.reynolds}});
    for (unsigned int i = 0; i < s.plane_flow.size(); ++i)
      {
        const std::string plane = "plane_" + std::to_string(i + 1);
        add({{plane + "_flow_mL_per_s", s.plane_flow[i] / millilitre},
             {plane + "_flow_less_swept_mL_per_s",
              plane_flow_less_swept(s, i) / millilitre}});
      }
    for (unsigned int c = 0; c < s.chordae_tension.size(); ++c)
      row.emplace_back("chordae_" + name_of(static_cast<ChordaClass>(c)) + "_N",
                       s.chordae_tension[c]);
    add({{"stress_mean_kPa", s.mean_stress / kilopascal},
         {"principal_stress_mean_kPa", s.mean_principal / kilopascal},
         {"strain_mean", s.mean_strain},
         {"smallest_stretch", s.smallest_stretch},
         {"distorted_cells", s.distorted_cells},
         {"velocity_max_m_per_s", s.largest_velocity}});
    if (in_blood)
      add({{"slip_rms_m_per_s", s.slip_rms},
           {"hourglass_rms_m_per_s", s.hourglass_rms},
           {"checkerboard_rms_Pa", s.checkerboard_rms},
           {"point_spacing_cells", s.point_spacing}});
    add(energy_books(s, in_blood));
    add({{"energy_error_relative", s.energy_error}});
    if (in_blood)
      add({{"fluid_cells", double(cost.fluid_cells)}});
    add({{"steps", double(cost.steps)}});
    return row;
  }



  std::vector<Statistics::Entry>
  chordae_row(const ValveSample &sample, const std::vector<Chorda> &chordae)
  {
    std::vector<Statistics::Entry> row = {{"time_s", sample.time}};
    for (unsigned int i = 0; i < chordae.size(); ++i)
      row.emplace_back(chordae[i].id + "_N", sample.chorda_tension[i]);
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
    const std::vector<double> &contact = monitor.contact_pressure();
    const std::vector<double> &total   = monitor.total_traction();
    contact_pressure.resize(contact.size(), 0.);
    total_traction.resize(total.size(), 0.);
    // Tractions are means since the sample before.
    const double begin = std::max(settings.end_time - window, 0.);
    if (sample.time <= (1 + 1e-12) * begin)
      return;
    for (unsigned int c = 0; c < contact.size(); ++c)
      {
        contact_pressure[c] += contact[c];
        total_traction[c] += total[c];
      }
    ++n_in_window;
  }



  Leak
  ValveReport::leak() const
  {
    return mean_leak(samples, window);
  }



  bool
  ValveReport::sealed() const
  {
    return closing(samples, settings.shut_width).closed &&
      (!settings.in_blood || leak().total() <= largest_leak);
  }



  void
  ValveReport::set_volumes(Summary &result) const
  {
    const Closing shut      = closing(samples, settings.shut_width);
    const double none       = std::numeric_limits<double>::quiet_NaN();
    const ValveSample &last = samples.back();

    result.set("sealed", sealed());
    result.set("closing_time_s", shut.closed ? shut.time : none);
    if (!settings.in_blood)
      return;
    const Leak flow = leak();
    result.set("leak_mL_per_s", flow.total() / millilitre);
    result.set("leak_through_gaps_mL_per_s", flow.gaps / millilitre);
    result.set("leak_through_tissue_mL_per_s", flow.tissue / millilitre);
    result.set("leak_drained_mL_per_s", flow.drained / millilitre);
    result.set("regurgitant_volume_mL",
               regurgitant_volume(samples, shut) / millilitre);
    result.set("flow_peak_mL_per_s", last.peak_outflow / millilitre);
    result.set("closing_volume_mL",
               shut.closed ? shut.volume / millilitre : none);
  }



  double
  ValveReport::peak_reynolds() const
  {
    return std::max_element(samples.begin(),
                            samples.end(),
                            [](const auto &a, const auto &b) {
                              return a.reynolds < b.reynolds;
                            })
      ->reynolds;
  }



  void
  ValveReport::set_distortion(Summary &result) const
  {
    const ValveSample &crushed =
      *std::min_element(samples.begin(),
                        samples.end(),
                        [](const auto &a, const auto &b) {
                          return a.smallest_stretch < b.smallest_stretch;
                        });
    double most = 0;
    for (const ValveSample &sample : samples)
      most = std::max(most, sample.distorted_cells);
    Summary place;
    place.set("time_s", crushed.time);
    place.set("x_mm", crushed.crushed_place[0] / millimetre);
    place.set("y_mm", crushed.crushed_place[1] / millimetre);
    place.set("z_mm", crushed.crushed_place[2] / millimetre);
    result.set("smallest_stretch", crushed.smallest_stretch);
    result.set("smallest_stretch_in_mesh", place);
    result.set("distorted_cells_largest_number", most);
  }



  std::string
  ValveReport::energy_balance() const
  {
    return energy_table(energy_books(samples.back(), settings.in_blood),
                        samples.back().energy_error);
  }



  MeanTractions
  ValveReport::mean_tractions() const
  {
    MeanTractions result{contact_pressure, total_traction};
    for (unsigned int c = 0; c < result.total.size(); ++c)
      {
        result.contact[c] /= std::max(1u, n_in_window);
        result.total[c] /= std::max(1u, n_in_window);
      }
    return result;
  }



  double
  ValveReport::effective_area(const double density) const
  {
    return effective_orifice_area(leak().gaps,
                                  samples.back().pressure,
                                  density);
  }



  Summary
  ValveReport::orifice_figures(const double density) const
  {
    const Orifice &seen = samples.back().orifice;
    Summary result;
    result.set("seen_area_mm2", seen.area / square_millimetre);
    result.set("largest_disc_mm", seen.disc / millimetre);
    result.set("x_mm", seen.center[0] / millimetre);
    result.set("y_mm", seen.center[1] / millimetre);
    if (!settings.in_blood)
      return result;
    const double effective = effective_area(density);
    result.set("effective_area_mm2", effective / square_millimetre);
    result.set("effective_over_seen_area", effective / seen.area);
    return result;
  }



  Summary
  ValveReport::plane_figures() const
  {
    Summary result;
    for (unsigned int i = 0; i < samples.back().plane_flow.size(); ++i)
      {
        const auto flow = [i](const ValveSample &sample) {
          return sample.plane_flow[i];
        };
        const auto less_swept = [i](const ValveSample &sample) {
          return plane_flow_less_swept(sample, i);
        };
        Summary figures;
        figures.set("flow_mL_per_s",
                    window_mean(samples, window, flow) / millilitre);
        figures.set("flow_less_swept_mL_per_s",
                    window_mean(samples, window, less_swept) / millilitre);
        result.set("plane_" + std::to_string(i + 1), figures);
      }
    return result;
  }



  std::string
  ValveReport::doubt_about_orifice(const double density) const
  {
    if (!settings.in_blood || !(leak().gaps > largest_leak))
      return "";
    const double seen = samples.back().orifice.area,
                 jet  = effective_area(density);
    if (orifices_agree(seen, jet, orifice_factor))
      return "";
    char text[200];
    std::snprintf(text,
                  sizeof(text),
                  "the leak through gaps, %.3g mL/s, belongs to an orifice of "
                  "%.3g mm^2, but %.3g mm^2 are seen along the axis: either "
                  "the way through is oblique or the leak is not that of a jet",
                  leak().gaps / millilitre,
                  jet / square_millimetre,
                  seen / square_millimetre);
    return text;
  }



  Summary
  ValveReport::summary(const ValveStructure &valve,
                       const LeafletMonitor &monitor,
                       const RunCost &cost,
                       const std::vector<std::string> &warnings) const
  {
    const ValveSample &last = samples.back();

    const MeanTractions tractions = mean_tractions();
    const CoaptationResult belt =
      monitor.coaptation(tractions.contact, tractions.total);

    Summary result;
    set_volumes(result);
    if (!last.plane_flow.empty())
      result.set("planes", plane_figures());
    result.set("bulging_volume_mL", last.bulging_volume / millilitre);
    result.set("bulging_by_distance_mL",
               monitor.bulging_by_distance() / millilitre);
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
    path.set("shut_below_mm", settings.shut_width / millimetre);
    path.set("place", place_name(last.path.position));
    path.set("x_mm", last.path.position[0] / millimetre);
    path.set("y_mm", last.path.position[1] / millimetre);
    path.set("z_mm", last.path.position[2] / millimetre);
    result.set("widest_path", path);
    result.set("orifice", orifice_figures(valve.parameters.fluid.density));
    result.set("segments", segment_figures(valve, monitor, tractions));
    result.set("gaps", gap_figures(valve, monitor, tractions));
    result.set("regions", region_figures(valve, monitor));

    Summary chordae;
    for (unsigned int c = 0; c < ChordaePeaks::n_classes; ++c)
      chordae.set(
        name_of(static_cast<ChordaClass>(c)),
        monitor.chordae_peaks().peak(static_cast<ChordaClass>(c)).tension);
    result.set("chordae_peak_N", chordae);

    result.set("annulus_force_N", last.annulus_force.norm());
    for (unsigned int d = 0; d < 3; ++d)
      result.set(std::string("annulus_force_") + "xyz"[d] + "_N",
                 last.annulus_force[d]);
    result.set("largest_displacement_mm", last.displacement / millimetre);
    Summary held;
    for (const auto &[name, displacement] : last.held_displacement)
      held.set(name, displacement / millimetre);
    result.set("held_displacement_mm", held);
    if (settings.in_blood)
      result.set("reynolds_peak", peak_reynolds());
    result.set("stress_mean_kPa", last.mean_stress / kilopascal);
    result.set("principal_stress_mean_kPa", last.mean_principal / kilopascal);
    result.set("strain_mean", last.mean_strain);
    set_distortion(result);
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
    result.set("energy_J",
               energy_summary(energy_books(last, settings.in_blood)));
    if (settings.in_blood && last.works.ends != 0)
      result.set("work_of_adaptation_relative",
                 last.works.adaptation / last.works.ends);
    result.set("warnings", warnings);
    return result;
  }
} // namespace coapt
