#ifndef coapt_coupled_replicated_nodes_h
#define coapt_coupled_replicated_nodes_h

#include <mpi.h>

#include <vector>

namespace coapt
{
  /**
   * Division of the solid's nodes, which every rank holds a copy of, into
   * contiguous ranges of which each rank advances one in time.
   */
  class ReplicatedNodes
  {
  public:
    /** @p n_nodes nodes with @p n_components values each. */
    ReplicatedNodes(const unsigned int n_nodes,
                    const unsigned int n_components,
                    MPI_Comm communicator);

    /** First node of this rank's range, and the number of nodes in it. @{ */
    unsigned int
    begin() const
    {
      return offsets[rank] / n_components;
    }

    unsigned int
    n_owned() const
    {
      return counts[rank] / n_components;
    }
    /** @} */

    /** Collects the owned ranges of all ranks in @p all. Collective. */
    void
    gather(const double *owned, double *all) const;

    /** Sums @p all over the ranks, in place. Collective. */
    void
    sum(double *all) const;

    /** Sum of @p all over the ranks for the nodes of this rank's range only,
     * in the order of the ranks. Collective. */
    void
    sum_owned(const double *all, double *owned) const;

  private:
    MPI_Comm communicator;
    int rank;
    int n_components;
    std::vector<int> counts;
    std::vector<int> offsets;

    /** For what others have for the nodes of this rank. */
    mutable std::vector<double> received;
  };
} // namespace coapt

#endif
