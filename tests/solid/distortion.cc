// Control of distortion: forces against energies, nothing where it is not
// needed, and a block that would be turned inside out.
#include "solid/bricks.h"
#include "tests.h"

#include <coapt/solid/distortion_control.h>

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

  void
  check_forces()
  {
    const SimplexMesh<3> mesh = block();
    std::vector<unsigned int> cells(mesh.cells.size());
    std::iota(cells.begin(), cells.end(), 0);
    const DistortionControl<3> control(mesh, cells, 0.3, modulus);
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

  struct Bounce
  {
    double smallest = 1, energy_error = 0, upwards = 0;
  };

  /** The block stands on a plate and its other nodes come down with a uniform
   * gradient of velocity. */
  Bounce
  crush(const bool controlled)
  {
    const SimplexMesh<3> mesh = block();
    const SolidOperator<3> solid(
      mesh, parameters(controlled), {}, {}, MPI_COMM_SELF);
    std::vector<double> X = positions(mesh, 1, 0), V(X.size(), 0.);
    // Without shear, all is one-dimensional.
    const double speed = 5;
    for (unsigned int i = 2; i < X.size(); i += 3)
      V[i] = -speed * X[i] / 1.5e-3;
    const double dt = 2e-7;
    Bounce result;
    const auto energy = [&]() {
      return solid.kinetic_energy(V.data()) + solid.elastic_energy(X.data());
    };
    const double before = energy();
    std::vector<double> F(X.size());
    const auto kick = [&]() {
      std::fill(F.begin(), F.end(), 0.);
      solid.add_forces(X.data(), V.data(), F.data());
      for (unsigned int i = 0; i < X.size(); ++i)
        if (i % 3 == 2 && mesh.points[i / 3][2] > 0)
          V[i] += 0.5 * dt * F[i] / solid.mass()[i / 3];
    };
    for (unsigned int step = 0; step < 5000; ++step)
      {
        kick();
        for (unsigned int i = 0; i < X.size(); ++i)
          X[i] += dt * V[i];
        kick();
        result.smallest = std::min(result.smallest, smallest(solid, X));
        result.energy_error =
          std::max(result.energy_error, std::abs(energy() / before - 1));
      }
    result.upwards = V.back();
    return result;
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_forces();
  check_unneeded();
  const Bounce free = crush(false), controlled = crush(true);
  check("a block is turned inside out", free.smallest < 0, free.smallest);
  check("and is not with control",
        controlled.smallest > 0.01 && controlled.smallest < 0.1,
        controlled.smallest);
  check("energy stays the same",
        controlled.energy_error < 1e-3,
        controlled.energy_error);
}
