// The contact map of a valve whose leaflets are pressed flat, read back from
// both of its files.

#include <coapt/base/csv_table.h>
#include <coapt/base/units.h>
#include <coapt/io/closure_maps.h>
#include <coapt/metrics/structure_monitor.h>
#include <coapt/metrics/unrolled_leaflet.h>

#include <algorithm>

#include "../structure/small_valve.h"
#include "io/vtu_reader.h"
#include "tests.h"

using namespace coapt;
using namespace coapt::units;
using dealii::Point;

namespace
{
  const double mean_contact = 4e3, mean_total = 7e3, sample_time = 0.25;

  /** All nodes near y = 0, at rest. */
  std::vector<double>
  flat_state(const ValveStructure &valve)
  {
    std::vector<double> state = valve.reference_positions();
    for (unsigned int i = 1; i < state.size(); i += 3)
      state[i] *= 0.15;
    state.resize(2 * state.size(), 0.);
    return state;
  }

  /** Largest difference of an array to the values of the columns of a map. */
  template <typename T>
  double
  difference(const std::vector<T> &array,
             const UnrolledLeaflet &map,
             const std::vector<double> &of_columns,
             const double unit = 1)
  {
    if (array.size() != map.points.size())
      return std::numeric_limits<double>::infinity();
    double worst = 0;
    for (unsigned int i = 0; i < array.size(); ++i)
      worst =
        std::max(worst, std::abs(array[i] * unit - of_columns[map.columns[i]]));
    return worst;
  }

  /** One coordinate of points. */
  std::vector<double>
  coordinate(const std::vector<Point<3>> &points, const unsigned int d)
  {
    std::vector<double> result;
    for (const Point<3> &point : points)
      result.push_back(point[d]);
    return result;
  }

  /** A constant where the leaflets lie beside each other, zero elsewhere. */
  std::vector<double>
  where_apposed(const LeafletMonitor &monitor, const double value)
  {
    std::vector<double> result;
    for (const bool is_apposed : monitor.coaptation().apposed(monitor.gaps()))
      result.push_back(is_apposed ? value : 0.);
    return result;
  }

  void
  check_table(const UnrolledLeaflet &map,
              const LeafletMonitor &monitor,
              const std::vector<double> &coapts)
  {
    const CsvTable table("contact_map.csv");
    const unsigned int n = monitor.mid_surface().size();
    const auto error     = [&](const std::string &name,
                           const std::vector<double> &expected,
                           const double unit) {
      return difference(table.numbers(name), map, expected, unit);
    };
    check("table, gaps", error("gap_mm", monitor.gaps(), millimetre) < 1e-8);
    check("table, contact pressure",
          error("contact_pressure_kPa",
                where_apposed(monitor, mean_contact),
                kilopascal) < 1e-2);
    check("table, pressure of coaptation",
          error("coaptation_pressure_kPa",
                where_apposed(monitor, mean_total),
                kilopascal) < 1e-2);
    check("table, what coapts", error("coapts", coapts, 1) == 0);
    check("table, slip",
          error("slip_mm", std::vector<double>(n, 0.), millimetre) == 0);
    for (unsigned int d = 0; d < 3; ++d)
      check(std::string("table, ") + "xyz"[d],
            error(std::string(1, "xyz"[d]) + "_mm",
                  coordinate(monitor.mid_surface(), d),
                  millimetre) < 1e-8);
    double worst = 0;
    for (unsigned int d = 0; d < 2; ++d)
      {
        const auto values = table.numbers(d == 0 ? "right_mm" : "up_mm");
        for (unsigned int i = 0; i < values.size(); ++i)
          worst = std::max(worst,
                           std::abs(values[i] * millimetre - map.points[i][d]));
      }
    check("table, place on the map", worst < 1e-8, worst);
  }

  void
  check_grid(const UnrolledLeaflet &map,
             const ValveStructure &valve,
             const LeafletMonitor &monitor,
             const std::vector<double> &coapts)
  {
    const VtuReader grid("contact_map.vtu");
    const unsigned int n = monitor.mid_surface().size();
    const auto error     = [&](const std::string &name,
                           const std::vector<double> &expected) {
      return difference(grid.array<float>(name), map, expected);
    };
    check("grid, gaps", error("gap", monitor.gaps()) < 1e-8);
    check("grid, contact pressure",
          error("contact_pressure", where_apposed(monitor, mean_contact)) <
            1e-2);
    check("grid, pressure of coaptation",
          error("coaptation_pressure", where_apposed(monitor, mean_total)) <
            1e-2);
    check("grid, what coapts", error("coapts", coapts) == 0);
    check("grid, slip", error("slip", std::vector<double>(n, 0.)) == 0);

    // Those that touch do so since the only sample; the others never did.
    const auto first   = grid.array<float>("first_contact");
    unsigned int early = 0, never = 0;
    for (unsigned int i = 0; i < first.size(); ++i)
      {
        const double expected =
          monitor.contact_history().first_times()[map.columns[i]];
        early += expected == sample_time && first[i] == float(sample_time);
        never += std::isnan(expected) && std::isnan(first[i]);
      }
    check("grid, first contact",
          early > 0 && never > 0 && early + never == map.points.size(),
          early);
    const auto region  = grid.array<float>("region");
    unsigned int wrong = region.size() != map.quads.size();
    for (unsigned int i = 0; i < region.size() && wrong == 0; ++i)
      wrong += region[i] !=
        static_cast<float>(valve.leaflet.quad_region[map.quads[i]]);
    check("grid, regions", wrong == 0, wrong);
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  StructureParameters structure;
  structure.in_blood = false;
  ValveStructure valve(small_valve("0,0\n1,0\n"), MPI_COMM_WORLD);
  Timing timing;
  StructureSystem system(valve, structure, timing);
  const std::vector<double> state = flat_state(valve);
  system.finish_step(state.data(), state.data() + state.size() / 2, 1e-6);
  StructureMonitor monitor(valve, system);
  monitor.sample(sample_time, state);

  const unsigned int n = valve.leaflet.columns.size();
  const MeanTractions tractions{std::vector<double>(n, mean_contact),
                                std::vector<double>(n, mean_total)};
  write_closure_maps(valve, monitor, tractions, [](const std::string &name) {
    return name;
  });

  const UnrolledLeaflet map(valve.leaflet,
                            monitor.coaptation().leaflet_lines());
  std::vector<double> coapts;
  for (const bool value :
       monitor.coaptation().coapting(monitor.coaptation_gaps(),
                                     tractions.total,
                                     valve.contact->state().current_area))
    coapts.push_back(value);
  const auto n_coapting = std::count(coapts.begin(), coapts.end(), 1.);
  check("some places coapt, others do not",
        n_coapting > 0 && n_coapting < int(n),
        n_coapting);
  check_table(map, monitor, coapts);
  check_grid(map, valve, monitor, coapts);
}
