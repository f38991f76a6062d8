#include <coapt/base/exceptions.h>
#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>
#include <coapt/fluid/state_transfer.h>

#include <deal.II/base/utilities.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace coapt
{
  template <int dim>
  FluidGrid<dim>::FluidGrid(const MPI_Comm comm,
                            const dealii::Point<dim> &lower,
                            const dealii::Point<dim> &upper,
                            const std::array<unsigned int, dim> &coarse_cells)
    : octree(comm,
             dealii::Triangulation<dim>::limit_level_difference_at_vertices)
    , lower_corner(lower)
    , upper_corner(upper)
    , coarse_size((upper[0] - lower[0]) / std::max(1u, coarse_cells[0]))
  {
    double n_coarse = 1;
    for (const unsigned int n : coarse_cells)
      n_coarse *= n;
    if (n_coarse > 1e7)
      throw InputError("Fluid box: " + dealii::Utilities::to_string(n_coarse) +
                       " coarse cells, allowed are 10^7, since every process "
                       "keeps all of them; refine larger ones instead");
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double size =
          (upper[d] - lower[d]) / std::max(1u, coarse_cells[d]);
        if (coarse_cells[d] == 0 || !(size > 0) ||
            std::abs(size / coarse_size - 1) > 1e-6)
          {
            std::ostringstream message;
            message << "Fluid box: " << coarse_cells[d]
                    << " coarse cells of size " << size << " m in direction "
                    << d << ", but " << coarse_size
                    << " m in direction 0; coarse cells must be cubes.";
            throw InputError(message.str());
          }
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(
      octree,
      std::vector<unsigned int>(coarse_cells.begin(), coarse_cells.end()),
      lower,
      upper,
      true);
  }



  template <int dim>
  dealii::parallel::distributed::Triangulation<dim> &
  FluidGrid<dim>::triangulation()
  {
    return octree;
  }



  template <int dim>
  const dealii::parallel::distributed::Triangulation<dim> &
  FluidGrid<dim>::triangulation() const
  {
    return octree;
  }



  template <int dim>
  const dealii::Point<dim> &
  FluidGrid<dim>::lower() const
  {
    return lower_corner;
  }



  template <int dim>
  const dealii::Point<dim> &
  FluidGrid<dim>::upper() const
  {
    return upper_corner;
  }



  template <int dim>
  double
  FluidGrid<dim>::cell_size(const unsigned int level) const
  {
    return coarse_size / (1u << level);
  }



  template <int dim>
  bool
  FluidGrid<dim>::flag_cells(const WantedLevel &wanted_level)
  {
    const auto wanted = [&](const auto &cell) {
      return wanted_level((cell->vertex(0) + cell->vertex((1 << dim) - 1)) / 2,
                          cell_size(cell->level()));
    };
    // Cells of other ranks are flagged too: deal.II takes back coarsening next
    // to cells that it believes to stay, and the result would depend on
    // the number of ranks. Where this is too bold, p4est's balance undoes it.
    for (const auto &cell : octree.active_cell_iterators())
      {
        const unsigned int level  = cell->level();
        const unsigned int target = std::min(wanted(cell), max_level);
        if (target > level)
          cell->set_refine_flag();
        // the parent must agree, else it would be refined again at once
        else if (target < level && wanted(cell->parent()) < level)
          cell->set_coarsen_flag();
      }
    octree.prepare_coarsening_and_refinement();
    int any = 0;
    for (const auto &cell : octree.active_cell_iterators())
      if (cell->is_locally_owned() &&
          (cell->refine_flag_set() || cell->coarsen_flag_set()))
        any = 1;
    return dealii::Utilities::MPI::max(any, octree.get_communicator()) == 1;
  }



  template <int dim>
  void
  FluidGrid<dim>::refine_to(const WantedLevel &wanted_level)
  {
    // the balance may forbid to coarsen cells that ask for it forever: stop
    // when a sweep changes nothing
    const auto checksum = [this]() { // p4est gives it to the first rank only
      return dealii::Utilities::MPI::max<unsigned int>(
        octree.get_checksum(), octree.get_communicator());
    };
    auto before = checksum();
    while (flag_cells(wanted_level))
      {
        octree.execute_coarsening_and_refinement();
        const auto after = checksum();
        if (after == before)
          break;
        before = after;
      }
  }



  template <int dim>
  bool
  FluidGrid<dim>::adapt(const WantedLevel &wanted_level,
                        FluidOperator<dim> &op,
                        std::vector<double> &velocity_owned,
                        std::vector<double> &pressure_owned)
  {
    if (!flag_cells(wanted_level))
      return false;
    StateTransfer<dim> transfer(octree, op, velocity_owned, pressure_owned);
    octree.execute_coarsening_and_refinement();
    op.reinit(*this);
    transfer.unpack(velocity_owned, pressure_owned);
    return true;
  }

  template class FluidGrid<2>;
  template class FluidGrid<3>;
} // namespace coapt
