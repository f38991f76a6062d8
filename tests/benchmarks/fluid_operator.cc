// Cost of one right-hand side of the fluid (acoustics, convection, viscosity)
// in 3D on an octree with hanging nodes: our operator beside deal.II's
// matrix-free evaluation of the same terms, on the same mesh in the same run.
// Prints one line a measurement.

#include <deal.II/base/timer.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include "../fluid/fluid_case.h"

using namespace dealii;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  constexpr int dim = 3;

  coapt::FluidParameters
  fluid_parameters()
  {
    coapt::FluidParameters parameters;
    // What the matrix-free operator has not.
    parameters.hourglass_speed      = 0;
    parameters.checkerboard         = 0;
    parameters.artificial_viscosity = 0;
    return parameters;
  }

  /** The same terms by deal.II: Q1 velocities, one pressure a cell, Gauss
   * quadrature with two points in each direction. */
  class MatrixFreeFluid
  {
  public:
    MatrixFreeFluid(const parallel::distributed::Triangulation<dim> &mesh,
                    const coapt::FluidParameters &parameters)
      : parameters(parameters)
      , velocity_element(FE_Q<dim>(1), dim)
      , pressure_element(0)
      , velocity_dofs(mesh)
      , pressure_dofs(mesh)
    {
      velocity_dofs.distribute_dofs(velocity_element);
      pressure_dofs.distribute_dofs(pressure_element);
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(velocity_dofs, relevant);
      constraints.reinit(relevant);
      DoFTools::make_hanging_node_constraints(velocity_dofs, constraints);
      constraints.close();
      none.close();
      MatrixFree<dim, double>::AdditionalData data;
      data.mapping_update_flags = update_values | update_gradients;
      data.tasks_parallel_scheme =
        MatrixFree<dim, double>::AdditionalData::none;
      matrix_free.reinit(
        MappingQ1<dim>(),
        std::vector<const DoFHandler<dim> *>({&velocity_dofs, &pressure_dofs}),
        std::vector<const AffineConstraints<double> *>({&constraints, &none}),
        QGauss<1>(2),
        data);
      matrix_free.initialize_dof_vector(velocity, 0);
      matrix_free.initialize_dof_vector(force, 0);
      matrix_free.initialize_dof_vector(inverse_mass, 0);
      matrix_free.initialize_dof_vector(pressure, 1);
      matrix_free.initialize_dof_vector(pressure_rate, 1);
      inverse_mass = 1.;
      for (double &u : velocity)
        u = 1e-3 * std::sin(1e3 * (&u - velocity.begin()));
    }

    void
    evaluate()
    {
      velocity.update_ghost_values();
      force         = 0.;
      pressure_rate = 0.;
      matrix_free.cell_loop(&MatrixFreeFluid::cells,
                            this,
                            force,
                            velocity); // compresses the force
      force.scale(inverse_mass);
    }

  private:
    void
    cells(const MatrixFree<dim, double> &data,
          Vector &force,
          const Vector &velocity,
          const std::pair<unsigned int, unsigned int> &range)
    {
      FEEvaluation<dim, 1, 2, dim> u(data, 0);
      FEEvaluation<dim, 0, 2, 1> p(data, 1);
      const double rho = parameters.density;
      const double bulk_modulus =
        rho * parameters.sound_speed * parameters.sound_speed;
      for (unsigned int cell = range.first; cell < range.second; ++cell)
        {
          u.reinit(cell);
          u.gather_evaluate(velocity,
                            EvaluationFlags::values |
                              EvaluationFlags::gradients);
          p.reinit(cell);
          p.gather_evaluate(pressure, EvaluationFlags::values);
          for (unsigned int q = 0; q < u.n_q_points; ++q)
            {
              const auto value    = u.get_value(q);
              const auto gradient = u.get_gradient(q);
              const auto here     = p.get_value(q);
              u.submit_value(-0.5 * rho * (gradient * value), q);
              auto flux = 0.5 * rho * outer_product(value, value) -
                parameters.viscosity * gradient;
              for (unsigned int d = 0; d < dim; ++d)
                flux[d][d] += here;
              u.submit_gradient(flux, q);
              p.submit_value(-bulk_modulus * trace(gradient), q);
            }
          u.integrate_scatter(EvaluationFlags::values |
                                EvaluationFlags::gradients,
                              force);
          p.integrate_scatter(EvaluationFlags::values, pressure_rate);
        }
    }

    const coapt::FluidParameters parameters;
    FESystem<dim> velocity_element;
    FE_DGQ<dim> pressure_element;
    DoFHandler<dim> velocity_dofs, pressure_dofs;
    AffineConstraints<double> constraints, none;
    MatrixFree<dim, double> matrix_free;
    Vector velocity, force, inverse_mass, pressure, pressure_rate;
  };

  /** Shortest wall time (s) of several measurements of one call. */
  template <typename Call>
  double
  shortest_time(const Call &call)
  {
    double shortest = 1e9;
    for (unsigned int measurement = 0; measurement < 7; ++measurement)
      {
        const unsigned int n_calls = 10;
        Timer timer(MPI_COMM_WORLD, true);
        for (unsigned int i = 0; i < n_calls; ++i)
          call();
        timer.stop();
        shortest = std::min(shortest, timer.wall_time() / n_calls);
      }
    return shortest;
  }

  /** Bandwidth (bytes/s) of a copy of arrays that are as large as the state,
   * read, written, and fetched for writing. */
  double
  copy_bandwidth(const std::size_t n)
  {
    std::vector<double> a(n, 1.), b(n, 2.);
    const double time = shortest_time([&]() {
      std::swap(a[0], b[n - 1]);
      std::copy(a.begin(), a.end(), b.begin());
    });
    return 3 * 8. * n / time;
  }

  /** Clock rate of the core (1/s), by a chain of additions, of which each takes
   * a cycle. */
  double
  clock_rate()
  {
    const unsigned int n  = 10000000;
    unsigned long sum     = 0;
    const double duration = shortest_time([&]() {
      for (unsigned long i = 0; i < n; ++i)
        {
          sum += i;
          asm volatile("" : "+r"(sum)); // no sum in closed form
        }
    });
    return n / duration;
  }

  /** Least time (ns) that a cell's instructions take at @p rate cycles a second
   * and four instructions a cycle. The inner loop of the kernel has about 1,100
   * for eight cells, counted in its disassembly for Zen 4. */
  double
  instruction_limit(const double rate)
  {
    return 1e9 * 1100 / 8 / 4 / rate;
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  const bool first = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);

  coapt::FluidBoundaries<dim> boundaries;
  boundaries.type.fill(coapt::FluidBoundary::no_slip);
  FluidCase<dim> fluid(fluid_parameters(),
                       boundaries,
                       Point<dim>(0, 0, 0),
                       Point<dim>(32e-3, 32e-3, 32e-3),
                       {{4, 4, 4}});
  // About 80,000 cells; a band of the finer ones as around a leaflet.
  fluid.set_up([](const Point<dim> &x, double) {
    return std::abs(x[2] - 16e-3 - 0.2 * (x[0] - 16e-3)) < 3.6e-3 ? 4u : 3u;
  });
  fluid.set_velocity([](const Point<dim> &x, int d) {
    return 1e-3 * std::sin(1e3 * (x[0] + 2 * x[1] + 3 * x[2] + d));
  });
  std::vector<double> acceleration, pressure_rate;
  const double ours = shortest_time([&]() {
    fluid.evaluate(0., fluid.u, fluid.p, acceleration, pressure_rate);
  });

  MatrixFreeFluid other(fluid.grid.triangulation(), fluid_parameters());
  const double theirs = shortest_time([&]() { other.evaluate(); });

  const double n_cells =
    Utilities::MPI::sum<double>(fluid.op.n_owned_cells(), MPI_COMM_WORLD);
  const double n_unknowns =
    Utilities::MPI::sum<double>(fluid.u.size() + fluid.p.size(),
                                MPI_COMM_WORLD);
  // Velocities and forces are read and written in gather, kernel and finish,
  // pressures and their rates once, and node numbers of each cell.
  const double bytes =
    8 * (7. * fluid.u.size() + 3. * fluid.p.size()) + 32. * fluid.p.size();
  const double bandwidth = copy_bandwidth(fluid.u.size());
  const double rate      = clock_rate();
  if (first)
    std::cout << "ranks " << n_ranks << "\ncells " << n_cells
              << "\nours_ns_per_cell_and_core "
              << 1e9 * ours * n_ranks / n_cells << "\nours_unknowns_per_second "
              << n_unknowns / ours << "\nmatrix_free_ns_per_cell_and_core "
              << 1e9 * theirs * n_ranks / n_cells << "\nfaster_by "
              << theirs / ours << "\nlanes_of_matrix_free "
              << VectorizedArray<double>::size() << "\nclock_rate_GHz "
              << 1e-9 * rate << "\ninstruction_limit_ns_per_cell_and_core "
              << instruction_limit(rate)
              << "\nbandwidth_limit_ns_per_cell_and_core "
              << 1e9 * bytes / bandwidth / (n_cells / n_ranks) << std::endl;
}
