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
  bool
  FluidGrid<dim>::is_on_side(const dealii::Point<dim> &point,
                             const unsigned int side) const
  {
    const unsigned int d  = side / 2;
    const double position = (side % 2) ? upper_corner[d] : lower_corner[d];
    return std::abs(point[d] - position) <= 1e-6 * coarse_size;
  }



  template <int dim>
  double
  FluidGrid<dim>::cell_size(const unsigned int level) const
  {
    return coarse_size / (1u << level);
  }



  namespace
  {
    /** Center of the box of a cell. */
    template <typename CellIterator>
    auto
    center_of(const CellIterator &cell)
    {
      return (cell->vertex(0) + cell->vertex(cell->n_vertices() - 1)) / 2;
    }
  } // namespace



  template <int dim>
  void
  FluidGrid<dim>::divide_by(const Work &work)
  {
    using Octree = dealii::Triangulation<dim>;
    octree.signals.weight.disconnect_all_slots();
    octree.signals.weight.connect(
      [this, work](const typename Octree::cell_iterator &cell,
                   const typename Octree::CellStatus status) {
        const dealii::Point<dim> center = center_of(cell);
        const double size               = cell_size(cell->level());
        if (status == Octree::CELL_PERSIST || status == Octree::CELL_COARSEN)
          return work(center, size);
        // Of a cell that is refined, deal.II asks for each child, but does not
        // say for which.
        unsigned int sum = 0;
        for (unsigned int i = 0; i < (1 << dim); ++i)
          {
            dealii::Point<dim> child = center;
            for (unsigned int d = 0; d < dim; ++d)
              child[d] += ((i >> d) & 1 ? 0.25 : -0.25) * size;
            sum += work(child, size / 2);
          }
        return sum >> dim;
      });
  }



  template <int dim>
  bool
  FluidGrid<dim>::flag_cells(const WantedLevel &wanted_level)
  {
    const auto wanted = [&](const auto &cell) {
      return wanted_level(center_of(cell), cell_size(cell->level()));
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
