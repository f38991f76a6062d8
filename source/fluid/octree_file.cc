#include <coapt/fluid/octree_file.h>
#include <coapt/fluid/state_transfer.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace coapt
{
  namespace
  {
    template <int dim>
    using Octree = dealii::parallel::distributed::Triangulation<dim>;

    template <int dim>
    constexpr unsigned int n_corners = 1 << dim;

    /** Velocities of the corners of a cell, then its pressure. */
    template <int dim>
    using CellState = std::array<double, dim * n_corners<dim> + 1>;

    /** Attaches the @p state of cells, by their number, to those of the octree.
     */
    template <int dim, typename StateOf>
    unsigned int
    attach(Octree<dim> &octree, const StateOf &state_of)
    {
      return octree.register_data_attach(
        [state_of](const typename Octree<dim>::cell_iterator &cell,
                   const typename Octree<dim>::CellStatus) {
          const CellState<dim> state = state_of(cell);
          std::vector<char> bytes(sizeof(state));
          std::memcpy(bytes.data(), state.data(), bytes.size());
          return bytes;
        },
        false);
    }
  } // namespace



  template <int dim>
  void
  save_octree(const std::string &name,
              FluidGrid<dim> &grid,
              const FluidOperator<dim> &op,
              const std::vector<double> &velocity_owned,
              const std::vector<double> &pressure_owned)
  {
    std::vector<double> velocity(dim * op.n_local_nodes());
    op.gather(velocity_owned.data(), velocity.data());
    attach<dim>(grid.triangulation(), [&](const auto &cell) {
      const unsigned int index = op.owned_cell_index(cell->active_cell_index());
      CellState<dim> state;
      for (unsigned int i = 0; i < n_corners<dim>; ++i)
        std::copy_n(&velocity[dim * op.cell(index).nodes[i]],
                    dim,
                    &state[dim * i]);
      state.back() = pressure_owned[index];
      return state;
    });
    grid.triangulation().save(name);
  }



  template <int dim>
  void
  load_octree(const std::string &name,
              FluidGrid<dim> &grid,
              FluidOperator<dim> &op,
              std::vector<double> &velocity_owned,
              std::vector<double> &pressure_owned)
  {
    Octree<dim> &octree = grid.triangulation();
    octree.load(name);
    op.reinit(grid);

    // Only the handle counts: nothing is written here.
    const unsigned int handle =
      attach<dim>(octree, [](const auto &) { return CellState<dim>(); });
    std::vector<double> velocity(dim * op.n_local_nodes());
    pressure_owned.assign(op.n_owned_cells(), 0.);
    octree.notify_ready_to_unpack(
      handle,
      [&](
        const typename Octree<dim>::cell_iterator &cell,
        const typename Octree<dim>::CellStatus,
        const boost::iterator_range<std::vector<char>::const_iterator> &bytes) {
        CellState<dim> state;
        std::memcpy(state.data(), &*bytes.begin(), sizeof(state));
        const unsigned int index =
          op.owned_cell_index(cell->active_cell_index());
        for (unsigned int i = 0; i < n_corners<dim>; ++i)
          std::copy_n(&state[dim * i],
                      dim,
                      &velocity[dim * op.cell(index).nodes[i]]);
        pressure_owned[index] = state.back();
      });
    velocity_owned.assign(velocity.begin(),
                          velocity.begin() + dim * op.n_owned_nodes());

    // deal.II divides what it loads by the number of cells.
    StateTransfer<dim> transfer(octree, op, velocity_owned, pressure_owned);
    octree.repartition();
    op.reinit(grid);
    transfer.unpack(velocity_owned, pressure_owned);
  }



  template void
  save_octree(const std::string &,
              FluidGrid<2> &,
              const FluidOperator<2> &,
              const std::vector<double> &,
              const std::vector<double> &);
  template void
  save_octree(const std::string &,
              FluidGrid<3> &,
              const FluidOperator<3> &,
              const std::vector<double> &,
              const std::vector<double> &);
  template void
  load_octree(const std::string &,
              FluidGrid<2> &,
              FluidOperator<2> &,
              std::vector<double> &,
              std::vector<double> &);
  template void
  load_octree(const std::string &,
              FluidGrid<3> &,
              FluidOperator<3> &,
              std::vector<double> &,
              std::vector<double> &);
} // namespace coapt
