#include <coapt/base/exceptions.h>
#include <coapt/solid/cell_batch.h>
#include <coapt/solid/partition.h>
#include <coapt/solid/solid_setup.h>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace coapt
{
  void
  check_size(const std::string &name,
             const std::size_t size,
             const std::size_t n_cells)
  {
    if (size != n_cells)
      throw InputError("Solid: " + std::to_string(size) + " " + name +
                       " are given for " + std::to_string(n_cells) +
                       " cells, one a cell is needed.");
  }



  template <int dim, int degree>
  void
  check_volumes(const SimplexMesh<dim> &mesh)
  {
    const auto volumes  = point_volumes<dim, degree>(mesh);
    const auto &cells   = elements<dim, degree>(mesh);
    const auto inverted = [](const double volume) { return !(volume > 0); };
    unsigned int n_bad  = 0;
    std::ostringstream list;
    for (unsigned int i = 0; i < volumes.size(); ++i)
      if (std::any_of(volumes[i].begin(), volumes[i].end(), inverted) &&
          ++n_bad <= 10)
        {
          dealii::Point<dim> centre;
          for (const unsigned int node : cells[i])
            centre += mesh.points[node] / double(cells[i].size());
          list << (n_bad > 1 ? "; " : "") << i << " at (" << centre * 1e3
               << ") mm";
        }
    if (n_bad > 0)
      throw InputError("Solid mesh: " + std::to_string(n_bad) +
                       " cells are inverted or without volume, all must "
                       "have positive volume: " +
                       list.str() + (n_bad > 10 ? "; ..." : "") + ".");
  }



  template <int dim>
  void
  check_fields(const std::vector<dealii::Tensor<1, dim>> &fibre,
               const std::vector<dealii::Tensor<2, dim>> &prestretch,
               const bool needs_fibre,
               const std::size_t n_cells)
  {
    if (needs_fibre || !fibre.empty())
      check_size("fibres", fibre.size(), n_cells);
    if (!prestretch.empty())
      check_size("prestretches", prestretch.size(), n_cells);
    for (unsigned int i = 0; i < n_cells; ++i)
      {
        if (needs_fibre && !(fibre[i].norm() > 0))
          throw InputError("Solid: the fibre of cell " + std::to_string(i) +
                           " is zero or not a number, the material needs "
                           "one in every cell.");
        if (!prestretch.empty() && !(determinant(prestretch[i]) > 0))
          throw InputError("Solid: the prestretch of cell " +
                           std::to_string(i) + " has no positive determinant.");
      }
  }



  template <int dim, int degree>
  std::vector<double>
  lumped_mass(const SimplexMesh<dim> &mesh,
              const double density,
              const std::vector<double> &added)
  {
    std::vector<double> mass(mesh.points.size(), 0.);
    const unsigned int n_own = mass.size() - added.size();
    std::copy(added.begin(), added.end(), mass.begin() + n_own);
    const auto volumes = point_volumes<dim, degree>(mesh);
    for (unsigned int i = 0; i < volumes.size(); ++i)
      {
        const double volume =
          std::accumulate(volumes[i].begin(), volumes[i].end(), 0.);
        const auto &nodes = elements<dim, degree>(mesh)[i];
        for (unsigned int a = 0; a < nodes.size(); ++a)
          mass[nodes[a]] +=
            density * volume * CellBatch<dim, degree>::mass_share(a);
      }
    std::ostringstream list;
    unsigned int n_bad = 0;
    for (unsigned int node = 0; node < n_own; ++node)
      if (!(mass[node] > 0) && ++n_bad <= 10)
        list << (n_bad > 1 ? "; " : "") << node << " at ("
             << mesh.points[node] * 1e3 << ") mm";
    if (n_bad > 0)
      throw InputError("Solid mesh: " + std::to_string(n_bad) +
                       " nodes belong to no cell: " + list.str() +
                       (n_bad > 10 ? "; ..." : "") + ".");
    return mass;
  }



  template <int dim, int degree>
  std::vector<unsigned int>
  own_elements(const SimplexMesh<dim> &mesh, const MPI_Comm communicator)
  {
    if constexpr (degree == 1)
      return partition_cells(mesh, communicator);
    else
      {
        SimplexMesh<dim> between_vertices;
        between_vertices.points = mesh.points;
        for (const auto &nodes : mesh.quadratic_cells)
          {
            between_vertices.cells.emplace_back();
            std::copy_n(nodes.begin(),
                        dim + 1,
                        between_vertices.cells.back().begin());
          }
        return partition_cells(between_vertices, communicator);
      }
  }

#define INSTANTIATE(dim, degree)                                          \
  template void check_volumes<dim, degree>(const SimplexMesh<dim> &);     \
  template std::vector<double> lumped_mass<dim, degree>(                  \
    const SimplexMesh<dim> &, const double, const std::vector<double> &); \
  template std::vector<unsigned int> own_elements<dim, degree>(           \
    const SimplexMesh<dim> &, const MPI_Comm);
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE

  template void
  check_fields<2>(const std::vector<dealii::Tensor<1, 2>> &,
                  const std::vector<dealii::Tensor<2, 2>> &,
                  const bool,
                  const std::size_t);
  template void
  check_fields<3>(const std::vector<dealii::Tensor<1, 3>> &,
                  const std::vector<dealii::Tensor<2, 3>> &,
                  const bool,
                  const std::size_t);
} // namespace coapt
