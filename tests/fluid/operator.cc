// Identities that the fluid operator keeps to round-off on octrees with
// hanging nodes: rest, patch test, no work by convection, power balance,
// adjointness of gather and collect, location, transfer.

#include <coapt/base/exceptions.h>

#include "fluid_case.h"

using namespace coapt;

namespace
{
  // a power of two, so that no round-off decides on which side of a face
  // a point is
  constexpr double box = 1. / 32;

  template <int dim>
  dealii::Point<dim>
  diagonal(const double length)
  {
    dealii::Point<dim> result;
    for (int d = 0; d < dim; ++d)
      result[d] = length;
    return result;
  }

  /** Two levels of refinement around a point off the center. */
  template <int dim>
  typename FluidGrid<dim>::WantedLevel
  around(const double at)
  {
    return [at](const dealii::Point<dim> &x, const double size) {
      const double distance = x.distance(diagonal<dim>(at));
      return distance < 0.004 + size ? 3u : distance < 0.010 + size ? 2u : 1u;
    };
  }

  std::string
  name(const std::string &what, const int dim)
  {
    return what + ", " + std::to_string(dim) + "D";
  }

  template <int dim>
  FluidCase<dim>
  make_case(const FluidParameters &parameters,
            const FluidBoundaries<dim> &boundaries,
            const std::function<double(const dealii::Point<dim> &)> &lumen = {})
  {
    std::array<unsigned int, dim> cells;
    cells.fill(4);
    return FluidCase<dim>(parameters,
                          boundaries,
                          dealii::Point<dim>(),
                          diagonal<dim>(box),
                          cells,
                          lumen);
  }

  template <int dim>
  FluidBoundaries<dim>
  two_ends(const double p0, const double p1, const double impedance)
  {
    auto boundaries         = all_sides<dim>(FluidBoundary::no_slip);
    boundaries.type[0]      = FluidBoundary::pressure_end;
    boundaries.type[1]      = FluidBoundary::pressure_end;
    boundaries.pressure[0]  = [p0](double) { return p0; };
    boundaries.pressure[1]  = [p1](double) { return p1; };
    boundaries.impedance[0] = boundaries.impedance[1] = impedance;
    return boundaries;
  }

  template <int dim>
  void
  rest()
  {
    auto lumen = [](const dealii::Point<dim> &x) {
      return std::hypot(x[1] - 0.016, x[dim - 1] - 0.016) - 0.0155;
    };
    auto test =
      make_case<dim>(FluidParameters(), two_ends<dim>(16e3, 16e3, 1e4), lumen);
    test.set_up(around<dim>(0.012));
    test.set_pressure([](const auto &) { return 16e3; });
    double time = 0;
    for (int i = 0; i < 20; ++i)
      test.step(time, test.op.max_stable_step());
    check(name("rest", dim),
          test.largest(test.u) < 1e-12,
          test.largest(test.u));
    unsigned int n_inactive = 0;
    for (unsigned int c = 0; c < test.op.n_owned_cells(); ++c)
      n_inactive += !test.op.is_active_cell(c);
    n_inactive = dealii::Utilities::MPI::sum(n_inactive, MPI_COMM_WORLD);
    check(name("cells outside the lumen", dim), n_inactive > 0, n_inactive);
  }

