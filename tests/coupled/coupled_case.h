#ifndef coapt_tests_coupled_coupled_case_h
#define coapt_tests_coupled_coupled_case_h

#include <coapt/coupled/coupled_system.h>
#include <coapt/geometry/coupling_lattice.h>
#include <coapt/time/explicit_integrator.h>
#include <coapt/time/stability_limit.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "block.h"
#include "tests.h"

/** What a coupled computation is made of. */
template <int dim>
struct CoupledSetup
{
  coapt::FluidParameters fluid;
  coapt::FluidBoundaries<dim> boundaries;
  dealii::Point<dim> lower, upper;
  std::array<unsigned int, dim> cells{};
  typename coapt::FluidGrid<dim>::WantedLevel level;

  Block<dim> block;
  std::vector<bool> pinned;
  coapt::SolidParameters solid;

  coapt::ImmersionParameters immersion;
  double spacing = 0; // of the coupling points, m
};

/** A free @p block with points @p spacing (m) apart, in a box of 16 mm with
 * cells of 1 mm and walls all around. */
template <int dim>
CoupledSetup<dim>
free_in_box(const Block<dim> &block, const double spacing)
{
  CoupledSetup<dim> s;
  for (int d = 0; d < dim; ++d)
    s.upper[d] = 16e-3;
  s.cells.fill(16);
  s.boundaries.type.fill(coapt::FluidBoundary::no_slip);
  s.block = block;
  s.pinned.assign(s.block.unit.size(), false);
  s.spacing        = spacing;
  s.solid.material = "neo-Hookean";
  return s;
}

/** A block in a box of fluid, with its state and its integrator. */
template <int dim>
struct CoupledCase
{
  explicit CoupledCase(const CoupledSetup<dim> &setup,
                       MPI_Comm communicator = MPI_COMM_WORLD)
    : communicator(communicator)
    , block(setup.block)
    , grid(communicator, setup.lower, setup.upper, setup.cells)
    , fluid(setup.fluid, setup.boundaries, {})
    , solid(block.mesh, setup.solid, {}, {}, communicator)
    , points(block.mesh,
             coapt::simplex_lattice(block.mesh, setup.spacing),
             communicator)
    , system(fluid,
             solid,
             points,
             setup.pinned,
             setup.immersion,
             setup.solid.density,
             setup.fluid.density,
             timing,
             communicator)
    , integrator(
        communicator,
        [this](double t, const double *y, double *y_dot) {
          system.rhs(t, y, y_dot);
        },
        [this](double t, double *y) { system.finish_step(t, y); })
  {
    if (setup.level)
      grid.refine_to(setup.level);
    fluid.reinit(grid);
    y = system.state_at_rest(block.mesh.points);
  }

  CoupledCase(const CoupledCase &) = delete;

  /** Sets fluid and solid velocities (m/s) to f(position, component), or to
   * g(position, component) in the solid if it is given. */
  using Field = std::function<double(const dealii::Point<dim> &, int)>;
  void
  set_velocity(const Field &f, const Field &g = {})
  {
    const auto &at = system.layout();
    for (unsigned int n = 0; n < fluid.n_owned_nodes(); ++n)
      for (int d = 0; d < dim; ++d)
        y[at.velocity() + dim * n + d] = f(fluid.position(n), d);
    fluid.apply_constraints(y.data() + at.velocity());
    for (unsigned int n = 0; n < at.n_solid_nodes; ++n)
      {
        dealii::Point<dim> x;
        for (int d = 0; d < dim; ++d)
          x[d] = y[at.position() + dim * n + d];
        for (int d = 0; d < dim; ++d)
          y[at.solid_velocity() + dim * n + d] = g ? g(x, d) : f(x, d);
      }
  }

  /** A step, with the coefficients of the relaxed multiplier that belong to
   * it or with prescribed ones. */
  void
  step(const double dt,
       const coapt::RelaxationCoefficients *prescribed = nullptr)
  {
    if (!started)
      integrator.start(0, y);
    started = true;
    if (prescribed)
      system.begin_step(dt, *prescribed);
    else
      system.begin_step(dt);
    integrator.step(dt);
    if (system.points_have_left())
      {
        system.redistribute_points(y);
        ++redistributions;
        integrator.start(integrator.time(), y);
      }
  }

