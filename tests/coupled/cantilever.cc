// Periods of a cantilever that vibrates under water, for two densities of the
// solid and two sizes of the fluid's cells, against the added mass of potential
// theory.

#include "coupled_case.h"

using namespace coapt;

namespace
{
  const double water = 1060; // density, kg/m^3

  /** A strip that stands on the floor of a long closed basin. */
  struct Cantilever
  {
    double cell      = 0.5e-3; // of the fluid, m
    double density   = 1060;   // of the solid, kg/m^3
    double length    = 10e-3;
    double thickness = 1e-3;
    double height    = 20e-3; // of the basin
    double width     = 40e-3; // of the basin

    CoupledSetup<2>
    setup() const
    {
      CoupledSetup<2> s;
      s.upper = dealii::Point<2>(width, height);
      s.cells = {{static_cast<unsigned int>(std::lround(width / cell)),
                  static_cast<unsigned int>(std::lround(height / cell))}};
      s.boundaries.type.fill(FluidBoundary::slip);
      s.fluid.viscosity            = 0;
      s.fluid.artificial_viscosity = 0;

      const Cantilever strip = *this;
      s.block                = make_block<2>(
        {{static_cast<unsigned int>(std::lround(2 * thickness / cell)),
                         static_cast<unsigned int>(std::lround(2 * length / cell))}},
        [=](const dealii::Point<2> &r) {
          return dealii::Point<2>(0.5 * strip.width + 0.13e-3 +
                                    (r[0] - 0.5) * strip.thickness,
                                  r[1] * strip.length);
        });
      s.pinned = s.block.nodes_where(
        [](const dealii::Point<2> &r) { return r[1] < 1e-9; });
      s.spacing = 0.5 * cell;

      s.solid.material           = "neo-Hookean";
      s.solid.density            = density;
      s.solid.viscosity          = 0;
      s.solid.neo_hookean.mu     = 500e3;
      s.solid.neo_hookean.lambda = 500e3;
      return s;
    }
  };

  /** Lateral displacement of the strip's end. */
  double
  end_displacement(const Block<2> &block, const std::vector<double> &X)
  {
    const unsigned int last = block.unit.size() - 1;
    return X[2 * last] - block.mesh.points[last][0];
  }

  /** Measures a period from the times at which a signal changes its sign. */
  class Crossings
  {
  public:
    void
    add(const double t, const double value)
    {
      if (last_value * value < 0)
        times.push_back(last_time +
                        (t - last_time) * last_value / (last_value - value));
      last_time  = t;
      last_value = value;
    }

    unsigned int
    number() const
    {
      return times.size();
    }

    /** The last two half periods. */
    double
    period() const
    {
      return times.back() - times[times.size() - 3];
    }

  private:
    std::vector<double> times;
    double last_time = 0, last_value = 0;
  };

  /** Acceleration (m/s^2) that sets the strip going. */
  double
  push(const double t)
  {
    const double duration = 4e-3;
    return t < duration ? 4 * (1 - std::cos(2 * M_PI * t / duration)) : 0.;
  }

  /** Period of the strip in vacuum (s). */
  double
  dry_period(const Cantilever &strip)
  {
    const CoupledSetup<2> s = strip.setup();
    const SolidOperator<2> solid(s.block.mesh, s.solid, {}, {}, MPI_COMM_SELF);
    std::vector<double> y = as_array(s.block.mesh.points);
    const unsigned int n  = y.size();
    y.resize(2 * n, 0.);
    ExplicitIntegrator integrator(
      MPI_COMM_SELF,
      [&](const double t, const double *y, double *y_dot) {
        std::copy_n(y + n, n, y_dot);
        double *force = y_dot + n;
        std::fill_n(force, n, 0.);
        solid.add_forces(y, y + n, force);
        for (unsigned int i = 0; i < n; ++i)
          force[i] = s.pinned[i / 2]
            ? 0.
            : force[i] / solid.mass()[i / 2] + (i % 2 == 0 ? push(t) : 0.);
      },
      [](double, double *) {});
    const auto bound = solid.step_bound(y.data());
    const double dt  = 0.7 * kinnmark_gray_limit(bound.xi) / bound.omega;
    integrator.start(0, y);
    Crossings crossings;
    while (crossings.number() < 3)
      {
        integrator.step(dt);
        crossings.add(integrator.time(), end_displacement(s.block, y));
      }
    return crossings.period();
  }

