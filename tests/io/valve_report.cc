// Means over time and the verdict of a report, from an upright elliptic tube
// that is pressed flat, now more and now less, and from made-up flows.

#include <coapt/base/units.h>
#include <coapt/io/valve_report.h>

#include <boost/property_tree/json_parser.hpp>

#include <algorithm>
#include <sstream>

#include "../structure/upright_valve.h"
#include "tests.h"

using namespace coapt;
using namespace coapt::units;
using dealii::Point;

namespace
{
  using Figures = boost::property_tree::ptree;

  const double end_time = 0.1, shut_width = 0.3e-3;

  ModelParameters
  pressed_valve()
  {
    ModelParameters parameters   = upright_valve();
    parameters.contact.clearance = 1.2e-3;
    return parameters;
  }

  /** The tube as it is, in which nothing touches, or with its lower half
   * pressed flat. */
  std::vector<double>
  shape(const ObservedValve &tube, const bool is_pressed)
  {
    return tube.state([=](const Point<3> &x) {
      const bool is_flat = is_pressed && x[2] < -0.45 * upright_height;
      return Point<3>(x[0], (is_flat ? 0.02 : 1.) * x[1], x[2]);
    });
  }

  /** Pressure (Pa) of contact on the columns of the pressed tube, and their
   * areas (m^2). */
  struct Pressed
  {
    std::vector<double> pressure, area;
  };

  Pressed
  pressed_tube()
  {
    ObservedValve tube(pressed_valve());
    tube.sample(0, shape(tube, true));
    return {tube.monitor.contact_pressure(),
            tube.valve.contact->state().current_area};
  }

  /** Steps count as long as they are, and those before the last sample not at
   * all. */
  void
  check_mean_since_last_sample(const Pressed &pressed)
  {
    ObservedValve tube(pressed_valve());
    const auto hold = [&](const bool is_pressed, const double step) {
      const std::vector<double> state = shape(tube, is_pressed);
      tube.system.finish_step(state.data(),
                              state.data() + state.size() / 2,
                              step);
    };
    hold(true, 4e-6);
    tube.monitor.sample(0, shape(tube, true));
    hold(true, 1e-6);
    hold(false, 2e-6);
    hold(true, 2e-6);
    tube.monitor.sample(1e-3, shape(tube, true));

    double error = 0, largest = 0;
    for (unsigned int c = 0; c < pressed.pressure.size(); ++c)
      {
        error   = std::max(error,
                         std::abs(tube.monitor.contact_pressure()[c] -
                                  0.6 * pressed.pressure[c]));
        largest = std::max(largest, pressed.pressure[c]);
      }
    check("pressures are means over time since the last sample",
          error < 1e-9 * largest,
          error / largest);
  }

  /** A sample of a valve that has been shut since 60 ms and leaks
   * @p leak (m^3/s). */
  ValveSample
  made_up(const double t, const double leak)
  {
    ValveSample sample;
    sample.time           = t;
    sample.path_width     = t < 59.5e-3 ? 1e-3 : 0.1e-3;
    sample.outflow        = leak;
    sample.outflow_volume = leak * t;
    sample.peak_outflow   = leak;
    return sample;
  }

  /** Takes samples each 10 ms from 50 ms on of a run in which the tube is
   * pressed until 90 ms, for half of the last 20 ms. */
  void
  observe(ObservedValve &tube, ValveReport &report, const double leak)
  {
    for (unsigned int i = 5; i <= 10; ++i)
      {
        const double t = 10e-3 * i;
        tube.sample(t, shape(tube, t < 91e-3));
        report.add(made_up(t, leak), tube.monitor);
      }
  }

  void
  check_mean_tractions(const Pressed &pressed)
  {
    ObservedValve tube(pressed_valve());
    ValveReport report({end_time, shut_width, true});
    observe(tube, report, 0);
    const MeanTractions mean = report.mean_tractions();
    double error = 0, largest = 0;
    for (unsigned int c = 0; c < pressed.pressure.size(); ++c)
      {
        for (const double found : {mean.contact[c], mean.total[c]})
          error = std::max(error, std::abs(found - 0.5 * pressed.pressure[c]));
        largest = std::max(largest, pressed.pressure[c]);
      }
    check("tractions are means of the last 20 ms",
          error < 1e-9 * largest,
          error / largest);
  }

  Figures
  summary(const double leak)
  {
    ObservedValve tube(pressed_valve());
    ValveReport report({end_time, shut_width, true});
    observe(tube, report, leak);
    std::istringstream text(
      report.summary(tube.valve, tube.monitor, RunCost(), {}).json());
    Figures result;
    boost::property_tree::read_json(text, result);
    return result;
  }

  void
  check_verdict()
  {
    const Figures tight = summary(0.9 * millilitre),
                  loose = summary(1.1 * millilitre);
    check("a valve that is shut and leaks 0.9 mL/s is sealed",
          tight.get<bool>("sealed"));
    check("one that leaks 1.1 mL/s is not", !loose.get<bool>("sealed"));
    check_relative("its leak", loose.get<double>("leak_mL_per_s"), 1.1, 1e-8);
    check_relative("closing time",
                   loose.get<double>("closing_time_s"),
                   60e-3,
                   1e-8);
    check_relative("closing volume",
                   loose.get<double>("closing_volume_mL"),
                   1.1 * 60e-3,
                   1e-8);
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const Pressed pressed = pressed_tube();
  check_mean_since_last_sample(pressed);
  check_mean_tractions(pressed);
  check_verdict();
}
