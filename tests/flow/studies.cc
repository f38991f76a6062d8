// The verification files of the program on coarse meshes: observed orders,
// exact profiles, and the frequency of a wave; and the order in time of a
// boundary with given velocity.
#include "flow/run_study.h"
#include "tests.h"

using namespace coapt;

namespace
{
  /** Runs a verification file at the given levels. */
  template <int dim>
  RefinementStudy<dim>
  study(const std::string &name, const std::string &levels)
  {
    return run_study<dim>(name,
                          FlowContents::nothing,
                          {{"Flow", "Refinements", levels}});
  }

  template <int dim>
  void
  check_order(const std::string &name, const std::string &levels)
  {
    const double order = study<dim>(name, levels).last_velocity_order();
    check(name + ", order of the velocity", order >= 1.9 && order < 2.4, order);
  }

  void
  check_wave(const std::string &name)
  {
    const auto waves = study<2>(name, "3, 4");
    check(name + ", order of the velocity",
          waves.last_velocity_order() > 1.9,
          waves.last_velocity_order());
    double error[2];
    for (unsigned int i = 0; i < 2; ++i)
      error[i] =
        std::abs(figure(waves.results()[i], "pressure_1_Pa_frequency_Hz") /
                   (10 / std::sqrt(2.)) -
                 1);
    check(name + ", frequency", error[1] < 0.01, error[1]);
    const double order = std::log2(error[0] / error[1]);
    check(name + ", order of the frequency", order > 1.8, order);
  }

  void
  check_couette()
  {
    const RefinementStudy<2> couette = study<2>("couette", "2, 3");
    for (const FlowResult &result : couette.results())
      check("couette, exact",
            result.errors.velocity_max < 1e-12,
            result.errors.velocity_max);
  }

  void
  check_sound_speed()
  {
    const double order =
      study<2>("sound_speed_strain", "4").last_velocity_order();
    check("error by compressibility, power of the Mach number",
          order > 1.9 && order < 2.1,
          order);
  }

  /** What is left in the books of energy, over the work put in: of a lid, of
   * sides with a given velocity around a decaying flow, of pressure ends. */
  template <int dim>
  void
  check_energy(const std::string &name,
               const std::string &level,
               const std::string &end_time)
  {
    const auto driven = run_study<dim>(name,
                                       FlowContents::nothing,
                                       {{"Flow", "Refinements", level},
                                        {"Time", "End time", end_time}});
    const double error =
      figure(driven.results()[0], "energy_error_relative_max");
    check(name + ", energy error below 1 %", error < 0.01, error);
  }

  /** The flow through a tube tells the effective radius of its staircase. */
  void
  check_tube()
  {
    const auto tube = study<3>("poiseuille_tube", "0, 1, 2");
    double error[3];
    for (unsigned int i = 0; i < 3; ++i)
      for (const auto &figure : tube.results()[i].figures)
        if (figure.first == "flow_m3_per_s_mean")
          error[i] = std::pow(figure.second / dealii::numbers::PI, 0.25) - 1;
    for (unsigned int i = 0; i < 3; ++i)
      check("tube, effective radius within half a cell",
            std::abs(error[i]) < 0.5 * tube.results()[i].cell_size,
            error[i]);
    // it tends to one from below
    check("tube, order of the velocity",
          tube.last_velocity_order() > 0.7,
          tube.last_velocity_order());
  }

  /** The state at time 1 of a box of fluid whose lid starts to move, after @p n
   * steps. The lid's speed is a cubic in time, for which the sampling of the
   * boundary velocity is exact, so that only the steps matter. */
  std::vector<double>
  starting_lid(const unsigned int n)
  {
    FlowParameters parameters;
    parameters.fluid.density              = 1;
    parameters.fluid.viscosity            = 0.1;
    parameters.fluid.sound_speed          = 10;
    parameters.fluid.artificial_viscosity = 0;
    parameters.sides[3]                   = FluidBoundary::velocity;
    parameters.boundary_velocity          = "t^2*(3-2*t)*x*(1-x); 0";
    const FlowModel<2> model(parameters, 3, MPI_COMM_WORLD);
    ExplicitIntegrator integrator(
      MPI_COMM_WORLD,
      [&](const double t, const double *y, double *y_dot) {
        model.rhs(t, y, y_dot);
      },
      [](double, double *) {});
    std::vector<double> y = model.initial_state();
    integrator.start(0., y);
    for (unsigned int i = 0; i < n; ++i)
      integrator.step(1. / n);
    return y;
  }

  void
  check_order_in_time()
  {
    const std::vector<double> best = starting_lid(2560);
    double error[2];
    for (unsigned int i = 0; i < 2; ++i)
      {
        const std::vector<double> y = starting_lid(i == 0 ? 160 : 320);
        double square               = 0;
        for (unsigned int k = 0; k < y.size(); ++k)
          square += (y[k] - best[k]) * (y[k] - best[k]);
        error[i] = dealii::Utilities::MPI::sum(square, MPI_COMM_WORLD);
      }
    const double order = std::log2(error[0] / error[1]) / 2;
    check("starting lid, order in time", order > 2.8, order);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_couette();
  check_order_in_time();
  check_order<2>("taylor_green_2d", "3, 4, 5");
  check_order<2>("taylor_green_2d_patch", "3, 4, 5");
  check_order<3>("taylor_green_3d", "3, 4");
  check_order<3>("taylor_green_3d_patch", "3, 4");
  check_order<3>("ethier_steinman", "2, 3");
  check_order<3>("ethier_steinman_patch", "2, 3, 4");
  check_order<2>("womersley_channel", "0, 1");
  check_order<2>("womersley_channel_patch", "0, 1");
  check_sound_speed();
  check_tube();
  check_wave("standing_wave_2d");
  check_wave("standing_wave_2d_patch");
  check_energy<2>("cavity_re100", "4", "5");
  check_energy<3>("ethier_steinman_patch", "2", "0.1");
  check_energy<2>("womersley_channel_patch", "0", "1");
  check_energy<2>("cylinder_2d2", "1", "2");
}
