#ifndef coapt_solid_cell_batch_h
#define coapt_solid_cell_batch_h

#include <coapt/geometry/simplex_mesh.h>
#include <coapt/solid/small_matrix.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

namespace coapt
{
  /**
   * A batch of linear (degree one) or quadratic (degree two) simplices, ready
   * for evaluation: all that does not change while the solid moves.
   * Unused entries at the end of the last batch repeat a cell with no volume.
   *
   * A quadratic one is isoparametric and has its stresses at four points (in
   * 2D three), which are exact for linear elasticity with straight edges, and
   * of full rank, so that no motion but a rigid one is free of energy.
   */
  template <int dim, int degree = 1>
  struct CellBatch
  {
    static_assert(degree == 1 || degree == 2, "no such element");

    /** Numbers of nodes and of points, each of which belongs to the vertex of
     * the same number, and of linear cells that an element consists of. @{ */
    static constexpr int n_nodes =
      degree == 1 ? dim + 1 : (dim + 1) * (dim + 2) / 2;
    static constexpr int n_points         = degree == 1 ? 1 : dim + 1;
    static constexpr unsigned int n_parts = degree == 1 ? 1 : 1 << dim;
    /** @} */

    /** Values at the nodes 1 to n_nodes - 1 relative to those at node 0. */
    using Values = Batch[n_nodes - 1][dim];

    /** What belongs to a point where the stress is evaluated. */
    struct Point
    {
      /** Gradients of the shape functions of the nodes 1 to n_nodes - 1 with
       * respect to the stress-free configuration (1/m); that of node 0 is
       * minus their sum. */
      Batch gradient[n_nodes - 1][dim];

      /** Volumes (m^3, in 2D m^2) in the reference. */
      Batch volume;

      /** Unit fibre vectors in the stress-free configuration. In 3D and with a
       * normal, the unit vectors across the fibre and along the normal follow.
       */
      Batch fibre[dim * dim];

      /** Sum over the nodes of @p x (x) gradient. */
      SmallMatrix<dim, Batch>
      gradient_of(const Values &x) const
      {
        SmallMatrix<dim, Batch> G{};
        for (int a = 0; a < n_nodes - 1; ++a)
          for (int c = 0; c < dim; ++c)
            for (int d = 0; d < dim; ++d)
              G[c][d] += x[a][c] * gradient[a][d];
        return G;
      }

      /** Adds to @p force minus the forces of the first Piola-Kirchhoff stress
       * @p P, that is -volume P gradient. */
      void
      subtract_divergence(const SmallMatrix<dim, Batch> &P, Values &force) const
      {
        for (int a = 0; a < n_nodes - 1; ++a)
          for (int c = 0; c < dim; ++c)
            {
              Batch product = P[c][0] * gradient[a][0];
              for (int d = 1; d < dim; ++d)
                product += P[c][d] * gradient[a][d];
              force[a][c] -= volume * product;
            }
      }
    };

    Point point[n_points];

    /** Index of each node's first entry in a nodal array. */
    int entry[n_nodes][batch_size];

    /** Numbers of the elements, and how many of them are used. */
    unsigned int cell[batch_size];
    unsigned int n_filled;

    /** Part of an element's mass at the node @p a: equal parts, or those in
     * proportion to the diagonal of the consistent mass matrix (Hinton, Rock
     * and Zienkiewicz, 1976). */
    static constexpr double
    mass_share(const int a)
    {
      if (degree == 1)
        return 1. / n_nodes;
      if (dim == 2)
        return a <= dim ? 1. / 19 : 16. / 57;
      return a <= dim ? 1. / 36 : 4. / 27;
    }

    /** Values of the nodal vector @p x. */
    void
    load(const double *x, Values &values) const
    {
      Batch origin[dim];
      load_nodes<dim>(x, entry[0], origin);
      for (int a = 0; a < n_nodes - 1; ++a)
        {
          load_nodes<dim>(x, entry[a + 1], values[a]);
          for (int c = 0; c < dim; ++c)
            values[a][c] -= origin[c];
        }
    }

    /** Adds to the nodal vector @p f the @p force on all nodes but node 0, and
     * to node 0 what balances them. */
    void
    add_balanced(const Values &force, double *f) const
    {
      Batch rest[dim] = {};
      for (int a = 0; a < n_nodes - 1; ++a)
        {
          for (int c = 0; c < dim; ++c)
            rest[c] -= force[a][c];
          add_to_nodes<dim>(f, entry[a + 1], n_filled, force[a]);
        }
      add_to_nodes<dim>(f, entry[0], n_filled, rest);
    }

    /** Gradients (1/m) of all shape functions at a point over the roots of the
     * shares of mass, in groups of as many as a linear cell has nodes; those
     * that are left over are zero. */
    static constexpr int n_groups = (n_nodes + dim) / (dim + 1);
    using Scaled                  = Batch[n_groups][dim + 1][dim];
    void
    scaled_gradients(const Point &point, Scaled &g) const
    {
      const auto scale = [](const int a) {
        return 1 / std::sqrt(mass_share(a));
      };
      for (int a = n_nodes; a < n_groups * (dim + 1); ++a)
        std::fill_n(g[a / (dim + 1)][a % (dim + 1)], dim, Batch{});
      for (int d = 0; d < dim; ++d)
        {
          g[0][0][d] = Batch{};
          for (int a = 1; a < n_nodes; ++a)
            {
              const Batch &gradient = point.gradient[a - 1][d];
              g[0][0][d] -= scale(0) * gradient;
              g[a / (dim + 1)][a % (dim + 1)][d] = scale(a) * gradient;
            }
        }
    }

    /** Part of the volume that belongs to the @p point. */
    Batch
    volume_share(const Point &point) const
    {
      Batch total{};
      for (const Point &each : this->point)
        total += each.volume;
      return point.volume / at_least(total, std::numeric_limits<double>::min());
    }
  };

  /** The elements of @p mesh of a degree, as lists of nodes. */
  template <int dim, int degree>
  const auto &
  elements(const SimplexMesh<dim> &mesh)
  {
    if constexpr (degree == 1)
      return mesh.cells;
    else
      return mesh.quadratic_cells;
  }

  /** Volumes (m^3, in 2D m^2) of the points of every element, negative where it
   * is inverted. */
  template <int dim, int degree>
  std::vector<std::array<double, CellBatch<dim, degree>::n_points>>
  point_volumes(const SimplexMesh<dim> &mesh);

  /**
   * Batches of the elements of @p mesh with the given numbers. @p fibre (per
   * linear cell, any length but zero) and @p prestretch F0 (per linear cell;
   * elastic deformation gradient F F0, where F is relative to the mesh) may be
   * empty, as may @p normal (per linear cell), of which the part across the
   * fibre counts. A point has those of the linear cell at its vertex.
   */
  template <int dim, int degree>
  std::vector<CellBatch<dim, degree>>
  build_batches(const SimplexMesh<dim> &mesh,
                const std::vector<unsigned int> &numbers,
                const std::vector<dealii::Tensor<1, dim>> &fibre,
                const std::vector<dealii::Tensor<2, dim>> &prestretch,
                const std::vector<dealii::Tensor<1, dim>> &normal);

  /**
   * Volume of every linear cell (m^3, in 2D m^2), negative if it is inverted.
   */
  template <int dim>
  std::vector<double>
  signed_volumes(const SimplexMesh<dim> &mesh);
} // namespace coapt

#endif
