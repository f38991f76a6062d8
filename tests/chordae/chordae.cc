// Chordae: attachment, analytic forces of a single one, ramp, energy.

#include <coapt/base/exceptions.h>
#include <coapt/chordae/attachment.h>
#include <coapt/chordae/chordae_network.h>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

/** Nodes of a small lattice around the origin (m), and uneven masses. */
const std::vector<Point<3>> &
lattice()
{
  static std::vector<Point<3>> nodes;
  if (nodes.empty())
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j)
        for (int k = -1; k <= 1; ++k)
          nodes.emplace_back(
            Point<3>(0.5e-3 * i + 1e-4 * j, 0.5e-3 * j, 0.5e-3 * k));
  return nodes;
}

std::vector<double>
masses()
{
  std::vector<double> m;
  for (unsigned int i = 0; i < lattice().size(); ++i)
    m.push_back(1e-7 * (1 + i % 4));
  return m;
}

std::vector<double>
positions()
{
  std::vector<double> X;
  for (const Point<3> &p : lattice())
    for (int c = 0; c < 3; ++c)
      X.push_back(p[c]);
  return X;
}

Chorda
make_chorda()
{
  Chorda chorda;
  chorda.id          = "R-P3";
  chorda.diameter    = 0.6e-3;
  chorda.modulus     = 40e6;
  chorda.rest_length = 20e-3;
  chorda.tip         = Point<3>(5e-3, -3e-3, -20e-3);
  attach(chorda, lattice(), masses(), Point<3>(2e-4, 1e-4, 0), 1.25e-3);
  return chorda;
}

void
check_attachment()
{
  const Chorda chorda = make_chorda();
  double sum = 0, error = 0;
  for (unsigned int k = 0; k < chorda.nodes.size(); ++k)
    {
      sum += chorda.weights[k];
      const double d =
        lattice()[chorda.nodes[k]].distance(Point<3>(2e-4, 1e-4, 0)) / 1.25e-3;
      const double ratio = chorda.weights[k] / chorda.weights[0];
      const double d0 =
        lattice()[chorda.nodes[0]].distance(Point<3>(2e-4, 1e-4, 0)) / 1.25e-3;
      const double expected = masses()[chorda.nodes[k]] * (1 - d * d) /
        (masses()[chorda.nodes[0]] * (1 - d0 * d0));
      error = std::max(error, std::abs(ratio / expected - 1));
    }
  check_relative("weights sum to one", sum, 1, 1e-14);
  check("weights follow mass and distance", error < 1e-12, error);

  std::string message;
  try
    {
      Chorda loose = chorda;
      attach(loose, lattice(), masses(), Point<3>(1, 0, 0), 1.25e-3);
    }
  catch (const InputError &error)
    {
      message = error.what();
    }
  check("attached to nothing is refused",
        message.find("chorda R-P3 attached to nothing") != std::string::npos);
}

