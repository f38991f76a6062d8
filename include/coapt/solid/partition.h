#ifndef coapt_solid_partition_h
#define coapt_solid_partition_h

#include <coapt/geometry/simplex_mesh.h>

#include <mpi.h>

#include <vector>

namespace coapt
{
  /**
   * Numbers, in ascending order, of the cells of @p mesh that this rank of
   * @p communicator evaluates: each cell belongs to one rank, the numbers of
   * cells are balanced, and few cells of different ranks share a face (METIS
   * on the dual graph). Collective. @throws NumericalError if METIS fails.
   */
  template <int dim>
  std::vector<unsigned int>
  partition_cells(const SimplexMesh<dim> &mesh, const MPI_Comm communicator);
} // namespace coapt

#endif
