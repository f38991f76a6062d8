// What the coupling must conserve in any state: power, momentum and angular
// momentum pass from solid to fluid without loss, also across hanging nodes
// and beside walls; and the number of ranks does not matter.

#include "coupled_case.h"

using namespace coapt;
using dealii::Point;

namespace
{
  template <int dim>
  Point<dim>
  diagonal(const double x)
  {
    Point<dim> p;
    for (int d = 0; d < dim; ++d)
      p[d] = x;
    return p;
  }

  /** A tilted block in a closed box, half of it in finer cells; in the middle,
   * or beside the lower walls and partly beyond them. */
  template <int dim>
  CoupledSetup<dim>
  tilted_block(const bool beside_wall)
  {
    CoupledSetup<dim> s;
    s.upper = diagonal<dim>(16e-3);
    s.cells.fill(8);
    s.boundaries.type.fill(FluidBoundary::no_slip);
    s.level = [](const Point<dim> &x, double) { return x[0] < 8e-3 ? 1u : 0u; };
    s.fluid.convection = false;

    std::array<unsigned int, dim> n;
    n.fill(5);
    n[0]                  = 2;
    const Point<dim> base = diagonal<dim>(beside_wall ? 0.2e-3 : 5.4e-3);
    s.block               = make_block<dim>(n, [=](const Point<dim> &r) {
      Point<dim> x = base;
      x[0] += 1e-3 * r[0] + 4e-3 * r[1];
      x[1] += 4.5e-3 * r[1] - 0.5e-3 * r[0];
      if (dim == 3)
        x[dim - 1] += 4e-3 * r[dim - 1] + 0.7e-3 * r[0];
      return x;
    });
    s.pinned.assign(s.block.unit.size(), false);
    s.spacing              = 0.5e-3;
    s.solid.material       = "neo-Hookean";
    s.solid.density        = 1300;
    s.solid.neo_hookean.mu = 50e3;
    return s;
  }

  double
  sum(const double x)
  {
    return dealii::Utilities::MPI::sum(x, MPI_COMM_WORLD);
  }

  double
  dot(const std::vector<double> &a, const std::vector<double> &b)
  {
    double result = 0;
    for (unsigned int i = 0; i < a.size(); ++i)
      result += a[i] * b[i];
    return sum(result);
  }

  template <int dim>
  void
  coupling_forces(const std::string &name, const bool beside_wall)
  {
    CoupledCase<dim> c(tilted_block<dim>(beside_wall));
    c.set_velocity([](const auto &x, int d) { return noise(x, d); },
                   [](const auto &x, int d) { return noise(x, 7 + d); });
    const RelaxationCoefficients k = {1e13, 2e8};
    const std::vector<double> u    = c.system.local_velocity(c.y.data());
    const std::vector<double> V    = c.system.solid_velocities(c.y.data());
    const std::vector<double> X    = c.system.solid_positions(c.y.data());
    std::vector<double> lambda(dim * c.points.n_owned()), rate(lambda.size());
    for (unsigned int i = 0; i < lambda.size(); ++i)
      lambda[i] = 1e8 * std::sin(37. * i * i);
    std::vector<double> f(u.size(), 0.), F(V.size(), 0.);
    c.points.add_forces(
      k, u.data(), V.data(), lambda.data(), f.data(), F.data(), rate.data());

    // Energy is quadratic in the multiplier: a central difference is exact.
    const double step = 1e-5;
    double change     = 0;
    for (const double sign : {-1., 1.})
      {
        std::vector<double> shifted = lambda;
        for (unsigned int i = 0; i < lambda.size(); ++i)
          shifted[i] += sign * step * rate[i];
        change += sign / (2 * step) *
          c.points.energy_and_power(k, u.data(), V.data(), shifted.data())
            .energy;
      }
    const double drag =
      c.points.energy_and_power(k, u.data(), V.data(), lambda.data())
        .dissipation;
    const double to_fluid = dot(f, u), to_solid = dot(F, V);
    const double power_error = std::abs(to_fluid + to_solid + drag + change) /
      (std::abs(to_fluid) + std::abs(to_solid));
    check(name + ", power", power_error < 1e-12, power_error);

    double scale = 0, force_error = 0, torque_error = 0;
    c.fluid.sum_forces(f.data());
    for (const double value : F)
      scale += std::abs(value);
    scale = sum(scale);
    for (int d = 0; d < dim; ++d)
      {
        const int e  = (d + 1) % dim;
        double force = 0, torque = 0;
        for (unsigned int n = 0; n < c.fluid.n_owned_nodes(); ++n)
          {
            const Point<dim> &x = c.fluid.position(n);
            force += f[dim * n + d];
            torque += x[d] * f[dim * n + e] - x[e] * f[dim * n + d];
          }
        for (unsigned int n = 0; n < X.size() / dim; ++n)
          {
            force += F[dim * n + d];
            torque +=
              X[dim * n + d] * F[dim * n + e] - X[dim * n + e] * F[dim * n + d];
          }
        force_error  = std::max(force_error, std::abs(sum(force)) / scale);
        torque_error = std::max(torque_error, std::abs(sum(torque)) / scale);
      }
    check(name + ", momentum", force_error < 1e-13, force_error);
    // Rescaled weights move a force by up to a cell.
    if (!beside_wall)
      check(name + ", angular momentum", torque_error < 1e-14, torque_error);
  }