  /** Stability limits of fluid and solid for the method of Kinnmark and
   * Gray (s). */
  double
  smaller_limit() const
  {
    const std::vector<double> X = system.solid_positions(y.data());
    const auto bound            = solid.step_bound(X.data());
    return std::min(fluid.max_stable_step(),
                    coapt::kinnmark_gray_limit(bound.xi) / bound.omega);
  }

  /** Energy, power and slip of the multipliers. */
  typename coapt::CouplingPoints<dim>::EnergyAndPower
  coupling() const
  {
    const std::vector<double> V = system.solid_velocities(y.data());
    const std::vector<double> u = system.local_velocity(y.data());
    return points.energy_and_power(system.relaxation(),
                                   u.data(),
                                   V.data(),
                                   y.data() + system.layout().multiplier());
  }

  /** All energies: kinetic of fluid and solid, of compression, elastic, and
   * that of the multiplier (J). */
  double
  energy() const
  {
    const auto &at              = system.layout();
    const std::vector<double> X = system.solid_positions(y.data());
    const std::vector<double> V = system.solid_velocities(y.data());
    return fluid.kinetic_energy(y.data() + at.velocity()) +
      fluid.acoustic_energy(y.data() + at.pressure()) +
      solid.kinetic_energy(V.data()) + solid.elastic_energy(X.data()) +
      coupling().energy;
  }

  /** Flow (m^3/s) out of the box through a side. */
  double
  flow(const unsigned int side) const
  {
    return fluid.flux(side, system.local_velocity(y.data()).data());
  }

  MPI_Comm communicator;
  Block<dim> block;
  coapt::FluidGrid<dim> grid;
  coapt::FluidOperator<dim> fluid;
  coapt::SolidOperator<dim> solid;
  coapt::CouplingPoints<dim> points;
  coapt::Timing timing;
  coapt::CoupledSystem<dim> system;
  coapt::ExplicitIntegrator integrator;
  std::vector<double> y;

  /** How often coupling points have left their rank. */
  unsigned int redistributions = 0;

private:
  bool started = false;
};

/** Rises smoothly from 0 at t = 0 to 1 at t = @p end. */
inline double
smooth_ramp(const double t, const double end)
{
  const double s = std::min(1., std::max(0., t / end));
  return s * s * s * (10 + s * (6 * s - 15));
}

/** A number in (-1, 1) that depends on the position alone. */
template <int dim>
double
noise(const dealii::Point<dim> &x, const int seed)
{
  double phase = 0.7 * seed + 0.3;
  for (int d = 0; d < dim; ++d)
    phase += (7123.1 + 1713.7 * d + 311.3 * seed) * x[d];
  const double s = 437.585 * std::sin(phase);
  return 2 * (s - std::floor(s)) - 1;
}

/** An elastic plate across a channel in 2D, under a pressure from the left. */
struct Plate
{
  double cell      = 1e-3;   // of the fluid, m
  double element   = 0.5e-3; // of the solid, m
  double spacing   = 0.5;    // of the coupling points, in fluid cells
  double length    = 40e-3;  // of the channel
  double height    = 20e-3;  // of the channel
  double x         = 20.13e-3;
  double thickness = 1e-3;
  double tilt      = 1.37e-3;
  double bow       = 1e-3;
  double gap       = 0; // between the lower end of the plate and the wall
  double pressure  = 16e3;
  double ramp      = 20e-3; // s
  double impedance = 0.3;   // of both ends, in rho c
  bool rigid       = false; // all nodes held, instead of those of both ends
  coapt::FluidBoundary wall = coapt::FluidBoundary::no_slip;

