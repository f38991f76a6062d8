#ifndef coapt_solid_solid_setup_h
#define coapt_solid_solid_setup_h

#include <coapt/geometry/simplex_mesh.h>

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace coapt
{
  /** What a SolidOperator asks of its mesh, and what follows from it once. @{
   */

  /** @throws InputError if elements of the @p mesh are inverted or without
   * volume; the first ten are listed. */
  template <int dim, int degree>
  void
  check_volumes(const SimplexMesh<dim> &mesh);

  /** @throws InputError if the number @p size of the vectors with that @p name
   * is not @p n_cells. */
  void
  check_size(const std::string &name,
             const std::size_t size,
             const std::size_t n_cells);

  /** @throws InputError if fibres (where needed) or prestretches are not as
   * many as cells, zero or singular. */
  template <int dim>
  void
  check_fields(const std::vector<dealii::Tensor<1, dim>> &fibre,
               const std::vector<dealii::Tensor<2, dim>> &prestretch,
               const bool needs_fibre,
               const std::size_t n_cells);

  /** Mass (kg, in 2D kg/m) of every node from its elements, plus the @p added
   * one of the last nodes. @throws InputError for nodes without mass. */
  template <int dim, int degree>
  std::vector<double>
  lumped_mass(const SimplexMesh<dim> &mesh,
              const double density,
              const std::vector<double> &added);

  /** Numbers of the elements that this rank evaluates. Collective. */
  template <int dim, int degree>
  std::vector<unsigned int>
  own_elements(const SimplexMesh<dim> &mesh, const MPI_Comm communicator);

  /** @} */
} // namespace coapt

#endif
