#include <coapt/base/exceptions.h>
#include <coapt/solid/partition.h>

#include <deal.II/base/mpi.h>

#include <metis.h>

namespace coapt
{
  namespace
  {
    /** Owner of each cell; METIS wants several cells a part. */
    template <int dim>
    std::vector<int>
    owners(const SimplexMesh<dim> &mesh, const unsigned int n_ranks)
    {
      const unsigned int n_cells = mesh.cells.size();
      std::vector<int> owner(n_cells, 0);
      if (n_ranks == 1)
        return owner;
      if (n_cells < 4 * n_ranks)
        {
          for (unsigned int i = 0; i < n_cells; ++i)
            owner[i] = (i * n_ranks) / n_cells;
          return owner;
        }

      idx_t n_elements = n_cells, n_nodes = mesh.points.size(), n_common = dim,
            n_parts = n_ranks, n_cut = 0;
      std::vector<idx_t> start(1, 0), nodes;
      for (const auto &cell : mesh.cells)
        {
          nodes.insert(nodes.end(), cell.begin(), cell.end());
          start.push_back(nodes.size());
        }
      std::vector<idx_t> cell_part(n_cells), node_part(n_nodes);
      const int status = METIS_PartMeshDual(&n_elements,
                                            &n_nodes,
                                            start.data(),
                                            nodes.data(),
                                            nullptr,
                                            nullptr,
                                            &n_common,
                                            &n_parts,
                                            nullptr,
                                            nullptr,
                                            &n_cut,
                                            cell_part.data(),
                                            node_part.data());
      if (status != METIS_OK)
        throw NumericalError("METIS could not partition the solid (status " +
                             std::to_string(status) + ").");
      owner.assign(cell_part.begin(), cell_part.end());
      return owner;
    }
  } // namespace

  template <int dim>
  std::vector<unsigned int>
  partition_cells(const SimplexMesh<dim> &mesh, const MPI_Comm communicator)
  {
    // Every rank computes the same partition: METIS is deterministic.
    const int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    const std::vector<int> owner =
      owners(mesh, dealii::Utilities::MPI::n_mpi_processes(communicator));
    std::vector<unsigned int> cells;
    for (unsigned int i = 0; i < owner.size(); ++i)
      if (owner[i] == rank)
        cells.push_back(i);
    return cells;
  }

  template std::vector<unsigned int>
  partition_cells(const SimplexMesh<2> &, const MPI_Comm);
  template std::vector<unsigned int>
  partition_cells(const SimplexMesh<3> &, const MPI_Comm);
} // namespace coapt