  CoupledSetup<2>
  setup() const
  {
    CoupledSetup<2> s;
    const double p_max = pressure, time = ramp;
    s.upper           = dealii::Point<2>(length, height);
    s.cells           = {{static_cast<unsigned int>(std::lround(length / cell)),
                          static_cast<unsigned int>(std::lround(height / cell))}};
    s.boundaries.type = {{coapt::FluidBoundary::pressure_end,
                          coapt::FluidBoundary::pressure_end,
                          wall,
                          wall}};
    s.boundaries.pressure[0] = [=](const double t) {
      return p_max * smooth_ramp(t, time);
    };
    s.boundaries.pressure[1]  = [](double) { return 0.; };
    s.boundaries.impedance[0] = s.boundaries.impedance[1] =
      impedance * s.fluid.density * s.fluid.sound_speed;

    const Plate plate = *this;
    s.block           = make_block<2>(
      {{static_cast<unsigned int>(std::lround(thickness / element)),
                  static_cast<unsigned int>(std::lround(height / element))}},
      [=](const dealii::Point<2> &r) {
        const double e = 2 * r[1] - 1;
        return dealii::Point<2>(plate.x + plate.tilt * e +
                                  plate.bow * (1 - e * e) +
                                  (r[0] - 0.5) * plate.thickness,
                                plate.gap + r[1] * (plate.height - plate.gap));
      });
    s.pinned  = s.block.nodes_where([=](const dealii::Point<2> &r) {
      return plate.rigid || r[1] < 1e-9 || r[1] > 1 - 1e-9;
    });
    s.spacing = spacing * cell;

    s.solid.material           = "neo-Hookean";
    s.solid.viscosity          = 0;
    s.solid.neo_hookean.mu     = 500e3;
    s.solid.neo_hookean.lambda = 2.5e6;
    return s;
  }
};

/** A plate clamped across a small closed box without any dissipation but that
 * of the coupling. */
inline CoupledSetup<2>
closed_box(
  const double damping_ratio = coapt::ImmersionParameters().damping_ratio)
{
  Plate plate;
  plate.length      = 16e-3;
  plate.height      = 8e-3;
  plate.x           = 8.13e-3;
  CoupledSetup<2> s = plate.setup();
  s.boundaries.type.fill(coapt::FluidBoundary::no_slip);
  s.fluid.viscosity            = 0;
  s.fluid.artificial_viscosity = 0;
  s.fluid.hourglass_speed      = 0;
  s.fluid.checkerboard         = 0;
  s.immersion.damping_ratio    = damping_ratio;
  return s;
}

/** Position of the middle of the plate's thickness at each height. */
inline std::vector<dealii::Point<2>>
mid_line(const Block<2> &block, const std::vector<double> &X)
{
  std::vector<dealii::Point<2>> line;
  for (unsigned int n = 0; n < block.unit.size(); ++n)
    for (const double side : {0., 1.})
      if (block.unit[n][0] == side)
        {
          if (side == 0)
            line.emplace_back();
          line.back() += 0.5 * dealii::Tensor<1, 2>({X[2 * n], X[2 * n + 1]});
        }
  return line;
}

/** Area between the plate and the line x = 0. */
inline double
area_behind(const Block<2> &block, const std::vector<double> &X)
{
  const auto line = mid_line(block, X);
  double area     = 0;
  for (unsigned int i = 0; i + 1 < line.size(); ++i)
    area += 0.5 * (line[i][0] + line[i + 1][0]) * (line[i + 1][1] - line[i][1]);
  return area;
}

/** How far the middle of the plate has moved along the channel. */
inline double
mid_deflection(const Block<2> &block, const std::vector<double> &X)
{
  const auto now       = mid_line(block, X);
  const auto then      = mid_line(block, as_array(block.mesh.points));
  const unsigned int i = now.size() / 2;
  return now[i][0] - then[i][0];
}

/** What one sees of the plate. */
struct PlateResult
{
  double leak       = 0; // mean velocity past or through it, m/s
  double deflection = 0; // mean deflection of its middle, m
  double wobble     = 0; // half the range of the deflection, m
};

/** Runs until @p end and averages from @p begin on. */
inline PlateResult
run_plate(CoupledCase<2> &c,
          const Plate &plate,
          const double dt,
          const double begin,
          const double end)
{
  double volume = 0, area = 0, start = 0, sum = 0, low = 1, high = -1;
  unsigned int samples = 0;
  while (c.integrator.time() < end - 0.5 * dt)
    {
      c.step(dt);
      if (c.integrator.time() < begin)
        continue;
      const auto X = c.system.solid_positions(c.y.data());
      if (samples++ == 0)
        {
          area  = area_behind(c.block, X);
          start = c.integrator.time();
        }
      else
        volume += dt * c.flow(1);
      const double x = mid_deflection(c.block, X);
      sum += x;
      low  = std::min(low, x);
      high = std::max(high, x);
    }
  const auto X = c.system.solid_positions(c.y.data());
  PlateResult result;
  result.leak = (volume - (area_behind(c.block, X) - area)) /
    (c.integrator.time() - start) / plate.height;
  result.deflection = sum / samples;
  result.wobble     = 0.5 * (high - low);
  return result;
}

#endif
