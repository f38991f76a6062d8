#ifndef coapt_solid_nodal_average_h
#define coapt_solid_nodal_average_h

#include <coapt/solid/cell_batch.h>

#include <mpi.h>

#include <vector>

namespace coapt
{
  /**
   * Smooths numbers of the cells of linear simplices over the nodes: each node
   * takes the mean of its cells, by volume, and each cell the mean of its nodes
   * (nodal averages as in Bonet and Burton, 1998; their projection back onto
   * the cells as in Ortiz-Bernardin, Hale and Cyron, 2015).
   *
   * As a matrix this is symmetric with the volumes as weights, keeps what is
   * constant, and does not increase the sum of volume times square.
   */
  template <int dim>
  class NodalAverage
  {
  public:
    /** For the @p batches of this rank, in a mesh of @p n_nodes nodes.
     * Collective. */
    NodalAverage(const std::vector<CellBatch<dim>> &batches,
                 const unsigned int n_nodes,
                 MPI_Comm communicator);

    /** The smoothed @p values, one batch for each of @p batches, which are
     * those of the constructor. Collective. */
    std::vector<Batch>
    apply(const std::vector<CellBatch<dim>> &batches,
          const std::vector<Batch> &values) const;

  private:
    /** Sums over all ranks of volume times value at every node. */
    std::vector<double>
    nodal_sums(const std::vector<CellBatch<dim>> &batches,
               const std::vector<Batch> &values) const;

    MPI_Comm communicator;
    unsigned int n_nodes;
    std::vector<double> inverse_volume; // of the cells at each node, 1/m^dim
  };
} // namespace coapt

#endif
