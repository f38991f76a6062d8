#include <coapt/base/units.h>
#include <coapt/io/closure_maps.h>
#include <coapt/io/statistics.h>
#include <coapt/io/vtu_file.h>
#include <coapt/metrics/distribution.h>
#include <coapt/metrics/surface_section.h>
#include <coapt/metrics/unrolled_leaflet.h>

#include <array>

namespace coapt
{
  using namespace units;
  using dealii::Point;

  namespace
  {
    /** Quantities of the columns, with their names in the VTU file and in the
     * table, and the unit of the latter. */
    struct ColumnMap
    {
      std::string name, column;
      double unit;
      std::vector<double> values;
    };

    std::vector<ColumnMap>
    column_maps(const ValveStructure &valve,
                const LeafletMonitor &monitor,
                const MeanTractions &tractions)
    {
      const auto &state             = valve.contact->state();
      const std::vector<double> gap = monitor.gaps();
      const auto filtered           = [&](const std::vector<double> &values) {
        return monitor.coaptation().average(values, gap, state.current_area);
      };
      std::vector<double> coapts;
      for (const bool value : monitor.coaptation().coapting(
             monitor.coaptation_gaps(), tractions.total, state.current_area))
        coapts.push_back(value);
      return {
        {"contact_pressure",
         "contact_pressure_kPa",
         kilopascal,
         filtered(tractions.contact)},
        {"coaptation_pressure",
         "coaptation_pressure_kPa",
         kilopascal,
         filtered(tractions.total)},
        {"gap", "gap_mm", millimetre, gap},
        {"first_contact",
         "first_contact_s",
         1.,
         monitor.contact_history().first_times()},
        {"slip", "slip_mm", millimetre, monitor.contact_history().slips()},
        {"coapts", "coapts", 1., coapts}};
    }

    void
    write_map_grid(const UnrolledLeaflet &map,
                   const Leaflet &leaflet,
                   const std::vector<ColumnMap> &quantities,
                   const std::string &file)
    {
      std::vector<unsigned int> connectivity;
      for (const auto &triangle : map.triangles)
        connectivity.insert(connectivity.end(),
                            triangle.begin(),
                            triangle.end());
      std::vector<double> region;
      for (const unsigned int quad : map.quads)
        region.push_back(static_cast<double>(leaflet.quad_region[quad]));
      VtuFile grid(map.points, connectivity, VtuFile::CellType::triangle);
      for (const ColumnMap &quantity : quantities)
        grid.add_point_data(quantity.name, 1, map.on_points(quantity.values));
      grid.add_cell_data("region", 1, region);
      grid.write(file);
    }

    void
    write_map_table(const UnrolledLeaflet &map,
                    const std::vector<Point<3>> &current,
                    const std::vector<ColumnMap> &quantities,
                    const std::string &file)
    {
      Statistics table(file, MPI_COMM_SELF);
      for (unsigned int i = 0; i < map.points.size(); ++i)
        {
          const unsigned int column          = map.columns[i];
          std::vector<Statistics::Entry> row = {
            {"right_mm", map.points[i][0] / millimetre},
            {"up_mm", map.points[i][1] / millimetre},
            {"x_mm", current[column][0] / millimetre},
            {"y_mm", current[column][1] / millimetre},
            {"z_mm", current[column][2] / millimetre}};
          for (const ColumnMap &quantity : quantities)
            row.emplace_back(quantity.column,
                             quantity.values[column] / quantity.unit);
          table.write_row(row);
        }
    }

    void
    write_profile(const ValveStructure &valve,
                  const LeafletMonitor &monitor,
                  const MeanTractions &tractions,
                  const std::string &file)
    {
      const auto &state = valve.contact->state();
      const auto profile =
        monitor.coaptation().profile(monitor.coaptation_gaps(),
                                     tractions.total,
                                     state.current_area,
                                     monitor.mid_surface());
      Statistics table(file, MPI_COMM_SELF);
      for (unsigned int leaflet = 0; leaflet < 2; ++leaflet)
        for (const LineCoaptation &line : profile[leaflet])
          table.write_row(
            {{"leaflet", double(leaflet)},
             {"position", line.position},
             {"contact_height_mm", line.contact_height / millimetre},
             {"apposition_mm", line.apposition / millimetre},
             {"pressure_max_kPa", line.max_traction / kilopascal}});
    }

    void
    write_distribution(const ValveStructure &valve,
                       const std::vector<ColumnMap> &quantities,
                       const std::string &file)
    {
      // the area of the columns that coapt
      const auto &area = valve.contact->state().current_area;
      std::vector<double> weights;
      for (unsigned int c = 0; c < area.size(); ++c)
        weights.push_back(area[c] * quantities.back().values[c]);
      std::vector<double> thresholds;
      for (unsigned int i = 0; i <= 120; ++i)
        thresholds.push_back(0.5 * i * kilopascal);
      const auto contact =
        exceedance(quantities[0].values, weights, thresholds);
      const auto total = exceedance(quantities[1].values, weights, thresholds);
      Statistics table(file, MPI_COMM_SELF);
      for (unsigned int i = 0; i < thresholds.size(); ++i)
        table.write_row({{"pressure_kPa", thresholds[i] / kilopascal},
                         {"share_contact", contact[i]},
                         {"share_coaptation", total[i]}});
    }

    void
    write_sections(const ValveStructure &valve,
                   const std::vector<Point<3>> &current,
                   const std::string &file)
    {
      std::vector<Point<3>> reference;
      for (unsigned int c = 0; c < valve.leaflet.columns.size(); ++c)
        reference.push_back(middle_of_column(valve.leaflet, c));
      const std::array<const std::vector<Point<3>> *, 2> shapes = {
        {&reference, &current}};
      Statistics table(file, MPI_COMM_SELF);
      for (const double fraction : {-0.5, 0., 0.5})
        for (unsigned int shape = 0; shape < 2; ++shape)
          {
            const double x = fraction * valve.lumen.semi_axis_x();
            const auto curves =
              surface_section(*shapes[shape], valve.surface, x);
            for (unsigned int i = 0; i < curves.size(); ++i)
              for (const Point<3> &point : curves[i])
                table.write_row({{"x_mm", x / millimetre},
                                 {"closed", double(shape)},
                                 {"curve", double(i)},
                                 {"y_mm", point[1] / millimetre},
                                 {"z_mm", point[2] / millimetre}});
          }
    }
  } // namespace



  void
  write_closure_maps(
    const ValveStructure &valve,
    const LeafletMonitor &monitor,
    const MeanTractions &tractions,
    const std::function<std::string(const std::string &)> &file)
  {
    const UnrolledLeaflet map(valve.leaflet,
                              monitor.coaptation().leaflet_lines());
    const auto quantities = column_maps(valve, monitor, tractions);
    write_map_grid(map, valve.leaflet, quantities, file("contact_map.vtu"));
    write_map_table(map,
                    monitor.mid_surface(),
                    quantities,
                    file("contact_map.csv"));
    write_profile(valve, monitor, tractions, file("coaptation.csv"));
    write_distribution(valve, quantities, file("pressure_distribution.csv"));
    write_sections(valve, monitor.mid_surface(), file("sections.csv"));
  }
} // namespace coapt
