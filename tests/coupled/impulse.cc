// An impulse that is spread over the step that follows: the same motion as
// under a constant load, no loss where it holds other forces in balance, and
// exact work.

#include "coupled_case.h"

using namespace coapt;

namespace
{
  /** Acceleration (m/s^2) of a node by the impulses, along the channel. */
  double
  push(const CoupledSetup<2> &setup, const unsigned int node)
  {
    const double y = setup.block.unit[node][1];
    return setup.pinned[node] ? 0. : 4000 * y * (1 - y);
  }

  /** The plate under impulses that amount to a constant force. */
  struct PushedPlate : CoupledCase<2>
  {
    PushedPlate(const CoupledSetup<2> &setup) : CoupledCase<2>(setup)
    {
      system.set_impulse(
        [this, setup](const double *, double *V, const double dt) {
          for (unsigned int n = 0; n < solid.n_nodes(); ++n)
            V[2 * n] += dt * push(setup, n);
        });
    }
  };

  /** Trapezoidal integral of what the coupling dissipates in @p n_steps, from
   * states between steps, as the audit takes it (J). */
  double
  sampled_loss(CoupledCase<2> &c, const double dt, const unsigned int n_steps)
  {
    double loss = 0;
    for (unsigned int n = 0; n < n_steps; ++n)
      {
        c.step(dt);
        loss += dt * c.coupling().dissipation;
      }
    return loss;
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const auto setup           = closed_box();
  const double dt            = 0.5 * CoupledCase<2>(setup).smaller_limit();
  const unsigned int n_steps = 400;

  PushedPlate pushed(setup);
  CoupledCase<2> loaded(setup);
  loaded.system.add_load(
    [&](const double t, const double *, const double *, double *F) {
      const bool first_rank =
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
      // the impulse after the first step acts from the second one on
      if (first_rank && t > 0.99 * dt)
        for (unsigned int n = 0; n < loaded.solid.n_nodes(); ++n)
          F[2 * n] += loaded.solid.mass()[n] * push(setup, n);
    });
  const double loss = sampled_loss(pushed, dt, n_steps);
  sampled_loss(loaded, dt, n_steps);
  const auto X = pushed.system.solid_positions(pushed.y.data());
  const auto Y = loaded.system.solid_positions(loaded.y.data());
  double way = 0, apart = 0, work = 0;
  for (unsigned int n = 0; n < pushed.solid.n_nodes(); ++n)
    {
      const double x = X[2 * n] - setup.block.mesh.points[n][0];
      way            = std::max(way, std::abs(x));
      apart          = std::max(apart, std::abs(X[2 * n] - Y[2 * n]));
      work += pushed.solid.mass()[n] * push(setup, n) * x;
    }
  check("the plate moves", way > 1e-6, way);
  check("moves as under a load", apart < 1e-10 * way, apart / way);
  check_relative("work",
                 pushed.system.work_of_impulse(),
                 work,
                 1e-3); // without the way of the first step
  const double error = (work - loss - pushed.energy()) / work;
  check("books of energy", std::abs(error) < 1e-3, error);
}