  /** If the solid moves as the fluid does, nothing acts; in the middle, or
   * beside walls that move, too. */
  template <int dim>
  void
  rigid_motion(const std::string &name, const bool beside_walls)
  {
    const auto motion = [](const Point<dim> &x, const int d) {
      return d == 0 ? 0.3 - 20 * x[1] : (d == 1 ? 20 * x[0] : 0.1);
    };
    CoupledSetup<dim> setup = tilted_block<dim>(beside_walls);
    setup.boundaries.type.fill(FluidBoundary::velocity);
    setup.boundaries.velocity = [&](const Point<dim> &x, double) {
      dealii::Tensor<1, dim> u;
      for (int d = 0; d < dim; ++d)
        u[d] = motion(x, d);
      return u;
    };
    CoupledCase<dim> c(setup);
    c.set_velocity(motion);
    c.fluid.set_boundary_velocity(0, c.y.data() + c.system.layout().velocity());
    c.system.begin_step(10e-6);
    std::vector<double> rate(c.y.size());
    c.system.rhs(0, c.y.data(), rate.data());
    double largest = 0;
    for (std::size_t i = c.system.layout().multiplier(); i < rate.size(); ++i)
      largest = std::max(largest, std::abs(rate[i]));
    const double slip = largest / c.system.relaxation().stiffness;
    check(name + ", no slip in rigid motion", slip < 1e-13, slip);
  }

  /** Total momentum of a free block and of the fluid around it, both in
   * unrest that does not reach the walls. */
  template <int dim>
  void
  total_momentum(const std::string &name)
  {
    CoupledCase<dim> c(tilted_block<dim>(false));
    const auto inside = [](const Point<dim> &x) {
      bool result = true;
      for (int d = 0; d < dim; ++d)
        result = result && x[d] > 4.1e-3 && x[d] < 11.9e-3;
      return result;
    };
    c.set_velocity([&](const auto &x,
                       int d) { return inside(x) ? noise(x, d) : 0.; },
                   [](const auto &x, int d) { return noise(x, 7 + d); });
    const auto &at = c.system.layout();
    for (unsigned int i = 0; i < at.n_fluid_cells; ++i)
      if (inside(c.fluid.cell(i).lower))
        c.y[at.pressure() + i] = 1e4 * noise(c.fluid.cell(i).lower, 3);
    for (unsigned int i = 0; i < dim * at.n_points; ++i)
      c.y[at.multiplier() + i] = 1e8 * std::sin(37. * i * i);
    for (unsigned int n = 0; n < at.n_solid_nodes; ++n)
      for (int d = 0; d < dim; ++d)
        c.y[at.position() + dim * n + d] *= 1 + 0.01 * d;

    c.system.finish_step(0, c.y.data());
    c.system.begin_step(10e-6);
    std::vector<double> rate(c.y.size());
    c.system.rhs(0, c.y.data(), rate.data());
    const std::vector<double> V_rate =
      c.system.solid_velocities(rate.data()); // of all ranks
    double total[dim] = {}, scale = 0;
    const bool first =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    for (unsigned int n = 0; n < at.n_fluid_nodes; ++n)
      for (int d = 0; d < dim; ++d)
        total[d] += c.fluid.nodal_mass(n) * rate[at.velocity() + dim * n + d];
    for (unsigned int i = 0; first && i < V_rate.size(); ++i)
      {
        total[i % dim] += c.solid.mass()[i / dim] * V_rate[i];
        scale += std::abs(c.solid.mass()[i / dim] * V_rate[i]);
      }
    scale        = sum(scale);
    double error = 0;
    for (int d = 0; d < dim; ++d)
      error = std::max(error, std::abs(sum(total[d])) / scale);
    check(name + ", momentum of fluid and solid", error < 1e-13, error);
  }

