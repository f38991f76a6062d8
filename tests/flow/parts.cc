// The parts of a flow: expressions, figures of signals, samples at points, and
// the force on an obstacle.
#include <coapt/flow/flow_errors.h>
#include <coapt/flow/flow_model.h>
#include <coapt/flow/flow_sampler.h>
#include <coapt/flow/obstacle_force.h>
#include <coapt/flow/signal.h>

#include "tests.h"

using namespace coapt;
using dealii::Point;

namespace
{
  void
  expressions()
  {
    const auto constants =
      read_constants("K", "a = 2*b, d = pi/a", {{"b", 3.}});
    check_relative("constants", constants.at("d"), std::acos(-1.) / 6, 1e-15);
    const auto f = vector_field<3>("F", "x + y; a*z; t^2", constants);
    const auto v = f(Point<3>(1, 2, 3), 4);
    check("vector", v[0] == 3 && v[1] == 18 && v[2] == 16);
    check("no expression", !scalar_field<2>("F", "", {}));

    const auto refused = [](const std::string &text, const std::string &part) {
      const std::string error =
        error_of([&] { vector_field<2>("Flow/F", text, {}); });
      check("refuses " + text,
            error.find("Flow/F = " + text) == 0 &&
              error.find(part) != std::string::npos &&
              error.find('\n') == std::string::npos);
    };
    refused("x; y; 0", "3 component(s)");
    refused("x; z", "cannot be read");
    refused("x; 2*(y", "cannot be read");
    check("refuses a constant without value",
          error_of([] { read_constants("K", "a", {}); }).find("'a'") !=
            std::string::npos);
  }

  void
  signals()
  {
    std::vector<double> times, values;
    for (unsigned int i = 0; i <= 1000; ++i)
      {
        times.push_back(2e-3 * i);
        values.push_back(times.back() < 0.5
                           ? 9
                           : 3 + 2 * std::sin(2 * M_PI * 4 * times.back()));
      }
    const SignalFigures figures = signal_figures(times, values, 0.5);
    check_relative("mean", figures.mean, 3, 1e-3);
    check_relative("least", figures.least, 1, 1e-3);
    check_relative("largest", figures.largest, 5, 1e-3);
    check_relative("frequency", figures.frequency, 4, 1e-4);
    for (double &value : values)
      value += 1000;
    check("a steady signal",
          std::isnan(signal_figures(times, values, 0.5).frequency));
  }

  /** A channel of rest with a disc, under a pressure that is linear in x: the
   * disc feels that pressure on its staircase, which is its volume of held
   * cells times the gradient. */
  void
  buoyancy()
  {
    FlowParameters parameters;
    parameters.fluid.density    = 1;
    parameters.obstacle_center  = {0.5, 0.5};
    parameters.obstacle_radius  = 0.26;
    parameters.initial_pressure = "7*x + 3";
    parameters.exact_pressure   = "7*x";
    const FlowModel<2> model(parameters, 4, MPI_COMM_WORLD);
    const std::vector<double> y = model.initial_state();
    const auto force            = ObstacleForce<2>(model).force(0., y.data());
    // each held node carries a cell's volume, half on the rim and less outside
    check("force on the obstacle",
          force[0] < -7 * M_PI * 0.2 * 0.2 &&
            force[0] > -7 * M_PI * 0.3 * 0.3 && std::abs(force[1]) < 1e-12,
          force[0]);

    // the mean of the pressure is free
    const FlowErrors errors = flow_errors(model, 0., y.data());
    check("error of the means of a pressure",
          errors.pressure_means_l2 < 1e-12,
          errors.pressure_means_l2);
    const auto samples =
      sample_flow(model, y.data(), {Point<2>(0.1, 0.3), Point<2>(1., 1.)});
    check_relative("pressure inside", samples.pressure[0], 3.7, 1e-12);
    check_relative("pressure in the corner", samples.pressure[1], 10, 0.03);
    const std::string error =
      error_of([&] { sample_flow(model, y.data(), {Point<2>(1.1, 0.)}); });
    check("point outside", error.find("1.1") != std::string::npos);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  expressions();
  signals();
  buoyancy();
}
