// Contact of facets: conservation, Coulomb's law, bouncing.

#include "blocks.h"
#include "tests.h"

using dealii::Point;
using dealii::Tensor;

namespace
{
  coapt::ContactParameters
  parameters()
  {
    coapt::ContactParameters result;
    result.clearance        = 0;
    result.max_stiffness    = 1e15;
    result.stiffness_factor = 0.5;
    result.search_margin    = 0.02;
    return result;
  }

  double
  noise()
  {
    return std::rand() / (0.5 * RAND_MAX) - 1;
  }

  /** Momentum and its moment about the origin. */
  std::array<Tensor<1, 3>, 2>
  momenta(const std::vector<double> &mass,
          const std::vector<double> &X,
          const std::vector<double> &V)
  {
    std::array<Tensor<1, 3>, 2> sums;
    for (unsigned int n = 0; n < mass.size(); ++n)
      {
        const Point<3> x(X[3 * n], X[3 * n + 1], X[3 * n + 2]);
        const Point<3> v(V[3 * n], V[3 * n + 1], V[3 * n + 2]);
        sums[0] += mass[n] * v;
        sums[1] += mass[n] * cross_product_3d(x, v);
      }
    return sums;
  }

  /** Two wavy blocks of different meshes, apart. */
  Blocks<3>
  wavy_blocks()
  {
    Blocks<3> blocks;
    for (const double side : {-1., 1.})
      {
        const unsigned int n = side > 0 ? 4 : 5;
        blocks.add({{n, n, 2}}, [=](const Point<3> &p) {
          const double wave = 0.03 * std::sin(7 * p[0] + 5 * p[1]);
          // apart in the reference, where nothing may overlap
          return Point<3>(p[0] + 0.1 * side,
                          p[1],
                          wave + (side > 0 ? 1 + 0.5 * p[2] : -0.5 * p[2]) -
                            0.01 * side);
        });
        // the second coordinate of the other one runs backwards
        if (side < 0)
          for (auto &cell : blocks.mesh.cells)
            std::swap(cell[0], cell[1]);
      }
    return blocks;
  }

  // They are pressed into each other at random velocities.
  void
  conservation()
  {
    for (const double friction : {0., 0.3})
      {
        const Blocks<3> blocks = wavy_blocks();
        auto law               = parameters();
        law.friction           = friction;
        const std::vector<bool> held(blocks.mesh.points.size(), false);
        Motion<3> motion(blocks.mesh,
                         held,
                         coapt::outer_facets(blocks.mesh),
                         law,
                         0.1,
                         0.3,
                         false);
        for (unsigned int n = 0; n < held.size(); ++n)
          if (motion.X[3 * n + 2] > 0.5)
            motion.X[3 * n + 2] -= 1;
        for (double &v : motion.V)
          v = 0.5 * noise();
        const auto before      = momenta(motion.mass, motion.X, motion.V);
        const double energy    = motion.solid.kinetic_energy(motion.V.data());
        const auto result      = motion.contact.apply_impulse(motion.X.data(),
                                                         motion.V.data(),
                                                         motion.dt);
        const auto after       = momenta(motion.mass, motion.X, motion.V);
        const double impulse   = motion.dt * result.normal_force;
        const std::string name = friction > 0 ? " with friction" : "";
        check("blocks touch" + name, result.pairs > 100, result.pairs);
        check("action = reaction" + name,
              (after[0] - before[0]).norm() < 1e-12 * impulse,
              (after[0] - before[0]).norm() / impulse);
        if (friction == 0)
          check("moments balance",
                (after[1] - before[1]).norm() < 1e-12 * impulse,
                (after[1] - before[1]).norm() / impulse);
        check_relative("work = change of kinetic energy" + name,
                       motion.dt *
                         (result.normal_power + result.friction_power),
                       motion.solid.kinetic_energy(motion.V.data()) - energy,
                       1e-9);
        check("friction dissipates" + name,
              friction > 0 ? result.friction_power < 0
                           : result.friction_power == 0,
              result.friction_power);
      }
  }

  /** A block above a plane that is held. */
  struct BlockOnPlane
  {
    BlockOnPlane(const coapt::ContactParameters &law, const double height)
    {
      Blocks<2> blocks;
      blocks.add({{10, 2}}, [](const Point<2> &p) {
        return Point<2>(p[0] - 0.2, 0.1 * p[1] - 0.1);
      });
      first = blocks.add({{7, 4}}, [=](const Point<2> &p) {
        return Point<2>(0.2 * p[0], 0.1 * p[1] + height);
      });
      std::vector<bool> held(blocks.mesh.points.size(), false);
      std::fill(held.begin(), held.begin() + first, true);
      motion = std::make_unique<Motion<2>>(blocks.mesh,
                                           held,
                                           coapt::outer_facets(blocks.mesh),
                                           law,
                                           0.03,
                                           0.3,
                                           false);
    }

    Tensor<1, 2>
    mean_velocity() const
    {
      Tensor<1, 2> momentum;
      double mass = 0;
      for (unsigned int n = first; n < motion->mass.size(); ++n)
        {
          mass += motion->mass[n];
          for (unsigned int d = 0; d < 2; ++d)
            momentum[d] += motion->mass[n] * motion->V[2 * n + d];
        }
      return momentum / mass;
    }

    double
    energy() const
    {
      return motion->solid.kinetic_energy(motion->V.data()) +
        motion->solid.elastic_energy(motion->X.data());
    }