  /** The same computation by each rank alone and by all ranks together, from
   * fluid and solid velocities @p velocity. Returns how often coupling points
   * had to change their rank. */
  unsigned int
  compare_ranks(const std::string &name,
                const CoupledSetup<2> &setup,
                const CoupledCase<2>::Field &velocity,
                const double dt,
                const unsigned int n_steps)
  {
    std::vector<double> X[2];
    double energy[2];
    unsigned int i = 0, redistributions = 0;
    for (const MPI_Comm communicator : {MPI_COMM_SELF, MPI_COMM_WORLD})
      {
        CoupledCase<2> c(setup, communicator);
        c.set_velocity(velocity);
        for (unsigned int n = 0; n < n_steps; ++n)
          c.step(dt);
        X[i]            = c.system.solid_positions(c.y.data());
        energy[i]       = c.energy();
        redistributions = c.redistributions;
        ++i;
      }
    double moved = 0, difference = 0;
    const std::vector<double> X0 = as_array(setup.block.mesh.points);
    for (unsigned int j = 0; j < X0.size(); ++j)
      {
        moved      = std::max(moved, std::abs(X[0][j] - X0[j]));
        difference = std::max(difference, std::abs(X[1][j] - X[0][j]));
      }
    check(name + ", it moves", moved > 1e-3, moved);
    check(name + ", positions on any number of ranks",
          difference < 1e-9 * moved,
          difference / moved);
    const double relative = std::abs(energy[1] / energy[0] - 1);
    check(name + ", energy on any number of ranks", relative < 1e-9, relative);
    return redistributions;
  }

  void
  ranks()
  {
    Plate plate;
    plate.cell              = 2e-3;
    plate.spacing           = 0.25;
    plate.ramp              = 4e-3;
    CoupledSetup<2> channel = plate.setup();
    channel.level           = [](const Point<2> &x, double) {
      return std::abs(x[0] - 20e-3) < 4e-3 ? 1u : 0u;
    };
    compare_ranks(
      "plate", channel, [](const auto &, int) { return 0.; }, 6e-6, 900);

    // A block that turns with a vortex goes from rank to rank.
    CoupledSetup<2> box = tilted_block<2>(false);
    box.boundaries.type.fill(FluidBoundary::slip);
    box.fluid.convection = true;
    box.level = [](const Point<2> &x, double) { return x[1] < 8e-3 ? 1u : 0u; };
    const auto vortex = [](const Point<2> &x, const int d) {
      const double k = dealii::numbers::PI / 16e-3;
      return d == 0 ? 3 * std::sin(k * x[0]) * std::cos(k * x[1])
                    : -3 * std::cos(k * x[0]) * std::sin(k * x[1]);
    };
    const unsigned int redistributions =
      compare_ranks("block in a vortex", box, vortex, 4e-6, 1500);
    check("block in a vortex, points change their rank",
          redistributions > 0 ||
            dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1);
  }

  template <int dim>
  void
  conservation(const std::string &name)
  {
    coupling_forces<dim>(name + " in the middle", false);
    coupling_forces<dim>(name + " beside walls", true);
    rigid_motion<dim>(name + " in the middle", false);
    rigid_motion<dim>(name + " beside walls", true);
    total_momentum<dim>(name);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  conservation<2>("2D");
  conservation<3>("3D");
  ranks();
}
