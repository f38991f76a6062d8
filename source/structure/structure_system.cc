#include <deal.II/base/mpi.h>

#include <coapt/structure/structure_system.h>

#include <algorithm>
#include <numeric>

namespace coapt
{
  StructureSystem::StructureSystem(ValveStructure &valve,
                                   const StructureParameters &parameters,
                                   Timing &timing)
    : mass_damping(parameters.damping_rate())
    , valve(valve)
    , timing(timing)
    , pressure(valve.leaflet)
    , nodes(valve.solid->n_nodes(), 3, valve.communicator)
    , rank(dealii::Utilities::MPI::this_mpi_process(valve.communicator))
    , n_ranks(dealii::Utilities::MPI::n_mpi_processes(valve.communicator))
    , sections({timing.section("Solid"),
                timing.section("Chordae and load"),
                timing.section("Solid exchange"),
                timing.section("Contact")})
    , contact_acceleration(3 * valve.solid->n_nodes(), 0.)
    , moved_force(3 * valve.motion.nodes().size(), 0.)
    , moved_velocity(moved_force)
  {
    for (const unsigned int node : valve.motion.nodes())
      for (unsigned int d = 0; d < 3; ++d)
        moved_position.push_back(valve.leaflet.mesh.points[node][d]);
    if (!parameters.uniform_pressure)
      recorded = std::make_unique<RecordedLoad>(
        find_input_file(parameters.load_file, valve.parameters.folder),
        valve.leaflet,
        valve.mid_surface(valve.reference_positions()),
        valve.contact->state().reference_area,
        valve.solid->mass());
  }



  void
  StructureSystem::add_load(const double t, const double *X, double *F) const
  {
    if (recorded)
      recorded->add_forces(t, F, rank, n_ranks);
    else
      pressure.add_forces(valve.ventricular_pressure(t), X, F, rank, n_ranks);
  }



  std::vector<double>
  StructureSystem::load(const double t, const double *X) const
  {
    std::vector<double> force(3 * valve.solid->n_nodes(), 0.);
    add_load(t, X, force.data());
    dealii::Utilities::MPI::sum(force, valve.communicator, force);
    return force;
  }



  void
  StructureSystem::acceleration(const double t,
                                const double *X,
                                const double *V,
                                double *A)
  {
    const unsigned int n = valve.solid->n_nodes();
    std::fill_n(A, 3 * n, 0.);
    {
      const auto scope = timing.scope(sections.solid);
      valve.solid->add_forces(X, V, A);
    }
    {
      const auto scope = timing.scope(sections.loads);
      valve.chordae->add_forces(t, X, V, A, rank, n_ranks);
      add_load(t, X, A);
    }
    const auto scope = timing.scope(sections.exchange);
    nodes.sum(A);
    for (unsigned int i = 0; i < moved_force.size(); ++i)
      moved_force[i] = A[3 * valve.motion.nodes()[i / 3] + i % 3];
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        A[3 * i + d] = valve.leaflet.pinned[i]
          ? 0.
          : A[3 * i + d] / valve.solid->mass()[i] +
            contact_acceleration[3 * i + d];
  }



  void
  StructureSystem::move_held_nodes(const double t,
                                   double *X,
                                   double *V,
                                   const double dt)
  {
    const auto &moved = valve.motion.nodes();
    valve.motion.apply(t, X, nullptr);

    // The forces act between the middles of two steps, as do velocities.
    const double h = 0.5 * (last_step + dt);
    for (unsigned int i = 0; i < moved_position.size(); ++i)
      {
        const unsigned int entry = 3 * moved[i / 3] + i % 3;
        const double mass        = valve.solid->mass()[moved[i / 3]];
        const double velocity    = (X[entry] - moved_position[i]) / dt;
        const double mean        = 0.5 * (velocity + moved_velocity[i]);
        motion_work += mean *
          (mass * (velocity - moved_velocity[i]) +
           h * (mass_damping * mass * mean - moved_force[i]));
        V[entry] = moved_velocity[i] = velocity;
        moved_position[i]            = X[entry];
      }
    last_step = dt;
  }



  void
  StructureSystem::finish_step(const double *X,
                               const double *V,
                               const double dt)
  {
    const auto scope = timing.scope(sections.contact);
    after_impulse.assign(V, V + contact_acceleration.size());
    valve.last_contact =
      valve.contact->apply_impulse(X, after_impulse.data(), dt);
    for (unsigned int i = 0; i < contact_acceleration.size(); ++i)
      {
        const double acceleration = (after_impulse[i] - V[i]) / dt;
        work_of_contact += valve.solid->mass()[i / 3] * 0.5 *
          (contact_acceleration[i] + acceleration) * V[i] * dt;
        contact_acceleration[i] = acceleration;
      }
  }



  StructureSystem::Powers
  StructureSystem::powers(const double t,
                          const double *X,
                          const double *V) const
  {
    const unsigned int n = 3 * valve.solid->n_nodes();
    std::vector<double> load(n, 0.), chordae(n, 0.);
    add_load(t, X, load.data());
    valve.chordae->add_forces(t, X, V, chordae.data(), rank, n_ranks);
    const auto power = [&](const std::vector<double> &F) {
      return dealii::Utilities::MPI::sum(
        std::inner_product(F.begin(), F.end(), V, 0.), valve.communicator);
    };
    Powers powers;
    powers.load    = power(load);
    powers.chordae = power(chordae);
    powers.damping = valve.solid->viscous_power(V) +
      2 * mass_damping * valve.solid->kinetic_energy(V);
    return powers;
  }
} // namespace coapt
