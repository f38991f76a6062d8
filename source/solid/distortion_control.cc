#include <coapt/solid/distortion_control.h>
#include <coapt/solid/stress_and_strain.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Tensor;

  PrincipalStretches
  principal_stretches(const SmallMatrix<3, double> &F)
  {
    PrincipalStretches result;
    SmallMatrix<3, double> C = right_cauchy_green(F);
    diagonalise(C, result.before);
    for (int k = 0; k < 3; ++k)
      {
        const double N[3] = {result.before[0][k],
                             result.before[1][k],
                             result.before[2][k]};
        double n[3];
        multiply(F, N, n);
        // More exact than the root of the eigenvalue where that is small.
        const double size = std::hypot(n[0], n[1], n[2]);
        result.value[k]   = size;
        for (int i = 0; i < 3; ++i)
          result.after[i][k] = size > 0 ? n[i] / size : 0.;
      }
    if (determinant(F, cofactors(F)) < 0)
      {
        const int least =
          std::min_element(result.value.begin(), result.value.end()) -
          result.value.begin();
        result.value[least] *= -1;
        for (int i = 0; i < 3; ++i)
          result.after[i][least] *= -1;
      }
    return result;
  }



  double
  smallest_stretch(const SmallMatrix<3, double> &F)
  {
    const PrincipalStretches stretches = principal_stretches(F);
    return *std::min_element(stretches.value.begin(), stretches.value.end());
  }



  namespace
  {
    /** Columns: from the first node to the others. */
    template <int dim>
    Tensor<2, dim>
    edges(const SimplexMesh<dim> &mesh,
          const std::array<unsigned int, dim + 1> &nodes)
    {
      Tensor<2, dim> result;
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int d = 0; d < dim; ++d)
          result[d][a] =
            mesh.points[nodes[a + 1]][d] - mesh.points[nodes[0]][d];
      return result;
    }

    template <int dim>
    double
    volume(const Tensor<2, dim> &edges)
    {
      return std::abs(determinant(edges)) / (dim == 2 ? 2 : 6);
    }

    /** A number that no principal stretch is below, positive unless the cell is
     * inverted: the product of the other stretches is at most
     * (|F|^2/(dim-1))^((dim-1)/2). */
    template <int dim>
    double
    lower_bound(const Tensor<2, dim> &F)
    {
      const double square = F.norm_square() / (dim - 1);
      return determinant(F) / (dim == 2 ? std::sqrt(square) : square);
    }
  } // namespace



  template <int dim>
  DistortionControl<dim>::DistortionControl(
    const SimplexMesh<dim> &mesh,
    const std::vector<unsigned int> &numbers,
    const double threshold,
    const double modulus,
    const std::vector<double> &mass)
    : threshold(threshold)
    , stiffness(modulus / (threshold * threshold))
    , n_nodes(mass.size())
  {
    std::vector<double> volume_at_nodes(n_nodes, 0.);
    for (const auto &nodes : mesh.cells)
      for (const unsigned int node : nodes)
        volume_at_nodes[node] += volume(edges(mesh, nodes));
    for (const unsigned int number : numbers)
      {
        Cell cell;
        cell.nodes               = mesh.cells[number];
        cell.number              = number;
        const Tensor<2, dim> all = edges(mesh, cell.nodes);
        cell.to_reference        = invert(all);
        cell.volume              = volume(all);
        set_bounds(cell, volume_at_nodes, mass);
        cells.push_back(cell);
      }
  }



  // The mass of a node is divided among its cells by volume. The largest
  // frequency of all is at most that of a cell with its masses.
  template <int dim>
  void
  DistortionControl<dim>::set_bounds(Cell &cell,
                                     const std::vector<double> &volume_at_nodes,
                                     const std::vector<double> &mass) const
  {
    Tensor<1, dim> first;
    cell.sensitivity      = 0;
    cell.square_frequency = 0;
    const auto add = [&](const unsigned int node, const Tensor<1, dim> &slope) {
      cell.sensitivity += slope.norm();
      cell.square_frequency +=
        stiffness * slope.norm_square() * volume_at_nodes[node] / mass[node];
    };
    for (unsigned int a = 0; a < dim; ++a)
      {
        add(cell.nodes[a + 1], cell.to_reference[a]);
        first -= cell.to_reference[a];
      }
    add(cell.nodes[0], first);
  }



  template <int dim>
  Tensor<2, dim>
  DistortionControl<dim>::gradient(const Cell &cell, const double *X)
  {
    Tensor<2, dim> edges;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        edges[d][a] =
          X[dim * cell.nodes[a + 1] + d] - X[dim * cell.nodes[0] + d];
    return edges * cell.to_reference;
  }



  template <int dim>
  const std::vector<unsigned int> &
  DistortionControl<dim>::candidates(const double *X) const
  {
    bool holds = reach >= 0;
    for (unsigned int node = 0; holds && node < n_nodes; ++node)
      {
        double square = 0;
        for (unsigned int i = dim * node; i < dim * (node + 1); ++i)
          square += (X[i] - origin[i]) * (X[i] - origin[i]);
        holds = square <= reach * reach;
      }
    if (!holds)
      find_candidates(X);
    return candidate_list;
  }



  // A stretch changes by no more than the norm of the change of the gradient.
  // The list has one cell in a hundred besides those that must be on it: few
  // enough to cost nothing, and the others are far from the threshold.
  template <int dim>
  void
  DistortionControl<dim>::find_candidates(const double *X) const
  {
    origin.assign(X, X + dim * n_nodes);
    candidate_list.clear();
    reach = 0;
    if (cells.empty())
      return;
    std::vector<double> ranges;
    for (const Cell &cell : cells)
      {
        const double range =
          (lower_bound(gradient(cell, X)) - threshold) / cell.sensitivity;
        // Broken positions are reported elsewhere, but must be sorted here.
        ranges.push_back(std::isfinite(range) ? range : -1.);
      }
    std::vector<double> sorted = ranges;
    const std::size_t n_must =
      std::count_if(ranges.begin(), ranges.end(), [](const double r) {
        return r <= 0;
      });
    const std::size_t last =
      std::min(n_must + cells.size() / 100, cells.size() - 1);
    std::nth_element(sorted.begin(), sorted.begin() + last, sorted.end());
    reach = std::max(0., sorted[last]);
    for (unsigned int c = 0; c < cells.size(); ++c)
      if (ranges[c] <= reach)
        candidate_list.push_back(c);
  }



  template <int dim>
  void
  DistortionControl<dim>::add_forces(const double *X, double *F) const
  {
    for (const unsigned int c : candidates(X))
      if (!(lower_bound(gradient(cells[c], X)) >= threshold))
        add_forces(cells[c], X, F);
  }



  template <int dim>
  void
  DistortionControl<dim>::add_forces(const Cell &cell,
                                     const double *X,
                                     double *F) const
  {
    const auto stretches = principal_stretches(embed(gradient(cell, X)));
    for (int k = 0; k < 3; ++k)
      {
        if (stretches.value[k] >= threshold)
          continue;
        // force of node a: -V P grad N_a, and none in sum
        const double size =
          cell.volume * stiffness * (threshold - stretches.value[k]);
        for (unsigned int a = 0; a < dim; ++a)
          {
            double along = 0;
            for (unsigned int d = 0; d < dim; ++d)
              along += cell.to_reference[a][d] * stretches.before[d][k];
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double force = size * along * stretches.after[d][k];
                F[dim * cell.nodes[a + 1] + d] += force;
                F[dim * cell.nodes[0] + d] -= force;
              }
          }
      }
  }



  template <int dim>
  double
  DistortionControl<dim>::energy(const double *X) const
  {
    double sum = 0;
    for (const unsigned int c : candidates(X))
      {
        const Tensor<2, dim> F = gradient(cells[c], X);
        if (lower_bound(F) >= threshold)
          continue;
        for (const double stretch : principal_stretches(embed(F)).value)
          {
            const double below = std::max(0., threshold - stretch);
            sum += cells[c].volume * 0.5 * stiffness * below * below;
          }
      }
    return sum;
  }



  // The step must be short enough before a cell gets there.
  template <int dim>
  typename DistortionControl<dim>::Bound
  DistortionControl<dim>::frequency_bound(const double *X) const
  {
    const double soon = 1.5 * threshold;
    Bound bound;
    for (const Cell &cell : cells)
      {
        if (cell.square_frequency <= bound.square)
          continue;
        const Tensor<2, dim> F = gradient(cell, X);
        if (lower_bound(F) < soon && smallest_stretch(embed(F)) < soon)
          bound = {cell.square_frequency, cell.number};
      }
    return bound;
  }



  template class DistortionControl<2>;
  template class DistortionControl<3>;
} // namespace coapt
