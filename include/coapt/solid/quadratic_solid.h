#ifndef coapt_solid_quadratic_solid_h
#define coapt_solid_quadratic_solid_h

#include <coapt/geometry/quadratic_mesh.h>
#include <coapt/solid/materials/material.h>
#include <coapt/solid/small_matrix.h>

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <vector>

namespace coapt
{
  /**
   * The semi-discrete solid M X'' = -F_int(X) - F_visc(V) of SolidOperator on
   * tetrahedra of ten nodes: stresses at four points (exact for linear
   * elasticity, and of full rank, so that no motion but a rigid one is free of
   * energy), and masses lumped in proportion to the diagonal of the consistent
   * mass matrix (Hinton, Rock and Zienkiewicz, 1976): 1/36 of an element's at
   * each vertex, 4/27 at each edge.
   *
   * Nodal arrays hold all nodes on every rank, [3 * node + component]; the
   * cells are divided among the ranks.
   */
  class QuadraticSolid
  {
  public:
    /**
     * @p density in kg/m^3, @p viscosity in Pa s; @p fibre (one vector a cell)
     * may be empty for a material without.
     *
     * @throws InputError if a cell is inverted, or if the fibres are of another
     * number than the cells.
     */
    QuadraticSolid(const QuadraticMesh &mesh,
                   const Material &material,
                   const double density,
                   const double viscosity,
                   const std::vector<dealii::Tensor<1, 3>> &fibre,
                   const MPI_Comm communicator);

    /** Number of nodes. */
    unsigned int
    n_nodes() const
    {
      return nodal_mass.size();
    }

    /** Lumped mass of every node (kg), of the cells of all ranks. */
    const std::vector<double> &
    mass() const
    {
      return nodal_mass;
    }

    /** Subtracts from @p F (N) the internal and viscous forces of this rank's
     * cells, at the positions @p X (m) and velocities @p V (m/s). */
    void
    add_forces(const double *X, const double *V, double *F) const;

    /** Elastic energy of the whole solid (J). Collective. */
    double
    elastic_energy(const double *X) const;

    /** Bound of the highest angular frequency (1/s) at the positions @p X, by
     * element as in SolidOperator, the nodes of each in groups of four.
     * Collective. */
    double
    max_frequency(const double *X) const;

  private:
    /** Eight cells, as CellBatch. */
    struct Batch10
    {
      /** Stress is evaluated here: gradients of the shape functions of the
       * nodes 1 to 9, and share of the volume. */
      struct Point
      {
        Batch gradient[9][3];
        Batch volume;
      };

      /** Sum over the nodes of their values relative to node 0 (x) gradient. */
      static SmallMatrix<3, Batch>
      gradient_of(const Batch (&relative)[9][3], const Point &point);

      /** Values of @p x at the nodes 1 to 9 relative to node 0. */
      void
      load(const double *x, Batch (&relative)[9][3]) const;

      Point point[4];
      Batch fibre[9]; // the unit fibre; what else materials look for is zero
      int entry[10][batch_size];
      unsigned int n_filled;
    };

    void
    build(const QuadraticMesh &mesh,
          const std::vector<unsigned int> &cells,
          const std::vector<dealii::Tensor<1, 3>> &fibre);

    template <typename Law>
    double
    local_max_frequency(const Law &law, const double *X) const;

    const MPI_Comm communicator;
    const Material material;
    const double density, viscosity;
    std::vector<double> nodal_mass;
    std::vector<Batch10> batches;
  };
} // namespace coapt

#endif
