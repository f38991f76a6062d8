#ifndef coapt_solid_cell_batch_h
#define coapt_solid_cell_batch_h

#include <coapt/geometry/simplex_mesh.h>
#include <coapt/solid/small_matrix.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace coapt
{
  /**
   * A batch of linear simplices, ready for evaluation: all that does not
   * change while the solid moves. Unused entries at the end of the last batch
   * repeat a cell with no volume.
   */
  template <int dim>
  struct CellBatch
  {
    /** Gradients of the shape functions of the nodes 1 to dim with respect to
     * the stress-free configuration (1/m); that of node 0 is minus their sum.
     */
    Batch gradient[dim][dim];

    /** Volumes (m^3, in 2D m^2) in the reference. */
    Batch volume;

    /** Unit fibre vectors in the stress-free configuration. */
    Batch fibre[dim];

    /** Index of each node's first entry in a nodal array. */
    unsigned int entry[dim + 1][batch_size];

    /** Numbers of the cells, and how many of them are used. */
    unsigned int cell[batch_size];
    unsigned int n_filled;

    /** Sum over the nodes of @p x (x) gradient for a nodal vector @p x. */
    SmallMatrix<dim, Batch>
    gradient_of(const double *x) const
    {
      alignas(Batch) double values[dim + 1][dim][batch_size];
      for (int a = 0; a <= dim; ++a)
        for (unsigned int lane = 0; lane < batch_size; ++lane)
          for (int c = 0; c < dim; ++c)
            values[a][c][lane] = x[entry[a][lane] + c];
      SmallMatrix<dim, Batch> G{};
      for (int c = 0; c < dim; ++c)
        {
          const Batch &origin = reinterpret_cast<Batch &>(values[0][c]);
          for (int a = 0; a < dim; ++a)
            {
              const Batch edge =
                reinterpret_cast<Batch &>(values[a + 1][c]) - origin;
              for (int d = 0; d < dim; ++d)
                G[c][d] += edge * gradient[a][d];
            }
        }
      return G;
    }

    /**
     * Adds to the nodal vector @p f minus the forces of the first
     * Piola-Kirchhoff stress @p P, that is -volume P gradient.
     */
    void
    subtract_divergence(const SmallMatrix<dim, Batch> &P, double *f) const
    {
      alignas(Batch) double values[dim + 1][dim][batch_size];
      for (int c = 0; c < dim; ++c)
        {
          Batch sum{};
          for (int a = 0; a < dim; ++a)
            {
              Batch force = P[c][0] * gradient[a][0];
              for (int d = 1; d < dim; ++d)
                force += P[c][d] * gradient[a][d];
              force *= volume;
              sum += force;
              reinterpret_cast<Batch &>(values[a + 1][c]) = force;
            }
          reinterpret_cast<Batch &>(values[0][c]) = -sum;
        }
      for (unsigned int lane = 0; lane < n_filled; ++lane)
        for (int a = 0; a <= dim; ++a)
          for (int c = 0; c < dim; ++c)
            f[entry[a][lane] + c] -= values[a][c][lane];
    }

    /** Gradients of all shape functions [node][component] (1/m). */
    void
    all_gradients(Batch (&g)[dim + 1][dim]) const
    {
      for (int d = 0; d < dim; ++d)
        {
          g[0][d] = Batch{};
          for (int a = 0; a < dim; ++a)
            {
              g[a + 1][d] = gradient[a][d];
              g[0][d] -= gradient[a][d];
            }
        }
    }
  };

  /**
   * Batches of the given @p cells of @p mesh. @p fibre (per cell, any length
   * but zero) and @p prestretch F0 (per cell; elastic deformation gradient
   * F F0, where F is relative to the mesh) may be empty.
   */
  template <int dim>
  std::vector<CellBatch<dim>>
  build_batches(const SimplexMesh<dim> &mesh,
                const std::vector<unsigned int> &cells,
                const std::vector<dealii::Tensor<1, dim>> &fibre,
                const std::vector<dealii::Tensor<2, dim>> &prestretch);

  /**
   * Volume of every cell (m^3, in 2D m^2), negative if it is inverted.
   */
  template <int dim>
  std::vector<double>
  signed_volumes(const SimplexMesh<dim> &mesh);
} // namespace coapt

#endif