    unsigned int first;
    std::unique_ptr<Motion<2>> motion;
  };

  // Gravity tilted by the angle: it rests below tan(angle) = mu, and slides
  // with g (sin - mu cos) above. The mean of the second half of the time
  // counts, since first the spring of friction is loaded.
  double
  slide(const double angle)
  {
    auto law     = parameters();
    law.friction = 0.2;
    BlockOnPlane block(law, 0);
    Motion<2> &motion          = *block.motion;
    const double g             = 10;
    const unsigned int n_steps = std::lround(0.6 / motion.dt);
    double half_way            = 0;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        if (step == n_steps / 2)
          half_way = block.mean_velocity()[0];
        // Slowly, so that the block does not vibrate.
        const double pull = g * std::min(1., 3. * step / n_steps);
        for (unsigned int n = block.first; n < motion.mass.size(); ++n)
          {
            motion.external[2 * n] = motion.mass[n] * pull * std::sin(angle);
            motion.external[2 * n + 1] =
              -motion.mass[n] * pull * std::cos(angle);
          }
        motion.step();
      }
    return (block.mean_velocity()[0] - half_way) /
      (n_steps / 2 * motion.dt * g);
  }

  void
  coulomb()
  {
    const double mu = 0.2;
    for (const double ratio : {0.5, 0.95})
      {
        const double a = slide(std::atan(ratio * mu));
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
                       slide(angle),
                       std::sin(angle) - mu * std::cos(angle),
                       0.01);
      }
  }

  // What the block loses or gains in a bounce.
  void
  bounce()
  {
    for (const double damping : {0., 0.3})
      {
        auto law    = parameters();
        law.damping = damping;
        BlockOnPlane block(law, 1e-3);
        Motion<2> &motion  = *block.motion;
        const double speed = 0.5;
        for (unsigned int n = block.first; n < motion.mass.size(); ++n)
          motion.V[2 * n + 1] = -speed;
        const double before = block.energy();
        double largest      = 0;
        bool touched        = false;
        for (unsigned int step = 0; step < 4000; ++step)
          {
            motion.step();
            touched = touched || motion.result.pairs > 0;
            largest = std::max(largest, block.energy() / before);
          }
        const std::string name = damping > 0 ? ", damped" : ", without damping";
        const double restitution = block.mean_velocity()[1] / speed;
        check("block bounces" + name,
              touched && motion.result.pairs == 0 && restitution > 0.3 &&
                restitution < 1,
              restitution);
        // elastic energies are those of half a step before
        check("no energy is created" + name,
              largest < 1 + 2e-3 && block.energy() < 1.0001 * before,
              largest);
      }
  }

  // What contact does must not depend on the number of ranks: the communicator
  // of one rank is the reference.
  void
  ranks()
  {
    const Blocks<3> blocks = wavy_blocks();
    auto law               = parameters();
    law.friction           = 0.3;
    law.search_margin      = 2e-3; // so that facets are searched anew
    const auto facets      = coapt::outer_facets(blocks.mesh);
    const std::vector<bool> held(blocks.mesh.points.size(), false);
    const Motion<3> motion(blocks.mesh, held, facets, law, 0.1, 0.3, false);
    coapt::FacetContact<3> alone(
      blocks.mesh, facets, motion.mass, held, law, 0.1, MPI_COMM_SELF),
      together(
        blocks.mesh, facets, motion.mass, held, law, 0.1, MPI_COMM_WORLD);

    std::vector<double> X = motion.X, V = motion.V;
    for (double &v : V)
      v = 0.1 * noise();
    auto other   = V;
    double error = 0, largest = 0, pressure = 0, force = 0;
    unsigned int pairs = 0;
    for (unsigned int step = 0; step < 20; ++step)
      {
        for (unsigned int n = 0; n < held.size(); ++n)
          if (motion.X[3 * n + 2] > 0.5)
            {
              X[3 * n]     = motion.X[3 * n] + 2e-3 * step;
              X[3 * n + 2] = motion.X[3 * n + 2] - 1 - 1e-4 * step;
            }
        const auto a = alone.apply_impulse(X.data(), V.data(), motion.dt);
        const auto b =
          together.apply_impulse(X.data(), other.data(), motion.dt);
        pairs += a.pairs == b.pairs ? a.pairs : 0;
        force = std::max(force,
                         std::abs(a.normal_force / b.normal_force - 1) +
                           std::abs(a.friction_power / b.friction_power - 1));
        for (unsigned int i = 0; i < X.size(); ++i)
          {
            error   = std::max(error, std::abs(V[i] - other[i]));
            largest = std::max(largest, std::abs(V[i]));
          }
        for (unsigned int n = 0; n < held.size(); ++n)
          pressure = std::max(pressure,
                              std::abs(alone.pressure()[n] /
                                         (together.pressure()[n] + 1e-300) -
                                       1) *
                                (alone.pressure()[n] > 0));
      }
    check("same velocities on any number of ranks",
          pairs > 2000 && error < 1e-11 * largest,
          error / largest);
    check("same pressures", pressure < 1e-9, pressure);
    check("same force and work of friction", force < 1e-9, force);

    auto lowest = other, highest = other;
    const int n = other.size();
    MPI_Allreduce(
      other.data(), lowest.data(), n, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    MPI_Allreduce(
      other.data(), highest.data(), n, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    check("velocities replicated to the bit", lowest == highest);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  conservation();
  coulomb();
  bounce();
  ranks();
}
