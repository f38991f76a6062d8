#include <coapt/base/exceptions.h>
#include <coapt/solid/partition.h>
#include <coapt/solid/solid_operator.h>
#include <coapt/solid/stress_and_strain.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace coapt
{
  namespace
  {
    template <int dim, int degree>
    void
    check_volumes(const SimplexMesh<dim> &mesh)
    {
      const auto volumes  = point_volumes<dim, degree>(mesh);
      const auto &cells   = elements<dim, degree>(mesh);
      const auto inverted = [](const double volume) { return !(volume > 0); };
      unsigned int n_bad  = 0;
      std::ostringstream list;
      for (unsigned int i = 0; i < volumes.size(); ++i)
        if (std::any_of(volumes[i].begin(), volumes[i].end(), inverted) &&
            ++n_bad <= 10)
          {
            dealii::Point<dim> centre;
            for (const unsigned int node : cells[i])
              centre += mesh.points[node] / double(cells[i].size());
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

    template <int dim, int degree>
    std::vector<double>
    lumped_mass(const SimplexMesh<dim> &mesh,
                const double density,
                const std::vector<double> &added)
    {
      std::vector<double> mass(mesh.points.size(), 0.);
      const unsigned int n_own = mass.size() - added.size();
      std::copy(added.begin(), added.end(), mass.begin() + n_own);
      const auto volumes = point_volumes<dim, degree>(mesh);
      for (unsigned int i = 0; i < volumes.size(); ++i)
        {
          const double volume =
            std::accumulate(volumes[i].begin(), volumes[i].end(), 0.);
          const auto &nodes = elements<dim, degree>(mesh)[i];
          for (unsigned int a = 0; a < nodes.size(); ++a)
            mass[nodes[a]] +=
              density * volume * CellBatch<dim, degree>::mass_share(a);
        }
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

    /** Numbers of the elements that this rank evaluates. */
    template <int dim, int degree>
    std::vector<unsigned int>
    own_elements(const SimplexMesh<dim> &mesh, const MPI_Comm communicator)
    {
      if constexpr (degree == 1)
        return partition_cells(mesh, communicator);
      else
        {
          SimplexMesh<dim> between_vertices;
          between_vertices.points = mesh.points;
          for (const auto &nodes : mesh.quadratic_cells)
            {
              between_vertices.cells.emplace_back();
              std::copy_n(nodes.begin(),
                          dim + 1,
                          between_vertices.cells.back().begin());
            }
          return partition_cells(between_vertices, communicator);
        }
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

    /** Sets what belongs to the cells of an element that are at none of its
     * vertices to the mean of those which are. */
    template <typename Cells>
    void
    fill_inner(double *of_cells)
    {
      const double mean =
        std::accumulate(of_cells, of_cells + Cells::n_points, 0.) /
        Cells::n_points;
      std::fill(of_cells + Cells::n_points, of_cells + Cells::n_parts, mean);
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
    if (mesh.quadratic_cells.empty())
      build<1>(mesh, fibre, normal, added_mass);
    else if constexpr (dim == 3)
      build<2>(mesh, fibre, normal, added_mass);
    viscous_rate = largest_viscous_rate();
  }

  template <int dim>
  template <int degree>
  void
  SolidOperator<dim>::build(const SimplexMesh<dim> &mesh,
                            const std::vector<dealii::Tensor<1, dim>> &fibre,
                            const std::vector<dealii::Tensor<1, dim>> &normal,
                            const std::vector<double> &added_mass)
  {
    check_volumes<dim, degree>(mesh);
    nodal_mass = lumped_mass<dim, degree>(mesh, density, added_mass);

    const auto own = own_elements<dim, degree>(mesh, communicator);
    batches = build_batches<dim, degree>(mesh, own, fibre, prestretch, normal);
    constexpr unsigned int n_parts = CellBatch<dim, degree>::n_parts;
    for (const unsigned int element : own)
      for (unsigned int part = 0; part < n_parts; ++part)
        cells.push_back(n_parts * element + part);
  }

  template <int dim>
  double
  SolidOperator<dim>::largest_viscous_rate() const
  {
    double largest = 0;
    std::visit(
      [&](const auto &batches) {
        for (const auto &batch : batches)
          {
            Batch rate{};
            for (const auto &point : batch.point)
              {
                typename std::decay_t<decltype(batch)>::Scaled gradients;
                Batch sum{};
                batch.scaled_gradients(point, gradients);
                for (const auto &group : gradients)
                  for (const auto &gradient : group)
                    for (const Batch &component : gradient)
                      sum += component * component;
                rate += batch.volume_share(point) * sum;
              }
            for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
              largest = std::max(largest, viscosity / density * rate[lane]);
          }
      },
      batches);
    return dealii::Utilities::MPI::max(largest, communicator);
  }

  template <int dim>
  template <typename Function>
  void
  SolidOperator<dim>::with_material(const Function &f) const
  {
    std::visit(
      [&f](const auto &law, const auto &batches) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (dim == 3 || !Law::is_spatial)
          f(law, batches);
      },
      material,
      batches);
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
    with_material([&](const auto &law, const auto &batches) {
      for (const auto &batch : batches)
        {
          typename std::decay_t<decltype(batch)>::Values x, v, force = {};
          batch.load(X, x);
          batch.load(V, v);
          for (const auto &point : batch.point)
            {
              SmallMatrix<dim, Batch> stress =
                law.first_piola(point.gradient_of(x), point.fibre);
              const SmallMatrix<dim, Batch> rate = point.gradient_of(v);
              for (int i = 0; i < dim; ++i)
                for (int j = 0; j < dim; ++j)
                  stress[i][j] += viscosity * rate[i][j];
              point.subtract_divergence(stress, force);
            }
          batch.add_balanced(force, F);
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
  template <typename Law, typename Cells>
  typename SolidOperator<dim>::StepBound
  SolidOperator<dim>::local_step_bound(const Law &law,
                                       const std::vector<Cells> &batches,
                                       const double *X) const
  {
    StepBound bound;
    for (const Cells &batch : batches)
      {
        typename Cells::Values x;
        batch.load(X, x);
        Batch square{}, J = Batch{} + bound.min_jacobian;
        for (const auto &point : batch.point)
          {
            typename Cells::Scaled gradients;
            batch.scaled_gradients(point, gradients);
            const auto F = point.gradient_of(x);
            Batch sum{};
            for (const auto &group : gradients)
              sum += law.stiffness_bound(F, point.fibre, group);
            square += batch.volume_share(point) * sum;
            const Batch here = determinant(F, cofactors(F));
            J                = here < J ? here : J;
          }
        const Batch omega = square_root(square / density);
        for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
          {
            // For MPI's reduction, a NaN is the largest number.
            const double value = std::isfinite(omega[lane])
              ? omega[lane]
              : std::numeric_limits<double>::infinity();
            if (value > bound.omega)
              {
                bound.omega = value;
                bound.cell  = Cells::n_parts * batch.cell[lane];
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
    with_material([&](const auto &law, const auto &batches) {
      bound = local_step_bound(law, batches, X);
    });

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
    with_material([&](const auto &law, const auto &batches) {
      for (const auto &batch : batches)
        {
          typename std::decay_t<decltype(batch)>::Values x;
          batch.load(X, x);
          for (const auto &point : batch.point)
            sum += point.volume * law.energy(point.gradient_of(x), point.fibre);
        }
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
    std::visit(
      [&](const auto &batches) {
        for (const auto &batch : batches)
          {
            typename std::decay_t<decltype(batch)>::Values v;
            batch.load(V, v);
            for (const auto &point : batch.point)
              sum += point.volume * square_norm(point.gradient_of(v));
          }
      },
      batches);
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
  CellResults
  SolidOperator<dim>::cell_results(const double *X) const
  {
    const auto n_cells               = volumes.size();
    constexpr unsigned int n_results = 4;
    std::vector<double> local(n_results * n_cells, 0.), global(local.size());
    const auto evaluate = [&](const auto &law,
                              const auto &point,
                              const SmallMatrix<dim, Batch> &gradient,
                              const unsigned int lane,
                              const unsigned int cell) {
      const auto elastic = extract(gradient, lane);
      const auto total =
        prestretch.empty() ? elastic : elastic * invert(prestretch[cell]);
      double fibre[9] = {};
      for (int d = 0; d < dim * dim; ++d)
        fibre[d] = point.fibre[d][lane];
      const auto F              = embed(elastic);
      const auto stress         = cauchy_stress(law.first_piola(F, fibre), F);
      local[cell]               = von_mises(stress);
      local[n_cells + cell]     = largest_eigenvalue(stress);
      local[2 * n_cells + cell] = largest_strain(embed(total));
      local[3 * n_cells + cell] = determinant(total);
    };
    with_material([&](const auto &law, const auto &batches) {
      for (const auto &batch : batches)
        {
          using Cells = std::decay_t<decltype(batch)>;
          typename Cells::Values x;
          batch.load(X, x);
          for (int q = 0; q < Cells::n_points; ++q)
            {
              const auto gradient = batch.point[q].gradient_of(x);
              for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
                evaluate(law,
                         batch.point[q],
                         gradient,
                         lane,
                         Cells::n_parts * batch.cell[lane] + q);
            }
          for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
            for (unsigned int i = 0; i < n_results; ++i)
              fill_inner<Cells>(
                &local[i * n_cells + Cells::n_parts * batch.cell[lane]]);
        }
    });
    dealii::Utilities::MPI::sum(local, communicator, global);
    const auto part = [&](const unsigned int i) {
      return std::vector<double>(global.begin() + i * n_cells,
                                 global.begin() + (i + 1) * n_cells);
    };
    return {part(0), part(1), part(2), part(3)};
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
