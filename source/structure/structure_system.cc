#include <deal.II/base/mpi.h>

#include <coapt/structure/structure_system.h>

#include <algorithm>
#include <numeric>

namespace coapt
{
  StructureSystem::StructureSystem(ValveStructure &valve,
                                   const StructureParameters &parameters,
                                   Timing &timing)
    : mass_damping(parameters.mass_damping)
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
  {
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



  void
  StructureSystem::acceleration(const double t,
                                const double *X,
                                const double *V,
                                double *A) const
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
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        A[3 * i + d] = valve.leaflet.pinned[i]
          ? 0.
          : A[3 * i + d] / valve.solid->mass()[i] +
            contact_acceleration[3 * i + d];
  }



  void
  StructureSystem::finish_step(const double *X,
                               const double *V,
                               const double dt)
  {
    const auto scope           = timing.scope(sections.contact);
    std::vector<double> &after = contact_acceleration;
    std::copy_n(V, after.size(), after.begin());
    valve.last_contact = valve.contact->apply_impulse(X, after.data(), dt);
    for (unsigned int i = 0; i < after.size(); ++i)
      {
        const double change = after[i] - V[i];
        work_of_contact += valve.solid->mass()[i / 3] * change * V[i];
        contact_acceleration[i] = change / dt;
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
