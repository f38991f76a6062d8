#include <coapt/solid/nodal_average.h>

#include <deal.II/base/mpi.h>

namespace coapt
{
  template <int dim>
  NodalAverage<dim>::NodalAverage(const std::vector<CellBatch<dim>> &batches,
                                  const unsigned int n_nodes,
                                  MPI_Comm communicator)
    : communicator(communicator), n_nodes(n_nodes)
  {
    inverse_volume =
      nodal_sums(batches, std::vector<Batch>(batches.size(), Batch{} + 1.));
    for (double &volume : inverse_volume)
      volume = volume > 0 ? 1 / volume : 0; // some nodes have no cell
  }



  template <int dim>
  std::vector<double>
  NodalAverage<dim>::nodal_sums(const std::vector<CellBatch<dim>> &batches,
                                const std::vector<Batch> &values) const
  {
    std::vector<double> sums(n_nodes, 0.);
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const Batch product = batches[b].point[0].volume * values[b];
        for (const auto &entries : batches[b].entry)
          for (unsigned int lane = 0; lane < batches[b].n_filled; ++lane)
            sums[entries[lane] / dim] += product[lane];
      }
    dealii::Utilities::MPI::sum(sums, communicator, sums);
    return sums;
  }



  template <int dim>
  std::vector<Batch>
  NodalAverage<dim>::apply(const std::vector<CellBatch<dim>> &batches,
                           const std::vector<Batch> &values) const
  {
    std::vector<double> means = nodal_sums(batches, values);
    for (unsigned int node = 0; node < n_nodes; ++node)
      means[node] *= inverse_volume[node];

    std::vector<Batch> result(batches.size());
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        Batch sum{};
        for (const auto &entries : batches[b].entry)
          for (unsigned int lane = 0; lane < batch_size; ++lane)
            sum[lane] += means[entries[lane] / dim];
        result[b] = sum / double(dim + 1);
      }
    return result;
  }

  template class NodalAverage<2>;
  template class NodalAverage<3>;
} // namespace coapt
