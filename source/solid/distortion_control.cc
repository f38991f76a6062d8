#include <coapt/solid/distortion_control.h>
#include <coapt/solid/stress_and_strain.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Tensor;

  SmallestStretch
  smallest_stretch(const SmallMatrix<3, double> &F)
  {
    SmallMatrix<3, double> C = right_cauchy_green(F), directions;
    diagonalise(C, directions);
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (C[i][i] < C[least][least])
        least = i;
    const double size = std::sqrt(std::max(0., C[least][least]));
    SmallestStretch result;
    result.value = determinant(F, cofactors(F)) < 0 ? -size : size;
    result.after.fill(0);
    for (int i = 0; i < 3; ++i)
      {
        result.before[i] = directions[i][least];
        for (int j = 0; j < 3 && size > 0; ++j)
          result.after[i] += F[i][j] * directions[j][least] / result.value;
      }
    return result;
  }



  template <int dim>
  DistortionControl<dim>::DistortionControl(
    const SimplexMesh<dim> &mesh,
    const std::vector<unsigned int> &numbers,
    const double threshold,
    const double modulus)
    : threshold(threshold), stiffness(modulus / (threshold * threshold))
  {
    const double simplices_in_box = dim == 2 ? 2 : 6;
    for (const unsigned int number : numbers)
      {
        Cell cell;
        cell.nodes = mesh.cells[number];
        Tensor<2, dim> edges;
        for (unsigned int a = 0; a < dim; ++a)
          {
            const Tensor<1, dim> edge =
              mesh.points[cell.nodes[a + 1]] - mesh.points[cell.nodes[0]];
            for (unsigned int d = 0; d < dim; ++d)
              edges[d][a] = edge[d];
          }
        cell.to_reference = invert(edges);
        cell.volume       = std::abs(determinant(edges)) / simplices_in_box;
        cells.push_back(cell);
      }
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
  bool
  DistortionControl<dim>::may_be_distorted(const Tensor<2, dim> &F) const
  {
    // The product of the other stretches is at most
    // (|F|^2/(dim-1))^((dim-1)/2).
    const double J = determinant(F);
    const double largest =
      std::pow(F.norm_square() / (dim - 1), 0.5 * (dim - 1));
    return J < threshold * largest;
  }



  template <int dim>
  void
  DistortionControl<dim>::add_forces(const double *X, double *F) const
  {
    for (const Cell &cell : cells)
      {
        const Tensor<2, dim> G = gradient(cell, X);
        if (!may_be_distorted(G))
          continue;
        const SmallestStretch stretch = smallest_stretch(embed(G));
        if (stretch.value >= threshold)
          continue;
        // force of node a: -V P grad N_a, and none in sum
        const double size =
          cell.volume * stiffness * (threshold - stretch.value);
        for (unsigned int a = 0; a < dim; ++a)
          {
            double along = 0;
            for (unsigned int d = 0; d < dim; ++d)
              along += cell.to_reference[a][d] * stretch.before[d];
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double force = size * along * stretch.after[d];
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
    for (const Cell &cell : cells)
      {
        const Tensor<2, dim> F = gradient(cell, X);
        if (!may_be_distorted(F))
          continue;
        const double below = threshold - smallest_stretch(embed(F)).value;
        if (below > 0)
          sum += cell.volume * 0.5 * stiffness * below * below;
      }
    return sum;
  }



  template class DistortionControl<2>;
  template class DistortionControl<3>;
} // namespace coapt
