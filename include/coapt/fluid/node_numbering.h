#ifndef coapt_fluid_node_numbering_h
#define coapt_fluid_node_numbering_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>

#include <memory>
#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
  template <int dim, int spacedim>
  class DoFHandler;
} // namespace dealii

namespace coapt
{
  /**
   * The nodes (vertices) of the octree that a rank knows: first those it
   * owns, then copies of others ("ghosts"): all nodes of its own cells and of
   * one layer of cells around them, and all masters of the hanging nodes
   * among these. Nodal vectors are arrays with dim consecutive entries
   * a node; "owned" arrays end after the owned nodes, "local" ones have all.
   *
   * gather() and collect() are adjoint to each other: with u = gather(U) and
   * F = collect(f) the power sum f.u over the local nodes of all ranks equals
   * sum F.U over the owned nodes of all ranks.
   */
  template <int dim>
  class NodeNumbering
  {
  public:
    /** Numbers the nodes of @p triangulation. Collective. */
    void
    reinit(const dealii::Triangulation<dim, dim> &triangulation);

    /** Number of nodes this rank owns. */
    unsigned int
    n_owned() const;

    /** Number of owned nodes and ghosts. */
    unsigned int
    n_local() const;

    /** The scalar Q1 space behind the numbering. */
    const dealii::DoFHandler<dim, dim> &
    dof_handler() const;

    /** Local number of the node with a global number known here. */
    unsigned int
    local_number(const dealii::types::global_dof_index global) const;

    /** The numbers of the hanging nodes known here. */
    const std::vector<unsigned int> &
    hanging_nodes() const;

    /** The local numbers of the masters of the hanging node number
     * @p row of hanging_nodes(): two or four nodes of equal weight. */
    std::vector<unsigned int>
    masters(const unsigned int row) const;

    /** Copies owned values, fetches the ghosts, interpolates the hanging
     * nodes from their masters. Collective. */
    void
    gather(const double *owned, double *local) const;

    /** Adds the entries of hanging nodes to their masters and those of
     * ghosts to their owners; the sums are in the owned part of @p local,
     * the rest of which is zero afterwards. Collective. */
    void
    collect(double *local) const;

    /** Adds the entries of ghosts to their owners and sets them to zero.
     * Collective. */
    void
    add_ghosts(double *local) const;

    /** Overwrites the ghosts by the values of their owners. Collective. */
    void
    update_ghosts(double *local) const;

    /** Sets the hanging nodes to the means of their masters. */
    void
    interpolate_hanging_nodes(double *local) const;

    /** Adds the entries of hanging nodes to their masters and sets them to
     * zero. */
    void
    condense_hanging_nodes(double *local) const;

  private:
    /** Finds the masters of all owned hanging nodes, and fetches those of
     * the ghosts in @p relevant, some of which a rank could not find itself
     * because the coarse cell beside them is unknown to it. Returns global
     * numbers: four a node, unused ones -1. */
    std::vector<double>
    find_masters(const dealii::IndexSet &relevant) const;

    /** Sets up the list of hanging nodes. */
    void
    build_hanging_rows(const dealii::IndexSet &relevant,
                       const std::vector<double> &global_masters);

    std::shared_ptr<dealii::DoFHandler<dim, dim>> dofs;
    // made anew each time: deal.II's Partitioner fails when it is reused with
    // an index space of another size
    std::unique_ptr<dealii::Utilities::MPI::Partitioner> nodes;   // one index
    std::unique_ptr<dealii::Utilities::MPI::Partitioner> vectors; // dim indices

    std::vector<unsigned int> hanging;    // local node numbers
    std::vector<unsigned int> row_start;  // into row_master
    std::vector<unsigned int> row_master; // local node numbers

    mutable std::vector<double> send_buffer;
    mutable std::vector<MPI_Request> requests;
  };
} // namespace coapt

#endif