/** A moving chorda, taut by 2 %: tension, resultant, moment, energy. */
void
check_taut()
{
  Chorda chorda               = make_chorda();
  const std::vector<double> X = positions(), rest(X.size(), 0.);
  ChordaeNetwork probe({chorda}, masses(), 0., 0.2);
  const Tensor<1, 3> arm = chorda.tip - probe.attachment_points(X.data())[0];
  const double l0        = arm.norm() / 1.02;
  chorda.rest_length     = l0;
  const ChordaeNetwork network({chorda}, masses(), 0., 0.2);

  const double EA = 40e6 * 3.14159265358979 / 4 * 0.36e-6;
  check_relative("taut: Hooke",
                 network.tensions(0, X.data(), rest.data())[0],
                 EA * 0.02,
                 1e-9);
  check_relative("taut: energy",
                 network.elastic_energy(0, X.data()),
                 EA * 0.02 * 0.02 * l0 / 2,
                 1e-9);

  // Away from the tip at 0.1 m/s: damping of the mass that is felt.
  std::vector<double> V(X.size());
  for (unsigned int i = 0; i < V.size(); ++i)
    V[i] = -0.1 * arm[i % 3] / arm.norm();
  double inverse_mass = 0;
  for (unsigned int k = 0; k < chorda.nodes.size(); ++k)
    inverse_mass +=
      chorda.weights[k] * chorda.weights[k] / masses()[chorda.nodes[k]];
  const double c       = 2 * 0.2 * std::sqrt(EA / l0 / inverse_mass);
  const double tension = EA * 0.02 + c * 0.1;
  check_relative("taut: damping",
                 network.tensions(0, X.data(), V.data())[0],
                 tension,
                 1e-9);
  check_relative("taut: damping power",
                 network.damping_power(0, X.data(), V.data()),
                 c * 0.01,
                 1e-9);
  check_relative("frequency",
                 network.max_frequency(),
                 std::sqrt(EA / l0 * inverse_mass),
                 1e-9);

  // Two ranks together give the force, in the line through the mean point.
  std::vector<double> F(X.size(), 0.);
  for (unsigned int rank = 0; rank < 2; ++rank)
    network.add_forces(0, X.data(), V.data(), F.data(), rank, 2);
  Tensor<1, 3> resultant, moment;
  const auto centre = network.attachment_points(X.data())[0];
  for (unsigned int node = 0; node < lattice().size(); ++node)
    {
      const Tensor<1, 3> f({F[3 * node], F[3 * node + 1], F[3 * node + 2]});
      resultant += f;
      moment += cross_product_3d(lattice()[node] - centre, f);
    }
  check_relative("resultant: size", resultant.norm(), tension, 1e-9);
  check_relative("resultant: direction",
                 resultant * arm,
                 tension * arm.norm(),
                 1e-9);
  check("no moment about the mean point",
        moment.norm() < 1e-14 * tension,
        moment.norm());
}

void
check_slack()
{
  Chorda chorda      = make_chorda();
  chorda.rest_length = 30e-3;
  const ChordaeNetwork network({chorda}, masses(), 0., 0.2);
  const auto X = positions();
  std::vector<double> V(X.size(), 10.), F(X.size(), 0.);
  network.add_forces(0, X.data(), V.data(), F.data(), 0, 1);
  double largest = 0;
  for (const double f : F)
    largest = std::max(largest, std::abs(f));
  check("slack: no force", largest == 0, largest);
  check("slack: no energy", network.elastic_energy(0, X.data()) == 0);

  // Taut, but approaching the tip so fast that damping would push.
  chorda.rest_length = 20e-3;
  const ChordaeNetwork taut({chorda}, masses(), 0., 0.2);
  for (unsigned int i = 0; i < V.size(); ++i)
    V[i] = 100 * chorda.tip[i % 3] / chorda.tip.norm();
  check("no push", taut.tensions(0, X.data(), V.data())[0] == 0);
  check("no push, but dissipation",
        taut.damping_power(0, X.data(), V.data()) > 0);
}

/** The rest length is the open one (and 0.1 %) at first, halfway at half time,
 * and the given one at the end; the power of the ramp is the energy's rate. */
void
check_ramp()
{
  Chorda chorda = make_chorda();
  const auto X  = positions();
  const std::vector<double> rest(X.size(), 0.);
  const double length =
    (chorda.tip -
     ChordaeNetwork({chorda}, masses(), 0., 0.2).attachment_points(X.data())[0])
      .norm();
  chorda.open_length = length;
  chorda.rest_length = 0.95 * length;
  const ChordaeNetwork network({chorda}, masses(), 10e-3, 0.2);
  const double EA = 40e6 * 3.14159265358979 / 4 * 0.36e-6;
  check("ramp: slack at the start",
        network.tensions(0, X.data(), rest.data())[0] == 0);
  check_relative("ramp: halfway",
                 network.tensions(5e-3, X.data(), rest.data())[0],
                 EA * (1 / (0.5 * (0.95 + 1.001)) - 1),
                 1e-9);
  for (const double t : {10e-3, 1.})
    check_relative("ramp: end",
                   network.tensions(t, X.data(), rest.data())[0],
                   EA * (1 / 0.95 - 1),
                   1e-9);
  const double dt = 1e-6;
  check_relative("ramp: power",
                 network.ramp_power(6e-3, X.data()),
                 (network.elastic_energy(6e-3 + dt, X.data()) -
                  network.elastic_energy(6e-3 - dt, X.data())) /
                   (2 * dt),
                 1e-6);
}

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_attachment();
  check_taut();
  check_slack();
  check_ramp();
}