  template <int dim>
  void
  patch()
  {
    FluidParameters parameters;
    parameters.artificial_viscosity = 0.3;
    auto test = make_case<dim>(parameters, all_sides<dim>(FluidBoundary::slip));
    test.set_up(around<dim>(0.012));
    test.set_velocity([](const auto &, const int d) { return 0.3 - 0.2 * d; },
                      false);
    test.set_pressure([](const auto &) { return 500.; });
    std::vector<double> a, rate;
    test.evaluate(0, test.u, test.p, a, rate);
    check(name("uniform flow is free of divergence", dim),
          test.largest(rate) < 1e-6,
          test.largest(rate));
    double residual = 0;
    for (unsigned int c = 0; c < test.op.n_owned_cells(); ++c)
      for (unsigned int i = 0; i < (1 << dim); ++i)
        {
          const auto x    = test.corner(test.op.cell(c), i);
          const auto node = test.op.cell(c).nodes[i];
          double wall     = 1;
          for (int d = 0; d < dim; ++d)
            wall = std::min({wall, x[d], box - x[d]});
          if (wall > 1e-6 && node < test.op.n_owned_nodes())
            for (int d = 0; d < dim; ++d)
              residual = std::max(residual, std::abs(a[dim * node + d]));
        }
    check(name("uniform flow is free of forces", dim),
          dealii::Utilities::MPI::max(residual, MPI_COMM_WORLD) < 1e-9,
          residual);
  }

