#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>
#include <coapt/io/fluid_piece.h>

#include <cmath>
#include <cstdio>

namespace coapt
{
  template <int dim>
  FluidPiece<dim>::FluidPiece(const FluidOperator<dim> &fluid)
  {
    const unsigned int unused = -1;
    std::vector<unsigned int> point_of_node(fluid.n_local_nodes(), unused);
    for (unsigned int i = 0; i < fluid.n_owned_cells(); ++i)
      {
        if (!fluid.is_active_cell(i))
          continue;
        cells.push_back(i);
        const auto &cell = fluid.cell(i);
        for (unsigned int corner = 0; corner < (1 << dim); ++corner)
          {
            unsigned int &number = point_of_node[cell.nodes[corner]];
            if (number == unused)
              {
                number = points.size();
                dealii::Point<3> position;
                for (unsigned int d = 0; d < dim; ++d)
                  position[d] = cell.lower[d] + ((corner >> d) & 1) * cell.size;
                points.push_back(position);
                nodes.push_back(cell.nodes[corner]);
              }
            connectivity.push_back(number);
          }
      }
  }



  template <int dim>
  VtuFile
  FluidPiece<dim>::file(const double *velocity_local) const
  {
    std::vector<double> velocity;
    for (const unsigned int node : nodes)
      for (unsigned int d = 0; d < 3; ++d)
        velocity.push_back(d < dim ? velocity_local[dim * node + d] : 0.);
    VtuFile result(points,
                   connectivity,
                   dim == 2 ? VtuFile::CellType::pixel
                            : VtuFile::CellType::voxel);
    result.add_point_data("velocity", 3, velocity);
    return result;
  }



  template <int dim>
  std::vector<double>
  FluidPiece<dim>::levels(const FluidGrid<dim> &grid,
                          const FluidOperator<dim> &fluid) const
  {
    std::vector<double> result;
    for (const unsigned int i : cells)
      result.push_back(
        std::round(std::log2(grid.cell_size(0) / fluid.cell(i).size)));
    return result;
  }



  std::string
  write_distributed(const VtuFile &file,
                    const std::string &folder,
                    const std::string &name,
                    MPI_Comm communicator)
  {
    int rank, n_ranks;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &n_ranks);
    const auto piece_name = [&](const int i) {
      return name + "." + std::to_string(i) + ".vtu";
    };
    file.write(folder + "/" + piece_name(rank));
    if (rank == 0)
      {
        std::vector<std::string> pieces;
        for (int i = 0; i < n_ranks; ++i)
          pieces.push_back(piece_name(i));
        file.write_index(folder + "/" + name + ".pvtu", pieces);
      }
    return name + ".pvtu";
  }



  std::string
  numbered(const std::string &name, const std::size_t number)
  {
    char text[16];
    std::snprintf(text, sizeof(text), "_%05zu", number);
    return name + text;
  }

  template struct FluidPiece<2>;
  template struct FluidPiece<3>;
} // namespace coapt
