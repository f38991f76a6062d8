#include <coapt/base/exceptions.h>
#include <coapt/solid/partition.h>
#include <coapt/solid/solid_operator.h>

#include <deal.II/base/mpi.h>

#include <sstream>
#include <type_traits>

namespace coapt
{
  namespace
  {
    template <int dim>
    void
    check_volumes(const SimplexMesh<dim> &mesh,
                  const std::vector<double> &volumes)
    {
      unsigned int n_bad = 0;
      std::ostringstream list;
      for (unsigned int i = 0; i < volumes.size(); ++i)
        if (!(volumes[i] > 0) && ++n_bad <= 10)
          {
            dealii::Point<dim> centre;
            for (const unsigned int node : mesh.cells[i])
              centre += mesh.points[node] / (dim + 1.);
            list << (n_bad > 1 ? "; " : "") << i << " at (" << centre * 1e3
                 << ") mm";
          }
      if (n_bad > 0)
        throw InputError("Solid mesh: " + std::to_string(n_bad) +
                         " cells are inverted or without volume, all must "
                         "have positive volume: " +
                         list.str() + (n_bad > 10 ? "; ..." : "") + ".");
    }

    void
    check_size(const std::string &name,
               const std::size_t size,
               const std::size_t n_cells)
    {
      if (size != n_cells)
        throw InputError("Solid: " + std::to_string(size) + " " + name +
                         " are given for " + std::to_string(n_cells) +
                         " cells, one a cell is needed.");
    }

    template <int dim>
    void
    check_fields(const std::vector<dealii::Tensor<1, dim>> &fibre,
                 const std::vector<dealii::Tensor<2, dim>> &prestretch,
                 const bool needs_fibre,
                 const std::size_t n_cells)
    {
      if (needs_fibre || !fibre.empty())
        check_size("fibres", fibre.size(), n_cells);
      if (!prestretch.empty())
        check_size("prestretches", prestretch.size(), n_cells);
      for (unsigned int i = 0; i < n_cells; ++i)
        {
          if (needs_fibre && !(fibre[i].norm() > 0))
            throw InputError("Solid: the fibre of cell " + std::to_string(i) +
                             " is zero or not a number, the material needs "
                             "one in every cell.");
          if (!prestretch.empty() && !(determinant(prestretch[i]) > 0))
            throw InputError("Solid: the prestretch of cell " +
                             std::to_string(i) +
                             " has no positive determinant.");
        }
    }

    template <int dim>
    std::vector<double>
    lumped_mass(const SimplexMesh<dim> &mesh,
                const std::vector<double> &volumes,
                const double density,
                const std::vector<double> &added)
    {
      std::vector<double> mass(mesh.points.size(), 0.);
      const unsigned int n_own = mass.size() - added.size();
      std::copy(added.begin(), added.end(), mass.begin() + n_own);
      for (unsigned int i = 0; i < volumes.size(); ++i)
        for (const unsigned int node : mesh.cells[i])
          mass[node] += density * volumes[i] / (dim + 1);
      std::ostringstream list;
      unsigned int n_bad = 0;
      for (unsigned int node = 0; node < n_own; ++node)
        if (!(mass[node] > 0) && ++n_bad <= 10)
          list << (n_bad > 1 ? "; " : "") << node << " at ("
               << mesh.points[node] * 1e3 << ") mm";
      if (n_bad > 0)
        throw InputError("Solid mesh: " + std::to_string(n_bad) +
                         " nodes belong to no cell: " + list.str() +
                         (n_bad > 10 ? "; ..." : "") + ".");
      return mass;
    }

    /** The entry @p lane of a matrix of batches. */
    template <int dim>
    dealii::Tensor<2, dim>
    extract(const SmallMatrix<dim, Batch> &A, const unsigned int lane)
    {
      dealii::Tensor<2, dim> result;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          result[i][j] = A[i][j][lane];
      return result;
    }

    /** A deformation gradient in 3D; the strain of a 2D one is plane. */
    template <int dim>
    SmallMatrix<3, double>
    embed(const dealii::Tensor<2, dim> &F)
    {
      SmallMatrix<3, double> result{};
      result[2][2] = 1;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          result[i][j] = F[i][j];
      return result;
    }