  /** A linear flow A x without divergence is accelerated by -A A x: exact at
   * the inner nodes of a uniform grid. */
  template <int dim>
  void
  convection()
  {
    FluidParameters parameters;
    parameters.hourglass_speed = parameters.artificial_viscosity = 0;
    auto test = make_case<dim>(parameters, all_sides<dim>(FluidBoundary::slip));
    test.set_up([](const auto &, double) { return 1u; });
    double matrix[dim][dim];
    for (int c = 0; c < dim; ++c)
      for (int d = 0; d < dim; ++d)
        matrix[c][d] = (c == d) ? (c == 0 ? dim - 1. : -1.) : 1. + c - 2. * d;
    const auto times_matrix = [&](const dealii::Point<dim> &x) {
      dealii::Point<dim> result;
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d)
          result[c] += matrix[c][d] * x[d];
      return result;
    };
    test.set_velocity([&](const auto &x,
                          const int c) { return times_matrix(x)[c]; },
                      false);
    std::vector<double> a, rate;
    test.evaluate(0, test.u, test.p, a, rate);
    double error = 0;
    for (unsigned int c = 0; c < test.op.n_owned_cells(); ++c)
      for (unsigned int i = 0; i < (1 << dim); ++i)
        {
          const auto x        = test.corner(test.op.cell(c), i);
          const auto node     = test.op.cell(c).nodes[i];
          const auto expected = times_matrix(times_matrix(x));
          double wall         = 1;
          for (int d = 0; d < dim; ++d)
            wall = std::min({wall, x[d], box - x[d]});
          if (wall > 1e-6 && node < test.op.n_owned_nodes())
            for (int d = 0; d < dim; ++d)
              error =
                std::max(error, std::abs(a[dim * node + d] + expected[d]));
        }
    check(name("acceleration of a linear flow", dim), error < 1e-10, error);
  }

  template <int dim>
  void
  random_state(FluidCase<dim> &test)
  {
    test.set_velocity(
      [](const auto &x, const int d) { return noise<dim>(x, d); });
    test.set_pressure([](const auto &x) { return 1e4 * noise<dim>(x, 5); });
  }

  /** d/dt of the energy from the right-hand side itself. */
  template <int dim>
  double
  energy_rate(FluidCase<dim> &test)
  {
    std::vector<double> a, rate;
    test.evaluate(0, test.u, test.p, a, rate);
    const FluidParameters &k = test.op.parameters();
    for (unsigned int i = 0; i < a.size(); ++i)
      a[i] *= test.op.nodal_mass(i / dim);
    for (unsigned int c = 0; c < rate.size(); ++c)
      rate[c] *= std::pow(test.op.cell(c).size, dim) /
        (k.density * k.sound_speed * k.sound_speed);
    return test.dot(a, test.u) + test.dot(rate, test.p);
  }

  template <int dim>
  void
  energy()
  {
    FluidParameters bare;
    bare.viscosity = bare.hourglass_speed = bare.checkerboard = 0;
    bare.artificial_viscosity                                 = 0;
    auto closed = make_case<dim>(bare, all_sides<dim>(FluidBoundary::slip));
    closed.set_up(around<dim>(0.012));
    random_state(closed);
    const double scale = closed.op.kinetic_energy(closed.u.data()) * 50 / 0.001;
    check(name("convection and pressure do no work", dim),
          std::abs(energy_rate(closed)) < 1e-12 * scale,
          energy_rate(closed) / scale);

    auto open =
      make_case<dim>(FluidParameters(), two_ends<dim>(2e3, -1e3, 1.5e4));
    open.set_up(around<dim>(0.012));
    random_state(open);
    const double rate = energy_rate(open);
    const auto w      = open.op.powers(0, open.local.data(), open.p.data());
    check_relative(name("power balance", dim),
                   rate,
                   w.ends - w.viscous - w.artificial - w.hourglass -
                     w.checkerboard - w.impedance,
                   1e-11);
    check(name("dissipation is positive", dim),
          w.viscous > 0 && w.hourglass > 0 && w.checkerboard > 0 &&
            w.impedance > 0);

    // the same flow of a fluid without viscosity
    FluidParameters inviscid;
    inviscid.viscosity = 0;
    auto thin          = make_case<dim>(inviscid, two_ends<dim>(0, 0, 0));
    thin.set_up(around<dim>(0.012));
    random_state(thin);
    energy_rate(thin);
    const auto v = thin.op.powers(0, thin.local.data(), thin.p.data());
    check_relative(name("dissipation by artificial viscosity", dim),
                   w.artificial,
                   v.artificial,
                   1e-12);
    check(name("all of it in a fluid without viscosity", dim), v.viscous == 0);
  }

  template <int dim>
  void
  adjointness()
  {
    auto test = make_case<dim>(FluidParameters(), two_ends<dim>(0, 0, 0));
    test.set_up(around<dim>(0.012));
    random_state(test);
    // forces on all nodes of all known cells, ghosts and hanging included
    std::vector<double> u(dim * test.op.n_local_nodes());
    std::vector<double> f(u.size(), 0.), a(test.u.size());
    test.op.gather(test.u.data(), u.data());
    for (unsigned int c = 0; c < test.op.n_known_cells(); ++c)
      for (unsigned int i = 0; i < (1 << dim); ++i)
        for (int d = 0; d < dim; ++d)
          f[dim * test.op.cell(c).nodes[i] + d] +=
            noise<dim>(test.op.cell(c).lower, 3 * i + d);
    const double local_power = test.dot(f, u);
    test.op.finish(f.data(), a.data());
    for (unsigned int i = 0; i < a.size(); ++i)
      a[i] *= test.op.nodal_mass(i / dim);
    check_relative(name("adjointness", dim),
                   test.dot(a, test.u),
                   local_power,
                   1e-10);

    // a linear field is reproduced at every corner known here
    const auto linear = [](const dealii::Point<dim> &x, const int d) {
      return 1. + x[0] * (d + 1) - 3 * x[1] + 2 * x[dim - 1];
    };
    test.set_velocity(linear, false);
    test.op.gather(test.u.data(), u.data());
    double error = 0;
    for (unsigned int c = 0; c < test.op.n_known_cells(); ++c)
      for (unsigned int i = 0; i < (1 << dim); ++i)
        for (int d = 0; d < dim; ++d)
          error =
            std::max(error,
                     std::abs(u[dim * test.op.cell(c).nodes[i] + d] -
                              linear(test.corner(test.op.cell(c), i), d)));
    check(name("linear field at hanging and ghost nodes", dim),
          error < 1e-14,
          error);
  }

  template <int dim>
  void
  location()
  {
    auto test =
      make_case<dim>(FluidParameters(), all_sides<dim>(FluidBoundary::no_slip));
    test.set_up(around<dim>(0.012));
    bool agree         = true;
    int hint           = -1;
    unsigned int found = 0;
    for (int k = 0; k < 500; ++k)
      {
        dealii::Point<dim> x;
        for (int d = 0; d < dim; ++d)
          x[d] = 0.016 + 0.018 * noise<dim>(diagonal<dim>(0.001 * k), d);
        if (k % 5 == 0) // on a face of cells
          x[0] = box / 8 * std::floor(x[0] / box * 8);
        int brute = -1;
        for (unsigned int c = 0; c < test.op.n_known_cells(); ++c)
          {
            bool inside = true;
            for (int d = 0; d < dim; ++d)
              inside = inside && x[d] >= test.op.cell(c).lower[d] &&
                x[d] < test.op.cell(c).lower[d] + test.op.cell(c).size;
            if (inside)
              brute = c;
          }
        hint  = test.op.locate(x, hint);
        agree = agree && hint == brute && test.op.locate(x) == brute;
        found += brute >= 0 &&
          static_cast<unsigned int>(brute) < test.op.n_owned_cells();
      }
    check(name("location agrees with brute force", dim), agree);
    found = dealii::Utilities::MPI::sum(found, MPI_COMM_WORLD);
    check(name("location finds most points once", dim),
          found > 250 && found < 500,
          found);
  }

  template <int dim>
  void
  transfer()
  {
    // slip walls in y and z: the normal components only are held there
    auto boundaries = two_ends<dim>(0, 0, 0);
    for (unsigned int side = 2; side < 2 * dim; ++side)
      boundaries.type[side] = FluidBoundary::slip;
    auto test = make_case<dim>(FluidParameters(), boundaries);
    test.set_up(around<dim>(0.012));
    const auto linear = [](const dealii::Point<dim> &x, const int d) {
      return d == 0 ? 1 + x[0] - 2 * x[1] + 3 * x[dim - 1] : 0.;
    };
    test.set_velocity(linear, false);
    test.set_pressure([](const auto &x) { return 1e4 * noise<dim>(x, 5); });
    const auto content = [&]() {
      double sum = 0;
      for (unsigned int c = 0; c < test.p.size(); ++c)
        sum += test.p[c] * std::pow(test.op.cell(c).size, dim);
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    };
    const double before = content();
    check(name("nothing to adapt", dim),
          !test.grid.adapt(around<dim>(0.012), test.op, test.u, test.p));
    unsigned int n_changes = 0;
    for (const double at : {0.015, 0.019, 0.021})
      n_changes += test.grid.adapt(around<dim>(at), test.op, test.u, test.p);
    check(name("adaptation changes cells", dim), n_changes == 3, n_changes);
    check(name("pressure content is kept", dim),
          std::abs(content() - before) < 1e-12 * 1e4 * std::pow(box, dim),
          content() - before);
    std::vector<double> u(dim * test.op.n_local_nodes());
    test.op.gather(test.u.data(), u.data());
    double error = 0;
    for (unsigned int c = 0; c < test.op.n_owned_cells(); ++c)
      for (unsigned int i = 0; i < (1 << dim); ++i)
        {
          const auto x = test.corner(test.op.cell(c), i);
          for (int d = 0; d < dim; ++d)
            error = std::max(error,
                             std::abs(u[dim * test.op.cell(c).nodes[i] + d] -
                                      linear(x, d)));
        }
    check(name("linear velocity is kept", dim), error < 1e-15, error);
  }

  void
  bad_box()
  {
    bool refused = false;
    try
      {
        FluidGrid<2> grid(MPI_COMM_WORLD,
                          dealii::Point<2>(),
                          dealii::Point<2>(1, 1.1),
                          {{2, 2}});
      }
    catch (const InputError &)
      {
        refused = true;
      }
    check("boxes with oblong cells are refused", refused);
  }

  template <int dim>
  void
  run()
  {
    rest<dim>();
    patch<dim>();
    convection<dim>();
    energy<dim>();
    adjointness<dim>();
    location<dim>();
    transfer<dim>();
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  run<2>();
  run<3>();
  bad_box();
}