  /** Period of the strip under water (s). */
  double
  wet_period(const Cantilever &strip)
  {
    CoupledCase<2> c(strip.setup());
    c.system.add_load(
      [&](const double t, const double *, const double *, double *F) {
        for (unsigned int i = 0; i < c.solid.mass().size(); ++i)
          F[2 * i] += c.solid.mass()[i] * push(t);
      });
    const double dt = 0.7 * c.smaller_limit();
    Crossings crossings;
    while (crossings.number() < 3)
      {
        c.step(dt);
        const auto X = c.system.solid_positions(c.y.data());
        crossings.add(c.integrator.time(), end_displacement(c.block, X));
      }
    return crossings.period();
  }

  /** First bending mode of a clamped beam at the height s of its length. */
  double
  mode(const double s)
  {
    const double k = 1.8751040687, q = 0.7340955;
    return 0.5 *
      (std::cosh(k * s) - std::cos(k * s) -
       q * (std::sinh(k * s) - std::sin(k * s)));
  }

  /** What the periods say of the mass of the water that moves with the strip,
   * over that of the water in its place, which is a part of it: the solid is as
   * stiff under water as in vacuum. */
  double
  measured_mass(const Cantilever &strip, const double period)
  {
    const double ratio = period / dry_period(strip);
    return (ratio * ratio - 1) * strip.density / water;
  }

  /** The same by potential theory in the plane, for the mode of the strip in
   * vacuum between floor and ceiling. The mapping t = tan(pi y/(2 height))
   * makes one cut of a thin strip and its images, along which the jump of the
   * potential is a sine series. The strip's thickness makes it longer by 0.33
   * times that: by what rectangles of 10 to 1 have more added mass than plates
   * (a factor of 1.14; Newman, Marine Hydrodynamics, 1977). */
  double
  theoretical_mass(const Cantilever &strip)
  {
    const unsigned int n_points = 2000, n_terms = 20;
    const double length = strip.length + 0.33 * strip.thickness;
    const double scale  = M_PI / (2 * strip.height);
    const double T      = std::tan(scale * length);
    std::vector<double> a(n_terms + 1, 0.);
    double squares = 0; // mean of the mode's square
    for (unsigned int i = 0; i < n_points; ++i)
      {
        const double theta    = M_PI * (i + 0.5) / n_points;
        const double t        = T * std::cos(theta);
        const double y        = std::atan(std::abs(t)) / scale;
        const double velocity = mode(y / length) / (scale * (1 + t * t));
        for (unsigned int n = 1; n <= n_terms; ++n)
          a[n] +=
            velocity * std::sin(theta) * std::sin(n * theta) / (n * n_points);
        squares += std::pow(mode((i + 0.5) / n_points), 2) / n_points;
      }
    double added = 0;
    for (unsigned int n = 1; n <= n_terms; ++n)
      added += 2 * M_PI * T * T * n * a[n] * a[n];
    return 1 + added / (squares * strip.thickness * strip.length);
  }

  void
  cantilever()
  {
    const double theory = theoretical_mass({});
    double excess[2];
    for (const int i : {0, 1})
      {
        Cantilever heavy;
        heavy.cell       = i == 0 ? 1e-3 : 0.5e-3;
        Cantilever light = heavy;
        light.density /= 2;
        const std::string name = i == 0 ? "1 mm, " : "0.5 mm, ";
        const double slow = wet_period(heavy), fast = wet_period(light);
        const double mass = measured_mass(heavy, slow);
        check_relative(name + "mass of the water, from half the density",
                       measured_mass(light, fast),
                       mass,
                       0.04);
        check_relative(name + "ratio of the periods of both densities",
                       fast / slow,
                       std::sqrt((light.density / water + theory) /
                                 (heavy.density / water + theory)),
                       0.005);
        excess[i] = mass - theory;
      }
    // All corners of the cells that the strip reaches into follow it.
    check("mass of the water, error of first order",
          excess[0] > 1.6 * excess[1] && excess[0] < 2.5 * excess[1],
          excess[0] / excess[1]);
    check_relative("mass of the water, extrapolated",
                   theory + 2 * excess[1] - excess[0],
                   theory,
                   0.05);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  cantilever();
}
