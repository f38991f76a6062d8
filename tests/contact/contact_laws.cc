// Contact of sheets: conservation, Coulomb's law, bouncing.

#include <coapt/base/exceptions.h>
#include <coapt/contact/mid_surface_contact.h>

#include "sheets.h"
#include "tests.h"

#include <limits>
#include <memory>

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  double
  noise()
  {
    return std::rand() / (0.5 * RAND_MAX) - 1;
  }

  /** Momentum and angular momentum (about the origin), summed by node. */
  std::array<Tensor<1, 3>, 2>
  momenta(const Sheets &sheets)
  {
    std::array<Tensor<1, 3>, 2> sums;
    for (unsigned int n = 0; n < sheets.mass.size(); ++n)
      {
        const Point<3> x(sheets.X[3 * n],
                         sheets.X[3 * n + 1],
                         sheets.X[3 * n + 2]);
        const Point<3> v(sheets.V[3 * n],
                         sheets.V[3 * n + 1],
                         sheets.V[3 * n + 2]);
        sums[0] += sheets.mass[n] * v;
        sums[1] += sheets.mass[n] * cross_product_3d(x, v);
      }
    return sums;
  }

  // Two wavy strips of different meshes that are pressed into each other at
  // random velocities.
  void
  conservation()
  {
    for (const double friction : {0., 0.3})
      {
        Sheets sheets;
        for (const double side : {-1., 1.})
          sheets.add(
            {{side > 0 ? 9u : 6u, side > 0 ? 7u : 5u}},
            [=](const double a, const double b, const double t) {
              return Point<3>(8e-3 * a,
                              6e-3 * b + 1e-4 * side,
                              0.45e-3 * side + 1e-4 * std::sin(9 * a + 5 * b) +
                                t);
            },
            48e-6,
            false);
        // Centres of mass off the mid-surface, as at corners of tetrahedra.
        for (double &mass : sheets.mass)
          mass *= 1 + 0.3 * noise();
        // Far apart in the reference, so that they are no neighbours.
        Sheets reference = sheets;
        for (unsigned int n = 0; n < reference.mass.size() / 2; ++n)
          reference.leaflet.mesh.points[n][2] -= 0.1;
        for (double &v : sheets.V)
          v = 0.1 * noise();

        ContactParameters parameters;
        parameters.clearance = 0;
        parameters.friction  = friction;
        MidSurfaceContact contact(reference.leaflet,
                                  sheets.mass,
                                  Sheets::density,
                                  parameters,
                                  MPI_COMM_WORLD);
        const auto before   = momenta(sheets);
        const double energy = sheets.kinetic_energy();
        const double dt     = 5e-6;
        const auto result =
          contact.apply_impulse(sheets.X.data(), sheets.V.data(), dt);
        const auto after       = momenta(sheets);
        const double impulse   = dt * result.normal_force;
        const std::string name = friction > 0 ? " with friction" : "";

        check("strips touch" + name, result.pairs > 50, result.pairs);
        check("action = reaction" + name,
              (after[0] - before[0]).norm() < 1e-12 * impulse,
              (after[0] - before[0]).norm() / impulse);
        check("moments balance" + name,
              (after[1] - before[1]).norm() < 1e-12 * impulse * 8e-3,
              (after[1] - before[1]).norm() / impulse);
        check_relative("work = change of kinetic energy" + name,
                       dt * (result.normal_power + result.friction_power),
                       sheets.kinetic_energy() - energy,
                       1e-9);
        check("friction dissipates" + name,
              friction > 0 ? result.friction_power < 0
                           : result.friction_power == 0,
              result.friction_power);
      }
  }

  // A block on a pinned plane, gravity tilted by the angle: it rests below
  // tan(angle) = mu, and slides with g (sin - mu cos) above. The mean of the
  // second half of the time counts, since first the spring of friction is
  // loaded.
  double
  slide(const double angle, const double duration)
  {
    Sheets sheets;
    sheets.add_rectangle({{30, 12}},
                         Point<3>(-15e-3, -6e-3, 0),
                         {{30e-3, 12e-3}},
                         true);
    sheets.add_rectangle({{7, 5}},
                         Point<3>(-6e-3, -2e-3, 5e-3),
                         {{6e-3, 4e-3}},
                         false);
    ContactParameters parameters;
    parameters.clearance     = 0.1e-3;
    parameters.friction      = 0.2;
    parameters.max_stiffness = 1e8;
    MidSurfaceContact contact(
      sheets.leaflet, sheets.mass, Sheets::density, parameters, MPI_COMM_WORLD);

    // From the depth of equilibrium on, so that it neither falls nor jumps.
    const double g     = 100;
    const double depth = Sheets::density * Sheets::thickness * g *
      std::cos(angle) / parameters.max_stiffness;
    for (unsigned int n = 0; n < sheets.mass.size(); ++n)
      if (!sheets.leaflet.pinned[n])
        sheets.X[3 * n + 2] += 1.1e-3 - depth - 5e-3;

    const double dt            = 20e-6;
    const unsigned int n_steps = std::lround(duration / dt);
    double half_way            = 0;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        if (step == n_steps / 2)
          half_way = sheets.mean_velocity(false)[0];
        for (unsigned int n = 0; n < sheets.mass.size(); ++n)
          if (!sheets.leaflet.pinned[n])
            {
              sheets.V[3 * n] += dt * g * std::sin(angle);
              sheets.V[3 * n + 2] -= dt * g * std::cos(angle);
            }
        contact.apply_impulse(sheets.X.data(), sheets.V.data(), dt);
        sheets.mean_velocity(true);
        sheets.drift(dt);
      }
    for (unsigned int n = 0; n < sheets.mass.size(); ++n)
      if (sheets.leaflet.pinned[n])
        for (unsigned int d = 0; d < 3; ++d)
          if (sheets.V[3 * n + d] != 0)
            return 1e300;
    return (sheets.mean_velocity(false)[0] - half_way) / (0.5 * duration * g);
  }

  void
  coulomb()
  {
    const double mu = 0.2;
    for (const double ratio : {0.5, 0.95})
      {
        const double a = slide(std::atan(ratio * mu), 8e-3);
        check("block sticks at tan(angle)/mu = " +
                std::to_string(ratio).substr(0, 4),
              std::abs(a) < 1e-3,
              a);
      }
    for (const double ratio : {1.5, 3.})
      {
        const double angle = std::atan(ratio * mu);
        check_relative("block slides at tan(angle)/mu = " +
                         std::to_string(ratio).substr(0, 4),
                       slide(angle, 4e-3),
                       std::sin(angle) - mu * std::cos(angle),
                       0.01);
      }
  }

  /** Speed after over speed before a bounce off a pinned plane. Contact changes
   * the velocity at once or, if @p over_next_step, by a constant force over the
   * next step, as in blood. */
  double
  restitution(const double damping,
              const double dt,
              double &largest_energy,
              const bool over_next_step = false)
  {
    // Equal elements, and as many nodes of the plane under the block as its
    // area asks for, so that both passes see the same mass.
    Sheets sheets;
    sheets.add_rectangle({{12, 10}},
                         Point<3>(-5e-3, -4e-3, 0),
                         {{12e-3, 10e-3}},
                         true);
    sheets.add_rectangle({{4, 3}},
                         Point<3>(0.4e-3, 0.4e-3, 5e-3),
                         {{4e-3, 3e-3}},
                         false);
    ContactParameters parameters;
    parameters.damping   = damping;
    parameters.clearance = 0.3e-3;
    MidSurfaceContact contact(
      sheets.leaflet, sheets.mass, Sheets::density, parameters, MPI_COMM_WORLD);
    const double speed = 0.5;
    for (unsigned int n = 0; n < sheets.mass.size(); ++n)
      if (!sheets.leaflet.pinned[n])
        {
          sheets.X[3 * n + 2] -= 3.6e-3;
          sheets.V[3 * n + 2] = -speed;
        }
    const double energy = sheets.kinetic_energy();
    largest_energy      = 0;
    std::vector<double> change(sheets.V.size());
    for (double t = 0; t < 2e-3; t += dt)
      {
        sheets.drift(dt);
        for (unsigned int i = 0; over_next_step && i < change.size(); ++i)
          {
            sheets.X[i] += 0.5 * dt * change[i];
            sheets.V[i] += change[i];
          }
        const std::vector<double> before = sheets.V;
        contact.apply_impulse(sheets.X.data(), sheets.V.data(), dt);
        sheets.mean_velocity(true);
        if (over_next_step)
          for (unsigned int i = 0; i < change.size(); ++i)
            {
              change[i]   = sheets.V[i] - before[i];
              sheets.V[i] = before[i];
            }
        largest_energy =
          std::max(largest_energy, sheets.kinetic_energy() / energy);
      }
    return sheets.mean_velocity(false)[2] / speed;
  }

  void
  bounce()
  {
    double energy;
    for (const double dt : {2e-6, 10e-6, 40e-6, 200e-6})
      {
        const std::string step = std::to_string(std::lround(1e6 * dt)) + " us";
        const double e         = restitution(0.3, dt, energy);
        check("bounce with damping loses energy, step " + step,
              energy <= 1 + 1e-12 && e > 0.1 && e < 0.7,
              e);
      }
    for (const double dt : {2e-6, 10e-6, 40e-6, 200e-6})
      {
        // At any phase of the step it is at most 0.75.
        const double e = restitution(0.3, dt, energy, true);
        check("by a force over the next step, step " +
                std::to_string(std::lround(1e6 * dt)) + " us",
              energy <= 1 + 1e-12 && e > 0.1 && e < 0.76,
              e);
        const double least = ContactParameters().least_damping();
        restitution(least, dt, energy, true);
        check("with the least damping", energy <= 1 + 1e-12, energy);
      }
    restitution(0, 40e-6, energy, true);
    check("without damping that creates energy", energy > 1.05, energy);
    check_relative("bounce without damping is elastic",
                   restitution(0, 2e-6, energy),
                   1.,
                   0.01);

    // Release from a linear spring with damping zeta that cannot pull: at the
    // time of zero force the speed over the initial one is exp(-zeta/w atan2).
    const double zeta = 0.3, w = std::sqrt(1 - zeta * zeta);
    const double phase    = std::atan2(2 * zeta * w, 2 * zeta * zeta - 1);
    const double expected = std::exp(-zeta / w * phase);
    check_relative("restitution of a damped spring",
                   restitution(zeta, 1e-6, energy),
                   expected,
                   0.02);
  }

  /** A sheet at a gap above an equal one that is pinned. */
  struct PressedSheet
  {
    PressedSheet(const ContactParameters &parameters, const double gap)
    {
      for (const bool pinned : {true, false})
        sheets.add_rectangle({{6, 6}},
                             Point<3>(0, 0, pinned ? 0 : 5e-3),
                             {{6e-3, 6e-3}},
                             pinned);
      contact = std::make_unique<MidSurfaceContact>(sheets.leaflet,
                                                    sheets.mass,
                                                    Sheets::density,
                                                    parameters,
                                                    MPI_COMM_WORLD);
      for (unsigned int n = 0; n < sheets.mass.size(); ++n)
        if (!sheets.leaflet.pinned[n])
          sheets.X[3 * n + 2] += Sheets::thickness + gap - 5e-3;
    }

    /** Moves the sheet along the surface during a step and returns the shear
     * force per area on it (Pa). */
    double
    shear(const double speed, const double dt)
    {
      sheets.V.assign(sheets.V.size(), 0.);
      for (unsigned int n = 0; n < sheets.mass.size(); ++n)
        if (!sheets.leaflet.pinned[n])
          sheets.V[3 * n] = speed;
      sheets.drift(dt);
      friction_work += dt *
        contact->apply_impulse(sheets.X.data(), sheets.V.data(), dt)
          .friction_power;
      return (sheets.mean_velocity(false)[0] - speed) * Sheets::density *
        Sheets::thickness / dt;
    }

    /** Pressure in the middle (Pa). */
    double
    pressure(const double dt)
    {
      contact->clear_accumulators();
      contact->apply_impulse(sheets.X.data(), sheets.V.data(), dt);
      const unsigned int middle = 49 + 24;
      return contact->state().pressure_impulse[middle] / dt;
    }

    Sheets sheets;
    std::unique_ptr<MidSurfaceContact> contact;
    double friction_work = 0;
  };

  void
  laws()
  {
    const double dt = 1e-7, clearance = 0.4e-3;
    ContactParameters parameters;
    parameters.clearance = clearance;
    const auto pressure  = [&](const double gap) {
      return PressedSheet(parameters, gap).pressure(dt);
    };
    check_relative("linear law",
                   pressure(0.35e-3),
                   parameters.max_stiffness * 0.05e-3,
                   1e-9);
    check("nothing at the clearance", pressure(clearance + 1e-9) == 0);

    parameters.law               = ContactLaw::exponential;
    parameters.pressure_at_touch = 20e3;
    check_relative("exponential law where surfaces touch",
                   pressure(0),
                   20e3,
                   1e-3);
    const double s = 0.7;
    check_relative("exponential law at a gap",
                   pressure(clearance * (1 - s)),
                   20e3 * s * std::expm1(s) / std::expm1(1.),
                   2e-3);
    parameters.max_stiffness = 1e7;
    check_relative("no law is steeper than the penalty",
                   pressure(-0.1e-3) - pressure(-0.05e-3),
                   1e7 * 0.05e-3,
                   1e-6);

    parameters           = ContactParameters();
    parameters.law       = ContactLaw::table;
    parameters.clearance = clearance;
    parameters.table     = {{clearance, 0.}, {0.2e-3, 2e3}, {0., 20e3}};
    check_relative("table, first piece", pressure(0.3e-3), 1e3, 1e-9);
    check_relative("table, second piece", pressure(0.05e-3), 15.5e3, 1e-9);
    check_relative("table, beyond its end", pressure(-0.02e-3), 21.8e3, 1e-9);
  }

  void
  sticking()
  {
    ContactParameters parameters;
    parameters.clearance = 0.3e-3;
    parameters.damping   = 0;
    const double dt = 1e-7, depth = 2e-6, step = 1e-8;
    const double stiffness =
      parameters.stick_stiffness * parameters.max_stiffness;
    const double bound = parameters.friction * parameters.max_stiffness * depth;
    const double reach = bound / stiffness;

    // Over nodes and edges of the facets below, since the columns begin
    // exactly above nodes.
    PressedSheet sheet(parameters, parameters.clearance - depth);
    const auto move = [&](const double distance) {
      double shear         = 0;
      const unsigned int n = std::lround(std::abs(distance) / step);
      for (unsigned int i = 0; i < n; ++i)
        shear = sheet.shear(distance / (n * dt), dt);
      return shear;
    };
    // What hangs over the rim of the other sheet does not touch.
    const double rim = 3e-3;
    check_relative("shear of a sticking sheet",
                   move(0.5 * reach),
                   -0.5 * bound,
                   rim);
    move(-1.2 * reach);
    check("no shear where it has begun to stick",
          std::abs(move(0.7 * reach)) < rim * bound);
    check_relative("shear of a sliding sheet", move(4 * reach), -bound, rim);
    check_relative("it unloads along the spring",
                   move(-0.5 * reach),
                   -0.5 * bound,
                   2 * rim);
    move(-0.5 * reach);
    const double work = sheet.friction_work;
    check_relative("work of a sliding stroke",
                   -work / (36e-6 * bound * 3 * reach),
                   1.,
                   0.02);

    double least = 0;
    for (unsigned int i = 0; i < 400; ++i)
      {
        sheet.shear(noise() * step / dt * 20, dt);
        least = std::max(least, sheet.friction_work - work);
      }
    check("friction takes energy in any motion", least < 1e-9 * -work, least);
  }

  void
  input()
  {
    dealii::ParameterHandler prm;
    ContactParameters::declare_parameters(prm);
    ContactParameters parameters;
    const ContactParameters defaults;
    parameters.parse_parameters(prm);
    const auto equal = [](const double a, const double b) {
      return std::abs(a - b) <= 1e-12 * std::abs(b);
    };
    check("declared and built-in defaults agree",
          equal(parameters.clearance, defaults.clearance) &&
            equal(parameters.stiffness_factor, defaults.stiffness_factor) &&
            equal(parameters.max_stiffness, defaults.max_stiffness) &&
            equal(parameters.damping, defaults.damping) &&
            equal(parameters.friction, defaults.friction) &&
            equal(parameters.stick_stiffness, defaults.stick_stiffness) &&
            equal(parameters.pressure_at_touch, defaults.pressure_at_touch) &&
            parameters.law == defaults.law &&
            parameters.search_interval == defaults.search_interval &&
            equal(parameters.exclusion_distance, defaults.exclusion_distance) &&
            equal(parameters.search_margin, defaults.search_margin));

    const auto error_of_table = [&](const std::string &table) {
      return error_of([&]() {
        prm.enter_subsection("Contact");
        prm.set("Law", std::string("table"));
        prm.set("Table", table);
        prm.leave_subsection();
        parameters.parse_parameters(prm);
      });
    };
    parameters.stiffness_factor = 0.16;
    parameters.damping          = 0.13;
    const auto damping_error    = [&]() {
      return error_of([&]() { parameters.check_damping(); });
    };
    check("too little damping is refused",
          damping_error() ==
            "Contact/Damping is 0.13, but must be from 0.14 to 1 in blood with "
            "Contact/Stiffness factor = 0.16, or impacts create energy");
    parameters.damping = 0.14;
    check("and enough is not", damping_error() == "none");
    parameters.stiffness_factor = 0.6;
    check("too large a stiffness factor is refused",
          damping_error() ==
            "Contact/Stiffness factor is 0.6, but must be at most 0.5 in "
            "blood, or impacts create energy");
    for (const std::string table : {"0.3: 1, 0: 2",
                                    "0.3: 0, 0.4: 2",
                                    "0.3: 0, 0.1: 2, 0: 1",
                                    "0.3: 0, 0.1",
                                    "0.3: 0, a: 2"})
      check("table '" + table + "' is refused",
            error_of_table(table).find("Contact: Table is '") == 0);
    check("a table sets the clearance",
          error_of_table("0.3: 0, 0: 2") == "none" &&
            equal(parameters.clearance, 0.3e-3));

    Sheets sheets;
    sheets.add_rectangle({{2, 2}}, Point<3>(), {{2e-3, 2e-3}}, false);
    std::vector<double> mass(sheets.mass);
    mass[4]      = 0;
    bool refused = false;
    try
      {
        MidSurface(sheets.leaflet, mass);
      }
    catch (const InputError &)
      {
        refused = true;
      }
    check("a node without mass is refused", refused);

    MidSurfaceContact contact(
      sheets.leaflet, sheets.mass, Sheets::density, parameters, MPI_COMM_WORLD);
    contact.apply_impulse(sheets.X.data(), sheets.V.data(), 1e-6);
    sheets.X[7]  = std::numeric_limits<double>::quiet_NaN();
    bool stopped = false;
    try
      {
        contact.apply_impulse(sheets.X.data(), sheets.V.data(), 1e-6);
      }
    catch (const NumericalError &)
      {
        stopped = true;
      }
    check("a position that is not finite stops the computation", stopped);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  conservation();
  coulomb();
  bounce();
  laws();
  sticking();
  input();
}
