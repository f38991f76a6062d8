// Flows with a known solution: standing acoustic waves, a decaying
// Taylor-Green vortex, the flow between plates, outflow through an impedance;
// and a noisy state whose norms do not depend on the number of ranks.

#include <iomanip>

#include "fluid_case.h"

using namespace coapt;
using dealii::numbers::PI;

namespace
{
  /** A fluid without any dissipation. */
  FluidParameters
  ideal()
  {
    FluidParameters parameters;
    parameters.viscosity            = 0;
    parameters.hourglass_speed      = 0;
    parameters.checkerboard         = 0;
    parameters.artificial_viscosity = 0;
    parameters.convection           = false;
    return parameters;
  }

  /**
   * Relative error of the frequency of the lowest diagonal mode of a closed
   * box with n cells a side, from the time at which the pressure amplitude
   * crosses zero for the second time.
   */
  template <int dim>
  double
  standing_wave_error(const unsigned int n)
  {
    const double length = 0.05;
    dealii::Point<dim> end;
    std::array<unsigned int, dim> cells;
    for (int d = 0; d < dim; ++d)
      end[d] = length;
    cells.fill(n);
    FluidCase<dim> test(ideal(),
                        all_sides<dim>(FluidBoundary::slip),
                        dealii::Point<dim>(),
                        end,
                        cells);
    test.set_up([](const auto &, double) { return 0u; });
    const auto shape = [&](const dealii::Point<dim> &x) {
      double value = 100;
      for (int d = 0; d < dim; ++d)
        value *= std::cos(PI * x[d] / length);
      return value;
    };
    test.set_pressure(shape);
    const std::vector<double> mode = test.p;

    const double omega = 50 * PI / length * std::sqrt(1. * dim);
    const double dt    = 0.2 * test.op.max_stable_step();
    double time = 0, amplitude = 1, crossing = 0;
    while (crossing < 1 && time < 10 / omega)
      {
        const double before = amplitude;
        test.step(time, dt);
        amplitude = test.dot(test.p, mode);
        // the second crossing goes upwards
        if (before < 0 && amplitude >= 0)
          {
            const double at = time - dt * amplitude / (amplitude - before);
            return std::abs(1.5 * PI / (at * omega) - 1);
          }
      }
    return 1;
  }

  template <int dim>
  void
  standing_wave()
  {
    const std::string name = "standing wave, " + std::to_string(dim) + "D";
    const double coarse    = standing_wave_error<dim>(12);
    const double fine      = standing_wave_error<dim>(24);
    check(name + ", frequency", fine < 0.01, fine);
    const double order = std::log2(coarse / fine);
    check(name + ", second order", order > 1.9 && order < 2.2, order);
  }

  /** Relative error of the velocity of a decaying Taylor-Green vortex. */
  double
  vortex_error(const unsigned int n)
  {
    const double length = 0.02, speed = 0.1, nu = 5e-5;
    FluidParameters parameters = ideal();
    parameters.viscosity       = nu * parameters.density;
    parameters.convection      = true;
    parameters.sound_speed     = 5;
    FluidCase<2> test(parameters,
                      all_sides<2>(FluidBoundary::slip),
                      dealii::Point<2>(),
                      dealii::Point<2>(length, length),
                      {{n, n}});
    test.set_up([](const auto &, double) { return 0u; });
    const double k    = PI / length;
    const auto vortex = [&](const dealii::Point<2> &x, const int d) {
      return speed *
        (d == 0 ? std::sin(k * x[0]) * std::cos(k * x[1])
                : -std::cos(k * x[0]) * std::sin(k * x[1]));
    };
    test.set_velocity(vortex);
    test.set_pressure([&](const auto &x) {
      return 0.25 * parameters.density * speed * speed *
        (std::cos(2 * k * x[0]) + std::cos(2 * k * x[1]));
    });
    const double end = 0.1;
    const int steps  = std::ceil(end / (0.8 * test.op.max_stable_step()));
    double time      = 0;
    for (int i = 0; i < steps; ++i)
      test.step(time, end / steps);
    const std::vector<double> result = test.u;
    test.set_velocity(vortex);
    const double decay        = std::exp(-2 * nu * k * k * time);
    std::vector<double> error = result;
    for (unsigned int i = 0; i < error.size(); ++i)
      error[i] -= decay * test.u[i];
    return std::sqrt(test.dot(error, error) / test.dot(result, result));
  }

  void
  vortex()
  {
    const double coarse = vortex_error(8), fine = vortex_error(16);
    check("vortex, error", fine < 0.02, fine);
    const double order = std::log2(coarse / fine);
    check("vortex, second order", order > 1.7 && order < 2.4, order);
  }

