#include <deal.II/base/mpi.h>

#include <coapt/solid/largest_frequency.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  template <int dim>
  LargestFrequency<dim>::LargestFrequency(const SolidOperator<dim> &solid,
                                          const SimplexMesh<dim> &mesh,
                                          const std::vector<bool> &pinned,
                                          MPI_Comm communicator)
    : solid(solid)
    , mesh(mesh)
    , pinned(pinned)
    , communicator(communicator)
    , shape(dim * solid.n_nodes(), 0.)
    , displaced(shape)
    , forces(shape)
    , displaced_forces(shape)
  {
    const std::vector<double> &volumes = solid.cell_volumes();
    const double smallest =
      volumes.empty() ? 1. : *std::min_element(volumes.begin(), volumes.end());
    displacement = 1e-5 * std::pow(smallest, 1. / dim);
  }



  template <int dim>
  typename SolidOperator<dim>::StepBound
  LargestFrequency<dim>::update(const double *X)
  {
    auto result        = solid.step_bound(X);
    const double bound = result.omega;
    if (!std::isfinite(bound))
      return result;

    if (is_new)
      for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
        disturb(cell, 1.);
    disturb(result.cell, is_new ? 1. : largest_component());
    normalize();

    compute_forces({X, X + shape.size()}, forces);
    const unsigned int n_iterations = is_new ? 40 : 3;
    double square                   = 0;
    for (unsigned int i = 0; i < n_iterations; ++i)
      square = iterate(X);
    is_new = false;

    const double largest_ratio = solid.averages_volume() ? 2.5 : 1.8;
    result.omega =
      std::min(bound,
               std::max(1.05 * std::sqrt(square), bound / largest_ratio));
    result.xi *= bound / result.omega;
    return result;
  }



  template <int dim>
  void
  LargestFrequency<dim>::disturb(const unsigned int cell, const double largest)
  {
    std::uniform_real_distribution<double> random(-1, 1);
    for (const unsigned int node : mesh.cells[cell])
      if (!pinned[node])
        for (unsigned int d = 0; d < dim; ++d)
          shape[dim * node + d] += 0.3 * largest * random(noise);
  }



  template <int dim>
  double
  LargestFrequency<dim>::largest_component() const
  {
    double largest = 0;
    for (const double component : shape)
      largest = std::max(largest, std::abs(component));
    return largest;
  }



  template <int dim>
  double
  LargestFrequency<dim>::iterate(const double *X)
  {
    const double largest = largest_component();
    if (largest == 0)
      return 0;
    const double scale = displacement / largest;
    for (unsigned int i = 0; i < shape.size(); ++i)
      displaced[i] = X[i] + scale * shape[i];
    compute_forces(displaced, displaced_forces);
    for (unsigned int i = 0; i < shape.size(); ++i)
      displaced_forces[i] = forces[i] - displaced_forces[i];
    dealii::Utilities::MPI::sum(displaced_forces, communicator, shape);
    for (unsigned int n = 0; n < solid.n_nodes(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        shape[dim * n + d] *= pinned[n] ? 0. : 1 / (scale * solid.mass()[n]);
    return normalize();
  }



  template <int dim>
  void
  LargestFrequency<dim>::compute_forces(const std::vector<double> &X,
                                        std::vector<double> &F) const
  {
    const std::vector<double> rest(X.size(), 0.);
    std::fill(F.begin(), F.end(), 0.);
    solid.add_forces(X.data(), rest.data(), F.data());
  }



  template <int dim>
  double
  LargestFrequency<dim>::normalize()
  {
    double square = 0;
    for (unsigned int n = 0; n < solid.n_nodes(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        square += solid.mass()[n] * shape[dim * n + d] * shape[dim * n + d];
    const double norm = std::sqrt(square);
    if (norm > 0)
      for (double &component : shape)
        component /= norm;
    return norm;
  }



  template class LargestFrequency<2>;
  template class LargestFrequency<3>;
} // namespace coapt
