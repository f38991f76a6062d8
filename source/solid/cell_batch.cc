#include <coapt/solid/cell_batch.h>

#include <algorithm>

namespace coapt
{
  namespace
  {
    /** Matrix of the edge vectors from node 0, as columns (m). */
    template <int dim>
    dealii::Tensor<2, dim>
    edges(const SimplexMesh<dim> &mesh, const unsigned int cell)
    {
      const auto &nodes = mesh.cells[cell];
      dealii::Tensor<2, dim> E;
      for (int a = 0; a < dim; ++a)
        for (int c = 0; c < dim; ++c)
          E[c][a] = mesh.points[nodes[a + 1]][c] - mesh.points[nodes[0]][c];
      return E;
    }

    template <int dim>
    double
    signed_volume(const SimplexMesh<dim> &mesh, const unsigned int cell)
    {
      return determinant(edges(mesh, cell)) / (dim == 2 ? 2. : 6.);
    }

    /** Sets the directions of the entry @p lane. */
    template <int dim>
    void
    fill_directions(CellBatch<dim> &batch,
                    const unsigned int lane,
                    const dealii::Tensor<1, dim> &fibre,
                    const dealii::Tensor<1, dim> &normal)
    {
      for (Batch &component : batch.fibre)
        component[lane] = 0;
      if (!(fibre.norm() > 0))
        return;
      const auto along = fibre / fibre.norm();
      for (int d = 0; d < dim; ++d)
        batch.fibre[d][lane] = along[d];
      if constexpr (dim == 3)
        {
          auto up = normal - (normal * along) * along;
          if (!(up.norm() > 1e-6 * normal.norm()))
            return;
          up /= up.norm();
          const auto across = cross_product_3d(up, along);
          for (int d = 0; d < 3; ++d)
            {
              batch.fibre[3 + d][lane] = across[d];
              batch.fibre[6 + d][lane] = up[d];
            }
        }
    }

    /** Sets the entry @p lane of the @p batch to a @p cell. */
    template <int dim>
    void
    fill(CellBatch<dim> &batch,
         const unsigned int lane,
         const SimplexMesh<dim> &mesh,
         const unsigned int cell,
         const dealii::Tensor<1, dim> &fibre,
         const dealii::Tensor<2, dim> &prestretch,
         const dealii::Tensor<1, dim> &normal)
    {
      // Row a of E^-1 is the gradient of node a + 1 relative to the mesh.
      const auto gradients = invert(edges(mesh, cell)) * prestretch;
      batch.cell[lane]     = cell;
      batch.volume[lane]   = signed_volume(mesh, cell);
      fill_directions(batch, lane, fibre, normal);
      for (int d = 0; d < dim; ++d)
        for (int a = 0; a < dim; ++a)
          batch.gradient[a][d][lane] = gradients[a][d];
      for (int a = 0; a <= dim; ++a)
        batch.entry[a][lane] = dim * mesh.cells[cell][a];
    }
  } // namespace

  template <int dim>
  std::vector<CellBatch<dim>>
  build_batches(const SimplexMesh<dim> &mesh,
                const std::vector<unsigned int> &cells,
                const std::vector<dealii::Tensor<1, dim>> &fibre,
                const std::vector<dealii::Tensor<2, dim>> &prestretch,
                const std::vector<dealii::Tensor<1, dim>> &normal)
  {
    dealii::Tensor<2, dim> identity;
    for (int d = 0; d < dim; ++d)
      identity[d][d] = 1;
    std::vector<CellBatch<dim>> batches((cells.size() + batch_size - 1) /
                                        batch_size);
    for (unsigned int i = 0; i < batches.size() * batch_size; ++i)
      {
        const bool used         = i < cells.size();
        const unsigned int cell = used ? cells[i] : cells.back();
        CellBatch<dim> &batch   = batches[i / batch_size];
        fill(batch,
             i % batch_size,
             mesh,
             cell,
             fibre.empty() ? dealii::Tensor<1, dim>() : fibre[cell],
             prestretch.empty() ? identity : prestretch[cell],
             normal.empty() ? dealii::Tensor<1, dim>() : normal[cell]);
        if (used)
          batch.n_filled = i % batch_size + 1;
        else
          batch.volume[i % batch_size] = 0;
      }
    return batches;
  }

  template <int dim>
  std::vector<double>
  signed_volumes(const SimplexMesh<dim> &mesh)
  {
    std::vector<double> volumes(mesh.cells.size());
    for (unsigned int i = 0; i < volumes.size(); ++i)
      volumes[i] = signed_volume(mesh, i);
    return volumes;
  }

  template std::vector<CellBatch<2>>
  build_batches(const SimplexMesh<2> &,
                const std::vector<unsigned int> &,
                const std::vector<dealii::Tensor<1, 2>> &,
                const std::vector<dealii::Tensor<2, 2>> &,
                const std::vector<dealii::Tensor<1, 2>> &);
  template std::vector<CellBatch<3>>
  build_batches(const SimplexMesh<3> &,
                const std::vector<unsigned int> &,
                const std::vector<dealii::Tensor<1, 3>> &,
                const std::vector<dealii::Tensor<2, 3>> &,
                const std::vector<dealii::Tensor<1, 3>> &);
  template std::vector<double>
  signed_volumes(const SimplexMesh<2> &);
  template std::vector<double>
  signed_volumes(const SimplexMesh<3> &);
} // namespace coapt
