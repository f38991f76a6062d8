#ifndef coapt_io_fluid_piece_h
#define coapt_io_fluid_piece_h

#include <coapt/io/vtu_file.h>

#include <deal.II/base/point.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace coapt
{
  template <int dim>
  class FluidGrid;
  template <int dim>
  class FluidOperator;

  /** The part of the fluid's cells and nodes that this rank writes: owned
   * cells that carry fluid, and their nodes. */
  template <int dim>
  struct FluidPiece
  {
    explicit FluidPiece(const FluidOperator<dim> &fluid);

    /** A file of these cells with the velocity (m/s). */
    VtuFile
    file(const double *velocity_local) const;

    /** Levels of refinement of these cells. */
    std::vector<double>
    levels(const FluidGrid<dim> &grid, const FluidOperator<dim> &fluid) const;

    std::vector<dealii::Point<3>> points; // m, in the plane z = 0 in 2D
    std::vector<unsigned int> connectivity;
    std::vector<unsigned int> cells; // numbers of owned cells
    std::vector<unsigned int> nodes; // local node behind each point
  };

  /** Writes this rank's @p file as @p folder/NAME.RANK.vtu and the index
   * NAME.pvtu of those of all ranks, the name of which is returned. */
  std::string
  write_distributed(const VtuFile &file,
                    const std::string &folder,
                    const std::string &name,
                    MPI_Comm communicator);

  /** "NAME_00012". */
  std::string
  numbered(const std::string &name, const std::size_t number);
} // namespace coapt

#endif
