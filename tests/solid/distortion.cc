// Control of distortion: forces against energies, nothing where it is not
// needed, a block that would be turned inside out or crushed to a needle, the
// list of candidates and the bound of the step.
#include "solid/bricks.h"
#include "tests.h"

#include <coapt/solid/distortion_control.h>
#include <coapt/solid/largest_frequency.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  SolidParameters
  parameters(const bool controlled)
  {
    SolidParameters result;
    result.material                      = SaintVenantKirchhoff::name;
    result.saint_venant_kirchhoff.mu     = 1e4;
    result.saint_venant_kirchhoff.lambda = 0;
    result.density                       = 1000;
    result.viscosity                     = 0;
    result.distortion_threshold          = 0.1;
    result.controls_distortion           = controlled;
    return result;
  }

  constexpr double modulus = 2e4; // of plane waves, lambda + 2 mu

  SimplexMesh<3>
  block()
  {
    return bricks::box({{2, 2, 3}}, [](const Point<3> &p) {
      return Point<3>(1e-3 * p[0], 1e-3 * p[1], 1.5e-3 * p[2]);
    });
  }

  std::vector<double>
  positions(const SimplexMesh<3> &mesh, const double height, const double noise)
  {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> random(-noise, noise);
    std::vector<double> X;
    for (const Point<3> &p : mesh.points)
      for (unsigned int d = 0; d < 3; ++d)
        X.push_back(p[d] * (d == 2 ? height : 1) + random(generator));
    return X;
  }

  /** Smallest stretch of all cells. */
  double
  smallest(const SolidOperator<3> &solid, const std::vector<double> &X)
  {
    const auto cells = solid.cell_results(X.data());
    return *std::min_element(cells.smallest_stretch.begin(),
                             cells.smallest_stretch.end());
  }

  /** Control of all cells. */
  DistortionControl<3>
  whole(const SimplexMesh<3> &mesh, const double threshold)
  {
    const SolidOperator<3> solid(
      mesh, parameters(false), {}, {}, MPI_COMM_SELF);
    std::vector<unsigned int> cells(mesh.cells.size());
    std::iota(cells.begin(), cells.end(), 0);
    return {mesh, cells, threshold, modulus, solid.mass()};
  }

  void
  check_forces()
  {
    const SimplexMesh<3> mesh          = block();
    const DistortionControl<3> control = whole(mesh, 0.3);
    // Some cells are inverted.
    std::vector<double> X = positions(mesh, 0.15, 5e-5);
    std::vector<double> F(X.size(), 0.);
    control.add_forces(X.data(), F.data());
    double largest = 0, error = 0;
    for (const double force : F)
      largest = std::max(largest, std::abs(force));
    for (unsigned int i = 0; i < X.size(); ++i)
      {
        const double step = 1e-9, x = X[i];
        X[i]               = x + step;
        const double above = control.energy(X.data());
        X[i]               = x - step;
        const double below = control.energy(X.data());
        X[i]               = x;
        error = std::max(error, std::abs(F[i] + (above - below) / (2 * step)));
      }
    check("forces are derivatives of the energy",
          error < 1e-6 * largest,
          error / largest);
    Tensor<1, 3> sum;
    for (unsigned int i = 0; i < X.size(); ++i)
      sum[i % 3] += F[i];
    check("forces balance", sum.norm() < 1e-12 * largest, sum.norm() / largest);
    Tensor<1, 3> moment;
    for (unsigned int i = 0; i < X.size(); i += 3)
      moment += cross_product_3d(Tensor<1, 3>({X[i], X[i + 1], X[i + 2]}),
                                 Tensor<1, 3>({F[i], F[i + 1], F[i + 2]}));
    check("and so do moments",
          moment.norm() < 1e-15 * largest,
          moment.norm() / largest);
  }

  void
  check_unneeded()
  {
    const SimplexMesh<3> mesh = block();
    const SolidOperator<3> plain(
      mesh, parameters(false), {}, {}, MPI_COMM_SELF);
    const SolidOperator<3> controlled(
      mesh, parameters(true), {}, {}, MPI_COMM_SELF);
    const std::vector<double> X = positions(mesh, 0.5, 5e-5);
    const std::vector<double> V(X.size(), 0.);
    std::vector<double> F(X.size(), 0.), G(F);
    plain.add_forces(X.data(), V.data(), F.data());
    controlled.add_forces(X.data(), V.data(), G.data());
    check("smallest stretch is seen",
          std::abs(smallest(plain, positions(mesh, 0.5, 0)) - 0.5) < 1e-12);
    check("nothing where it is not needed",
          F == G &&
            plain.elastic_energy(X.data()) ==
              controlled.elastic_energy(X.data()));
  }

  /** A block is folded up bit by bit: the list that is carried along gives what
   * a fresh one does. */
  void
  check_candidates()
  {
    const SimplexMesh<3> mesh = bricks::box({{5, 5, 5}}, [](const auto &p) {
      return Point<3>(1e-3 * p);
    });
    const DistortionControl<3> carried = whole(mesh, 0.2);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> random(-1.5e-6, 1.5e-6);
    std::vector<double> X = positions(mesh, 1, 0);
    bool same             = true;
    double largest        = 0;
    for (unsigned int step = 0; step < 400; ++step)
      {
        for (unsigned int i = 0; i < X.size(); ++i)
          X[i] += random(generator) - (i % 3 == 2 ? 3e-3 * X[i] : 0.);
        std::vector<double> F(X.size(), 0.), G(F);
        const DistortionControl<3> fresh = whole(mesh, 0.2);
        carried.add_forces(X.data(), F.data());
        fresh.add_forces(X.data(), G.data());
        for (unsigned int i = 0; i < X.size(); ++i)
          {
            same    = same && F[i] == G[i];
            largest = std::max(largest, std::abs(F[i]));
          }
      }
    check("candidates are all that matter", same && largest > 0, largest);
  }

  /** Each rank has its own cells. */
  void
  check_ranks()
  {
    const SimplexMesh<3> mesh = block();
    const SolidOperator<3> shared(
      mesh, parameters(true), {}, {}, MPI_COMM_WORLD);
    const SolidOperator<3> alone(mesh, parameters(true), {}, {}, MPI_COMM_SELF);
    const std::vector<double> X = positions(mesh, 0.06, 5e-5);
    const std::vector<double> V(X.size(), 0.);
    std::vector<double> F(X.size(), 0.), sum(X.size()), G(X.size(), 0.);
    shared.add_forces(X.data(), V.data(), F.data());
    dealii::Utilities::MPI::sum(F, MPI_COMM_WORLD, sum);
    alone.add_forces(X.data(), V.data(), G.data());
    double error = 0, largest = 0;
    for (unsigned int i = 0; i < X.size(); ++i)
      {
        error   = std::max(error, std::abs(sum[i] - G[i]));
        largest = std::max(largest, std::abs(G[i]));
      }
    check("forces do not depend on the number of ranks",
          error < 1e-12 * largest,
          error / largest);
    check_relative("nor does the energy",
                   shared.elastic_energy(X.data()),
                   alone.elastic_energy(X.data()),
                   1e-12);
    check_relative("nor the bound of the step",
                   shared.max_frequency(X.data()),
                   alone.max_frequency(X.data()),
                   1e-12);
  }

  /** By von Mises's iteration on differences of forces (1/s). */
  double
  frequency(const SolidOperator<3> &solid, const std::vector<double> &X)
  {
    std::vector<double> W(X.size()), Y(X), F(X.size()), V(X.size(), 0.);
    std::mt19937 generator(9);
    std::uniform_real_distribution<double> random(-1, 1);
    for (double &w : W)
      w = random(generator);
    const double size = 1e-8;
    double square     = 0;
    for (unsigned int k = 0; k < 300; ++k)
      {
        square = 0;
        for (const double w : W)
          square = std::max(square, std::abs(w));
        std::vector<double> change(X.size(), 0.), sum(X.size());
        for (const int sign : {1, -1})
          {
            std::fill(F.begin(), F.end(), 0.);
            for (unsigned int i = 0; i < X.size(); ++i)
              Y[i] = X[i] + sign * size * W[i] / square;
            solid.add_forces(Y.data(), V.data(), F.data());
            for (unsigned int i = 0; i < X.size(); ++i)
              change[i] -= sign * F[i] / (2 * size);
          }
        dealii::Utilities::MPI::sum(change, MPI_COMM_WORLD, sum);
        for (unsigned int i = 0; i < X.size(); ++i)
          W[i] = sum[i] / solid.mass()[i / 3];
      }
    return std::sqrt(square);
  }

  /** This material does not stiffen, so that the control sets the step. */
  template <typename Element>
  void
  check_step(const std::string &name)
  {
    const SimplexMesh<3> mesh = Element::mesh(
      bricks::box({{2, 2, 2}}, [](const auto &p) { return 1e-3 * p; }));
    const SolidOperator<3> solid(
      mesh, parameters(true), {}, {}, MPI_COMM_WORLD);
    const std::vector<bool> pinned(mesh.points.size(), false);
    for (const double stretch : {0.12, 0.05})
      {
        LargestFrequency<3> estimate(solid, mesh, pinned, MPI_COMM_WORLD);
        const std::vector<double> X = positions(mesh, stretch, 0);
        const double omega          = frequency(solid, X);
        const std::string what =
          name + " pressed to " + std::to_string(stretch).substr(0, 4);
        check(what + ", bound",
              omega < solid.max_frequency(X.data()),
              omega / solid.max_frequency(X.data()));
        check(what + ", estimate",
              omega < estimate.update(X.data()).omega,
              omega / estimate.update(X.data()).omega);
      }
    const double far = 0.2;
    SolidOperator<3> plain(mesh, parameters(false), {}, {}, MPI_COMM_WORLD);
    const std::vector<double> X = positions(mesh, far, 0);
    check(name + ", the step is as long as without before",
          plain.max_frequency(X.data()) == solid.max_frequency(X.data()));
  }

  struct Bounce
  {
    double smallest = 1, energy_error = 0;
  };

  /** Moves the @p mesh, from its shape, with the velocities @p V. */
  Bounce
  bounce(const SimplexMesh<3> &mesh,
         const bool controlled,
         std::vector<double> V,
         const std::vector<bool> &held,
         const double dt,
         const unsigned int n_steps)
  {
    const SolidOperator<3> solid(
      mesh, parameters(controlled), {}, {}, MPI_COMM_SELF);
    std::vector<double> X = positions(mesh, 1, 0), F(X.size());
    const auto energy     = [&]() {
      return solid.kinetic_energy(V.data()) + solid.elastic_energy(X.data());
    };
    const auto kick = [&]() {
      std::fill(F.begin(), F.end(), 0.);
      solid.add_forces(X.data(), V.data(), F.data());
      for (unsigned int i = 0; i < X.size(); ++i)
        if (!held[i])
          V[i] += 0.5 * dt * F[i] / solid.mass()[i / 3];
    };
    Bounce result;
    const double before = energy();
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        kick();
        for (unsigned int i = 0; i < X.size(); ++i)
          X[i] += dt * V[i];
        kick();
        result.smallest = std::min(result.smallest, smallest(solid, X));
        result.energy_error =
          std::max(result.energy_error, std::abs(energy() / before - 1));
      }
    return result;
  }

  /** The block stands on a plate and its other nodes come down with a uniform
   * gradient of velocity. */
  Bounce
  crush(const bool controlled)
  {
    const SimplexMesh<3> mesh   = block();
    const std::vector<double> X = positions(mesh, 1, 0);
    std::vector<double> V(X.size(), 0.);
    std::vector<bool> held(X.size());
    // Without shear, all is one-dimensional.
    for (unsigned int i = 0; i < X.size(); ++i)
      {
        held[i] = i % 3 < 2 || mesh.points[i / 3][2] == 0;
        if (i % 3 == 2)
          V[i] = -5 * X[i] / 1.5e-3;
      }
    return bounce(mesh, controlled, V, held, 2e-7, 5000);
  }

  /** A free cube comes together in two directions at the same time. */
  Bounce
  squeeze()
  {
    const SimplexMesh<3> mesh =
      bricks::box({{2, 2, 2}}, [](const auto &p) { return 1e-3 * p; });
    const std::vector<double> X = positions(mesh, 1, 0);
    std::vector<double> V(X.size(), 0.);
    for (unsigned int i = 0; i < X.size(); ++i)
      if (i % 3 > 0)
        V[i] = -1.1e4 * (X[i] - 0.5e-3);
    const std::vector<bool> held(X.size(), false);
    return bounce(mesh, true, V, held, 2e-8, 10000);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_forces();
  check_unneeded();
  check_candidates();
  check_ranks();
  check_step<bricks::Linear>("P1");
  check_step<bricks::Quadratic>("P2");
  const Bounce free = crush(false), controlled = crush(true);
  check("a block is turned inside out", free.smallest < 0, free.smallest);
  check("and is not with control",
        controlled.smallest > 0.01 && controlled.smallest < 0.1,
        controlled.smallest);
  check("energy stays the same",
        controlled.energy_error < 1e-3,
        controlled.energy_error);
  const Bounce squeezed = squeeze();
  check("a block is not crushed to a needle",
        squeezed.smallest > 0.003 && squeezed.smallest < 0.1,
        squeezed.smallest);
  check("and keeps its energy",
        squeezed.energy_error < 1e-4,
        squeezed.energy_error);
  if (argc > 1)
    std::cout << free.smallest << ' ' << controlled.smallest << ' '
              << controlled.energy_error << ' ' << squeezed.smallest << ' '
              << squeezed.energy_error << std::endl;
}
