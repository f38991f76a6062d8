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

    /** Unit fibre vectors in the stress-free configuration. In 3D and with a
     * normal, the unit vectors across the fibre and along the normal follow.
     */
    Batch fibre[dim * dim];

    /** Index of each node's first entry in a nodal array. */
    int entry[dim + 1][batch_size];

    /** Numbers of the cells, and how many of them are used. */
    unsigned int cell[batch_size];
    unsigned int n_filled;

    /** Sum over the nodes of @p x (x) gradient for a nodal vector @p x. */
    SmallMatrix<dim, Batch>
    gradient_of(const double *x) const
    {
      Batch origin[dim], edge[dim];
      SmallMatrix<dim, Batch> G{};
      load_nodes<dim>(x, entry[0], origin);
      for (int a = 0; a < dim; ++a)
        {
          load_nodes<dim>(x, entry[a + 1], edge);
          for (int c = 0; c < dim; ++c)
            {
              edge[c] -= origin[c];
              for (int d = 0; d < dim; ++d)
                G[c][d] += edge[c] * gradient[a][d];
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
      Batch force[dim], rest[dim] = {};
      for (int a = 0; a < dim; ++a)
        {
          for (int c = 0; c < dim; ++c)
            {
              force[c] = -P[c][0] * gradient[a][0];
              for (int d = 1; d < dim; ++d)
                force[c] -= P[c][d] * gradient[a][d];
              force[c] *= volume;
              rest[c] -= force[c];
            }
          add_to_nodes<dim>(f, entry[a + 1], n_filled, force);
        }
      add_to_nodes<dim>(f, entry[0], n_filled, rest);
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
   * F F0, where F is relative to the mesh) may be empty, as may @p normal (per
   * cell), of which the part across the fibre counts.
   */
  template <int dim>
  std::vector<CellBatch<dim>>
  build_batches(const SimplexMesh<dim> &mesh,
                const std::vector<unsigned int> &cells,
                const std::vector<dealii::Tensor<1, dim>> &fibre,
                const std::vector<dealii::Tensor<2, dim>> &prestretch,
                const std::vector<dealii::Tensor<1, dim>> &normal = {});

  /**
   * Volume of every cell (m^3, in 2D m^2), negative if it is inverted.
   */
  template <int dim>
  std::vector<double>
  signed_volumes(const SimplexMesh<dim> &mesh);
} // namespace coapt

#endif
