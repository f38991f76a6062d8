// Verification files with bodies on coarse meshes: the pressures of a ring at
// rest, a disc that keeps its area while it is carried around, and a plate that
// shuts a channel.
#include <coapt/base/parameter_file.h>
#include <coapt/base/version.h>
#include <coapt/flow/refinement_study.h>

#include <sstream>

#include "tests.h"

using namespace coapt;

namespace
{
  /** Runs a verification file at the given levels until @p end_time. */
  std::vector<FlowResult>
  study(const std::string &name,
        const std::string &levels,
        const std::string &end_time,
        const std::string &figures_from)
  {
    static std::ostringstream terminal;
    static Log log(MPI_COMM_WORLD, terminal);
    dealii::ParameterHandler prm;
    prm.declare_entry("Task", "immersed");
    FlowParameters::declare_parameters(prm, FlowContents::bodies);
    const std::string folder = parameter_files_folder() + "/verification";
    read_parameter_file(prm, folder + "/" + name + ".prm");
    prm.enter_subsection("Flow");
    prm.set("Refinements", levels);
    prm.set("Figures from", figures_from);
    prm.leave_subsection();
    prm.enter_subsection("Time");
    prm.set("End time", end_time);
    prm.leave_subsection();
    prm.enter_subsection("Output");
    prm.set("Fields interval", "0");
    prm.leave_subsection();
    FlowParameters parameters;
    parameters.immersed.emplace();
    parameters.parse_parameters(prm);
    RefinementStudy<2> result(parameters, prm, folder, log, MPI_COMM_WORLD);
    const OutputFolder output(name, true, MPI_COMM_WORLD);
    output.create();
    result.run(output);
    return result.results();
  }

  double
  figure(const FlowResult &result, const std::string &name)
  {
    for (const auto &entry : result.figures)
      if (entry.first == name)
        return entry.second;
    return std::nan("");
  }

  void
  ring()
  {
    const auto runs  = study("ring", "4, 5", "1", "1");
    const auto &fine = runs.back();
    check_relative("ring, pressure inside",
                   figure(fine, "pressure_1_Pa_mean"),
                   0.167920,
                   0.05);
    check_relative("ring, pressure outside",
                   figure(fine, "pressure_2_Pa_mean"),
                   -0.055223,
                   0.05);
    check("ring, spurious velocity falls",
          fine.errors.velocity_l2 < 0.6 * runs.front().errors.velocity_l2,
          fine.errors.velocity_l2 / runs.front().errors.velocity_l2);
  }

  void
  disc()
  {
    const auto runs     = study("disc", "5", "2", "2");
    const double change = figure(runs[0], "body_1_volume_change_mean");
    check("disc, area", std::abs(change) < 5e-3, change);
    const double x = figure(runs[0], "body_1_centroid_x_m_mean");
    check("disc, moves", x < 0.55, x);
  }

  void
  plate()
  {
    const auto runs   = study("plate_2d", "0", "40e-3", "35e-3");
    const double leak = figure(runs[0], "leak_m3_per_s_mean") / 20e-3;
    check("plate, leak below 0.1 mm/s", std::abs(leak) < 0.1e-3, leak);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  ring();
  disc();
  plate();
}