  /** The flow between plates driven by the pressures of the ends (Poiseuille):
   * without convection it solves the equations with these ends exactly. */
  void
  plates()
  {
    const double length = 0.02, height = 0.01, mu = 0.1, p0 = 10;
    FluidParameters parameters;
    parameters.viscosity            = mu;
    parameters.sound_speed          = 10;
    parameters.artificial_viscosity = 0;
    parameters.convection           = false;
    auto boundaries                 = all_sides<2>(FluidBoundary::no_slip);
    boundaries.type[0]              = FluidBoundary::pressure_end;
    boundaries.type[1]              = FluidBoundary::pressure_end;
    boundaries.pressure[0]          = [=](double) { return p0; };
    boundaries.pressure[1]          = [](double) { return 0.; };
    FluidCase<2> test(parameters,
                      boundaries,
                      dealii::Point<2>(),
                      dealii::Point<2>(length, height),
                      {{8, 4}});
    test.set_up(
      [](const dealii::Point<2> &x, double) { return x[1] < 0.004 ? 2u : 1u; });
    double time = 0;
    while (time < 1.)
      test.step(time, 0.9 * test.op.max_stable_step());
    test.local.resize(2 * test.op.n_local_nodes());
    test.op.gather(test.u.data(), test.local.data());
    const double out = test.op.flux(1, test.local.data());
    const double in  = -test.op.flux(0, test.local.data());
    check_relative("plates, flow in is flow out", in, out, 1e-6);
    const double expected = std::pow(height, 3) * p0 / (12 * mu * length);
    check_relative("plates, flow", out, expected, 0.02);
    const auto w = test.op.powers(time, test.local.data(), test.p.data());
    check_relative("plates, power",
                   w.ends,
                   w.viscous + w.artificial + w.hourglass + w.checkerboard +
                     w.impedance,
                   1e-3);
  }

  /** A noisy state on a tree with hanging nodes; its norms after some steps
   * are printed, so that 1 and 2 ranks are compared with the same text. */
  void
  ranks()
  {
    auto boundaries         = all_sides<3>(FluidBoundary::no_slip);
    boundaries.type[4]      = FluidBoundary::pressure_end;
    boundaries.type[5]      = FluidBoundary::pressure_end;
    boundaries.pressure[4]  = [](const double t) { return 1e6 * t; };
    boundaries.pressure[5]  = [](double) { return 0.; };
    boundaries.impedance[4] = boundaries.impedance[5] = 1.5e4;
    const auto lumen = [](const dealii::Point<3> &x) {
      return std::hypot(x[0] - 0.015, x[1] - 0.015) - 0.014;
    };
    FluidCase<3> test(FluidParameters(),
                      boundaries,
                      dealii::Point<3>(),
                      dealii::Point<3>(0.03, 0.03, 0.04),
                      {{3, 3, 4}},
                      lumen);
    test.set_up([](const dealii::Point<3> &x, const double size) {
      const double distance = x.distance(dealii::Point<3>(0.015, 0.012, 0.02));
      return distance < 0.006 + size ? 3u : 1u;
    });
    test.set_velocity(
      [](const auto &x, const int d) { return 0.5 * noise<3>(x, d); });
    test.set_pressure([](const auto &x) { return 1e3 * noise<3>(x, 5); });
    double time = 0;
    for (int i = 0; i < 40; ++i)
      {
        test.step(time, 0.8 * test.op.max_stable_step());
        if (i == 20)
          test.grid.adapt(
            [](const dealii::Point<3> &x, const double size) {
              const double distance =
                x.distance(dealii::Point<3>(0.015, 0.016, 0.022));
              return distance < 0.006 + size ? 3u : 1u;
            },
            test.op,
            test.u,
            test.p);
      }
    test.op.gather(test.u.data(), test.local.data());
    const auto largest = test.op.largest_velocity(test.u.data());
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << std::setprecision(8);
    const auto print = [](const std::string &what, const double value) {
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << what << " " << value << std::endl;
    };
    print("kinetic energy, microjoule",
          1e6 * test.op.kinetic_energy(test.u.data()));
    print("acoustic energy, microjoule",
          1e6 * test.op.acoustic_energy(test.p.data()));
    print("inflow, mL/s", -1e6 * test.op.flux(4, test.local.data()));
    print("largest velocity, m/s", largest.speed);
    print("its height, mm", 1e3 * largest.position[2]);
    print("hourglass velocity, m/s", test.op.hourglass_rms(test.local.data()));
    print("checkerboard pressure, Pa", test.op.checkerboard_rms(test.p.data()));
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  standing_wave<2>();
  standing_wave<3>();
  vortex();
  plates();
  ranks();
}