    /** von Mises norm (Pa) of the Cauchy stress P F^T / J. */
    double
    von_mises(const SmallMatrix<3, double> &P, const SmallMatrix<3, double> &F)
    {
      const double J = determinant(F, cofactors(F));
      SmallMatrix<3, double> s{};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            s[i][j] += P[i][k] * F[j][k] / J;
      const double mean = (s[0][0] + s[1][1] + s[2][2]) / 3;
      for (int i = 0; i < 3; ++i)
        s[i][i] -= mean;
      return std::sqrt(1.5 * square_norm(s));
    }

    /** Largest logarithmic principal strain. */
    double
    largest_strain(const SmallMatrix<3, double> &F)
    {
      SmallMatrix<3, double> C = right_cauchy_green(F), directions;
      diagonalise(C, directions);
      return 0.5 * std::log(std::max({C[0][0], C[1][1], C[2][2]}));
    }
  } // namespace

  template <int dim>
  SolidOperator<dim>::SolidOperator(
    const SimplexMesh<dim> &mesh,
    const SolidParameters &parameters,
    const std::vector<dealii::Tensor<1, dim>> &fibre,
    const std::vector<dealii::Tensor<2, dim>> &prestretch,
    const MPI_Comm communicator,
    const std::vector<dealii::Tensor<1, dim>> &normal,
    const std::vector<double> &added_mass)
    : communicator(communicator)
    , density(parameters.density)
    , viscosity(parameters.viscosity)
    , viscous_rate(0)
    , material(parameters.selected_material())
    , volumes(signed_volumes(mesh))
    , prestretch(prestretch)
  {
    check_volumes(mesh, volumes);
    std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        if (dim == 2 && Law::is_spatial)
          throw InputError("Solid/Material is " + parameters.material +
                           ", which is available in 3D only.");
        check_fields(fibre, prestretch, Law::has_fibres, volumes.size());
        if (law.needs_normal())
          check_size("normals", normal.size(), volumes.size());
      },
      material);
    nodal_mass = lumped_mass(mesh, volumes, density, added_mass);
    cells      = partition_cells(mesh, communicator);
    batches    = build_batches(mesh, cells, fibre, prestretch, normal);

    for (const CellBatch<dim> &batch : batches)
      {
        Batch gradients[dim + 1][dim], sum{};
        batch.all_gradients(gradients);
        for (const auto &gradient : gradients)
          for (const Batch &component : gradient)
            sum += component * component;
        for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
          viscous_rate =
            std::max(viscous_rate, (dim + 1) * viscosity / density * sum[lane]);
      }
    viscous_rate = dealii::Utilities::MPI::max(viscous_rate, communicator);
  }

  template <int dim>
  template <typename Function>
  void
  SolidOperator<dim>::with_material(const Function &f) const
  {
    std::visit(
      [&f](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (dim == 3 || !Law::is_spatial)
          f(law);
      },
      material);
  }

  template <int dim>
  unsigned int
  SolidOperator<dim>::n_nodes() const
  {
    return nodal_mass.size();
  }

  template <int dim>
  const std::vector<double> &
  SolidOperator<dim>::mass() const
  {
    return nodal_mass;
  }

  template <int dim>
  void
  SolidOperator<dim>::add_forces(const double *X,
                                 const double *V,
                                 double *F) const
  {
    with_material([&](const auto &law) {
      for (const CellBatch<dim> &batch : batches)
        {
          SmallMatrix<dim, Batch> stress =
            law.first_piola(batch.gradient_of(X), batch.fibre);
          const SmallMatrix<dim, Batch> rate = batch.gradient_of(V);
          for (int i = 0; i < dim; ++i)
            for (int j = 0; j < dim; ++j)
              stress[i][j] += viscosity * rate[i][j];
          batch.subtract_divergence(stress, F);
        }
    });
  }

  template <int dim>
  double
  SolidOperator<dim>::max_frequency(const double *X) const
  {
    return step_bound(X).omega;
  }

  template <int dim>
  template <typename Law>
  typename SolidOperator<dim>::StepBound
  SolidOperator<dim>::local_step_bound(const Law &law, const double *X) const
  {
    StepBound bound;
    for (const CellBatch<dim> &batch : batches)
      {
        Batch gradients[dim + 1][dim];
        batch.all_gradients(gradients);
        const auto F      = batch.gradient_of(X);
        const Batch J     = determinant(F, cofactors(F));
        const Batch omega = square_root(
          (dim + 1) / density * law.stiffness_bound(F, batch.fibre, gradients));
        for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
          {
            // For MPI's reduction, a NaN is the largest number.
            const double value = std::isfinite(omega[lane])
              ? omega[lane]
              : std::numeric_limits<double>::infinity();
            if (value > bound.omega)
              {
                bound.omega = value;
                bound.cell  = batch.cell[lane];
              }
            bound.min_jacobian = std::min(bound.min_jacobian, J[lane]);
          }
      }
    return bound;
  }

  template <int dim>
  typename SolidOperator<dim>::StepBound
  SolidOperator<dim>::step_bound(const double *X) const
  {
    StepBound bound;
    with_material([&](const auto &law) { bound = local_step_bound(law, X); });

    struct
    {
      double omega;
      int cell;
    } local = {bound.omega, static_cast<int>(bound.cell)}, global;
    MPI_Allreduce(&local, &global, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator);
    bound.cell  = global.cell;
    bound.omega = std::isfinite(global.omega)
      ? global.omega
      : std::numeric_limits<double>::quiet_NaN();
    bound.xi    = viscous_rate / (2 * bound.omega);
    bound.min_jacobian =
      dealii::Utilities::MPI::min(bound.min_jacobian, communicator);
    return bound;
  }

  template <int dim>
  double
  SolidOperator<dim>::elastic_energy(const double *X) const
  {
    Batch sum{};
    with_material([&](const auto &law) {
      for (const CellBatch<dim> &batch : batches)
        sum += batch.volume * law.energy(batch.gradient_of(X), batch.fibre);
    });
    double energy = 0;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      energy += sum[lane];
    return dealii::Utilities::MPI::sum(energy, communicator);
  }

  template <int dim>
  double
  SolidOperator<dim>::viscous_power(const double *V) const
  {
    Batch sum{};
    for (const CellBatch<dim> &batch : batches)
      sum += batch.volume * square_norm(batch.gradient_of(V));
    double power = 0;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      power += viscosity * sum[lane];
    return dealii::Utilities::MPI::sum(power, communicator);
  }

  template <int dim>
  double
  SolidOperator<dim>::kinetic_energy(const double *V) const
  {
    double energy = 0;
    for (unsigned int node = 0; node < nodal_mass.size(); ++node)
      for (int c = 0; c < dim; ++c)
        energy +=
          0.5 * nodal_mass[node] * V[dim * node + c] * V[dim * node + c];
    return energy;
  }

  template <int dim>
  void
  SolidOperator<dim>::cell_results(const double *X,
                                   std::vector<double> &von_mises_cauchy,
                                   std::vector<double> &max_log_strain,
                                   std::vector<double> &jacobian) const
  {
    const auto n_cells = volumes.size();
    std::vector<double> local(3 * n_cells, 0.), global(3 * n_cells);
    with_material([&](const auto &law) {
      for (const CellBatch<dim> &batch : batches)
        {
          const auto gradient = batch.gradient_of(X);
          for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
            {
              const unsigned int cell = batch.cell[lane];
              const auto elastic      = extract(gradient, lane);
              const auto total        = prestretch.empty()
                       ? elastic
                       : elastic * invert(prestretch[cell]);
              double fibre[9]         = {};
              for (int d = 0; d < dim * dim; ++d)
                fibre[d] = batch.fibre[d][lane];
              const auto F          = embed(elastic);
              local[cell]           = von_mises(law.first_piola(F, fibre), F);
              local[n_cells + cell] = largest_strain(embed(total));
              local[2 * n_cells + cell] = determinant(total);
            }
        }
    });
    dealii::Utilities::MPI::sum(local, communicator, global);
    von_mises_cauchy.assign(global.begin(), global.begin() + n_cells);
    max_log_strain.assign(global.begin() + n_cells,
                          global.begin() + 2 * n_cells);
    jacobian.assign(global.begin() + 2 * n_cells, global.end());
  }

  template <int dim>
  const std::vector<double> &
  SolidOperator<dim>::cell_volumes() const
  {
    return volumes;
  }

  template <int dim>
  const std::vector<unsigned int> &
  SolidOperator<dim>::owned_cells() const
  {
    return cells;
  }

  template class SolidOperator<2>;
  template class SolidOperator<3>;
} // namespace coapt
