// Verification files with bodies on coarse meshes: the pressures of a ring at
// rest, a disc that keeps its area while it is carried around, and a plate that
// shuts a channel, leaflets that touch.
#include "flow/run_study.h"
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
    return run_study<2>(name,
                        FlowContents::bodies,
                        {{"Flow", "Refinements", levels},
                         {"Flow", "Figures from", figures_from},
                         {"Time", "End time", end_time}})
      .results();
  }

  /** What is left in the books of energy, over the work put in. */
  void
  check_energy(const std::string &name, const FlowResult &result)
  {
    const double error = figure(result, "energy_error_relative_max");
    check(name + ", energy error below 1 %", error < 0.01, error);
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
    check_energy("disc", runs[0]);
  }

  void
  plate()
  {
    const auto runs   = study("plate_2d", "0", "40e-3", "35e-3");
    const double leak = figure(runs[0], "leak_m3_per_s_mean") / 20e-3;
    check("plate, leak below 0.1 mm/s", std::abs(leak) < 0.1e-3, leak);
    check_energy("plate", runs[0]);
  }

  void
  leaflets()
  {
    const auto runs    = study("valve_2d", "0", "50e-3", "40e-3");
    const double force = figure(runs[0], "contact_force_N_mean");
    check("leaflets touch", force > 1 && force < 20, force);
    const double y = figure(runs[0], "body_1_centroid_y_m_mean") +
      figure(runs[0], "body_2_centroid_y_m_mean");
    check("alike on both sides", std::abs(y - 20e-3) < 1e-9, y);
    // Impulses that act at once leave 0.8 %.
    const double error = figure(runs[0], "energy_error_relative_max");
    check("leaflets, energy error below 0.01 %", error < 1e-4, error);
  }

  /** The files as they are give no warning; points too far apart do. */
  void
  warnings()
  {
    check("no warnings", study_log().warnings().empty());
    run_study<2>("disc",
                 FlowContents::bodies,
                 {{"Flow", "Refinements", "4"},
                  {"Time", "End time", "2"},
                  {"Coupling", "Point spacing", "1.4"}});
    const auto &raised = study_log().warnings();
    check("points too far apart",
          raised.size() == 1 && raised[0].key == "stretched points",
          raised.size());
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  ring();
  disc();
  plate();
  leaflets();
  warnings();
}
