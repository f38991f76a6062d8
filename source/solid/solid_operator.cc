#include <coapt/base/exceptions.h>
#include <coapt/solid/scaled_volume.h>
#include <coapt/solid/sheet_state.h>
#include <coapt/solid/solid_operator.h>
#include <coapt/solid/solid_setup.h>
#include <coapt/solid/stability.h>
#include <coapt/solid/stress_and_strain.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coapt
{
  namespace
  {
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

    template <int dim>
    SmallMatrix<dim, Batch>
    scaled(SmallMatrix<dim, Batch> F, const Batch &factor)
    {
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          F[i][j] *= factor;
      return F;
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
    else
      build<2>(mesh, fibre, normal, added_mass);
    using Linear = std::vector<CellBatch<dim>>;
    if (parameters.averages_volume && std::holds_alternative<Linear>(batches))
      averaging.emplace(std::get<Linear>(batches), n_nodes(), communicator);
    viscous_rate = largest_viscous_rate();
    if (parameters.controls_distortion)
      distortion.emplace(mesh,
                         cells,
                         parameters.distortion_threshold,
                         largest_wave_modulus_at_rest(material),
                         nodal_mass);
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
  bool
  SolidOperator<dim>::averages_volume() const
  {
    return averaging.has_value();
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
    if (distortion)
      distortion->add_forces(X, F);
    with_material([&](const auto &law, const auto &batches) {
      if constexpr (std::is_same_v<std::decay_t<decltype(batches)>,
                                   std::vector<CellBatch<dim>>>)
        if (averaging)
          return add_averaged_forces(law, batches, X, V, F);
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

  // A cell's mean depends on its neighbours: their share of the derivative, q
  // over the mean, comes back by the same average, which is symmetric.
  template <int dim>
  template <typename Law>
  void
  SolidOperator<dim>::add_averaged_forces(
    const Law &law,
    const std::vector<CellBatch<dim>> &batches,
    const double *X,
    const double *V,
    double *F) const
  {
    using Values                  = typename CellBatch<dim>::Values;
    const std::vector<Batch> mean = mean_ratios(batches, X);
    std::vector<Batch> by_mean(batches.size());
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const auto &point = batches[b].point[0];
        Values x, v, force = {};
        batches[b].load(X, x);
        batches[b].load(V, v);
        const ScaledVolume<dim, Batch> scaled(point.gradient_of(x), mean[b]);
        auto stress     = law.first_piola(scaled.gradient, point.fibre);
        by_mean[b]      = scaled.pull_back(stress);
        const auto rate = point.gradient_of(v);
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j)
            stress[i][j] += viscosity * rate[i][j];
        point.subtract_divergence(stress, force);
        batches[b].add_balanced(force, F);
      }
    const std::vector<Batch> pressure = averaging->apply(batches, by_mean);
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        Values x, force = {};
        batches[b].load(X, x);
        auto stress = cofactors(batches[b].point[0].gradient_of(x));
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j)
            stress[i][j] *= pressure[b];
        batches[b].point[0].subtract_divergence(stress, force);
        batches[b].add_balanced(force, F);
      }
  }

  template <int dim>
  std::vector<Batch>
  SolidOperator<dim>::mean_ratios(const std::vector<CellBatch<dim>> &batches,
                                  const double *X) const
  {
    std::vector<Batch> ratios(batches.size());
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        typename CellBatch<dim>::Values x;
        batches[b].load(X, x);
        const auto F = batches[b].point[0].gradient_of(x);
        ratios[b]    = determinant(F, cofactors(F));
      }
    return averaging->apply(batches, ratios);
  }

  template <int dim>
  template <typename Cells>
  std::vector<Batch>
  SolidOperator<dim>::volume_factors(const std::vector<Cells> &batches,
                                     const double *X) const
  {
    std::vector<Batch> factors(batches.size(), Batch{} + 1.);
    if constexpr (std::is_same_v<Cells, CellBatch<dim>>)
      if (averaging)
        {
          const std::vector<Batch> mean = mean_ratios(batches, X);
          for (unsigned int b = 0; b < batches.size(); ++b)
            {
              typename Cells::Values x;
              batches[b].load(X, x);
              factors[b] =
                ScaledVolume<dim, Batch>(batches[b].point[0].gradient_of(x),
                                         mean[b])
                  .factor;
            }
        }
    return factors;
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
    if (distortion)
      {
        const auto control = distortion->frequency_bound(X);
        if (control.square > bound.omega * bound.omega)
          bound.cell = control.cell;
        bound.omega = std::sqrt(bound.omega * bound.omega + control.square);
      }

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
      const std::vector<Batch> factors = volume_factors(batches, X);
      for (unsigned int b = 0; b < batches.size(); ++b)
        {
          typename std::decay_t<decltype(batches[b])>::Values x;
          batches[b].load(X, x);
          for (const auto &point : batches[b].point)
            sum += point.volume *
              law.energy(scaled(point.gradient_of(x), factors[b]), point.fibre);
        }
    });
    double energy = distortion ? distortion->energy(X) : 0.;
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
    constexpr unsigned int n_results = 5;
    std::vector<double> local(n_results * n_cells, 0.), global(local.size());
    const auto evaluate = [&](const auto &law,
                              const auto &point,
                              const SmallMatrix<dim, Batch> &gradient,
                              const double factor,
                              const unsigned int lane,
                              const unsigned int cell) {
      const auto elastic = extract(gradient, lane);
      const auto total =
        prestretch.empty() ? elastic : elastic * invert(prestretch[cell]);
      double fibre[9] = {};
      for (int d = 0; d < dim * dim; ++d)
        fibre[d] = point.fibre[d][lane];
      const auto F              = embed(factor * elastic);
      const auto stress         = cauchy_stress(law.first_piola(F, fibre), F);
      local[cell]               = von_mises(stress);
      local[n_cells + cell]     = largest_eigenvalue(stress);
      local[2 * n_cells + cell] = largest_strain(embed(total));
      local[3 * n_cells + cell] = smallest_stretch(embed(total));
      local[4 * n_cells + cell] = determinant(total);
    };
    with_material([&](const auto &law, const auto &batches) {
      const std::vector<Batch> factors = volume_factors(batches, X);
      for (unsigned int b = 0; b < batches.size(); ++b)
        {
          const auto &batch = batches[b];
          using Cells       = std::decay_t<decltype(batch)>;
          typename Cells::Values x;
          batch.load(X, x);
          for (int q = 0; q < Cells::n_points; ++q)
            {
              const auto gradient = batch.point[q].gradient_of(x);
              for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
                evaluate(law,
                         batch.point[q],
                         gradient,
                         factors[b][lane],
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
    return {part(0), part(1), part(2), part(3), part(4)};
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
