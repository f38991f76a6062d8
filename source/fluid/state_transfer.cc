#include <coapt/fluid/fluid_operator.h>
#include <coapt/fluid/state_transfer.h>

#include <cstring>

namespace coapt
{
  template <int dim>
  StateTransfer<dim>::StateTransfer(Triangulation &octree,
                                    const FluidOperator<dim> &op,
                                    const std::vector<double> &velocity_owned,
                                    const std::vector<double> &pressure_owned)
    : octree(octree)
    , op(op)
    , velocity(dim * op.n_local_nodes())
    , pressure(pressure_owned)
  {
    op.gather(velocity_owned.data(), velocity.data());
    handle = octree.register_data_attach(
      [this](const Cell &cell, const Status status) {
        const CellState state = packed_state(cell, status);
        std::vector<char> bytes(sizeof(CellState));
        std::memcpy(bytes.data(), &state, sizeof(CellState));
        return bytes;
      },
      false);
  }



  template <int dim>
  void
  StateTransfer<dim>::unpack(std::vector<double> &velocity_owned,
                             std::vector<double> &pressure_owned)
  {
    velocity.assign(dim * op.n_local_nodes(), 0.);
    pressure.assign(op.n_owned_cells(), 0.);
    octree.notify_ready_to_unpack(
      handle,
      [this](
        const Cell &cell,
        const Status status,
        const boost::iterator_range<std::vector<char>::const_iterator> &bytes) {
        CellState state;
        std::memcpy(&state, &*bytes.begin(), sizeof(CellState));
        set_packed_state(cell, status, state);
      });
    velocity_owned.assign(velocity.begin(),
                          velocity.begin() + dim * op.n_owned_nodes());
    op.apply_constraints(velocity_owned.data());
    pressure_owned = pressure;
  }



  template <int dim>
  typename StateTransfer<dim>::CellState
  StateTransfer<dim>::state_of(const Cell &cell) const
  {
    const unsigned int index = op.owned_cell_index(cell->active_cell_index());
    CellState state;
    for (unsigned int i = 0; i < n_corners; ++i)
      for (int c = 0; c < dim; ++c)
        state.velocity[dim * i + c] =
          velocity[dim * op.cell(index).nodes[i] + c];
    state.pressure = pressure[index];
    return state;
  }



  template <int dim>
  typename StateTransfer<dim>::CellState
  StateTransfer<dim>::packed_state(const Cell &cell, const Status status) const
  {
    if (status != Triangulation::CELL_COARSEN)
      return state_of(cell);
    CellState state;
    state.pressure = 0;
    for (unsigned int i = 0; i < n_corners; ++i)
      {
        const CellState child = state_of(cell->child(i));
        std::copy_n(&child.velocity[dim * i], dim, &state.velocity[dim * i]);
        state.pressure += child.pressure / n_corners;
      }
    return state;
  }



  template <int dim>
  void
  StateTransfer<dim>::set_state(const Cell &cell, const CellState &state)
  {
    const unsigned int index = op.owned_cell_index(cell->active_cell_index());
    for (unsigned int i = 0; i < n_corners; ++i)
      for (int c = 0; c < dim; ++c)
        velocity[dim * op.cell(index).nodes[i] + c] =
          state.velocity[dim * i + c];
    pressure[index] = state.pressure;
  }



  template <int dim>
  void
  StateTransfer<dim>::set_packed_state(const Cell &cell,
                                       const Status status,
                                       const CellState &state)
  {
    if (status != Triangulation::CELL_REFINE)
      {
        set_state(cell, state);
        return;
      }
    for (unsigned int i = 0; i < n_corners; ++i)
      {
        CellState child;
        child.pressure = state.pressure;
        child.velocity.fill(0);
        // corner j of child i lies halfway between corners i and j
        for (unsigned int j = 0; j < n_corners; ++j)
          for (unsigned int k = 0; k < n_corners; ++k)
            {
              double weight = 1;
              for (int d = 0; d < dim; ++d)
                {
                  const double x = 0.5 * ((i >> d & 1) + (j >> d & 1));
                  weight *= (k >> d & 1) ? x : 1 - x;
                }
              for (int c = 0; c < dim; ++c)
                child.velocity[dim * j + c] +=
                  weight * state.velocity[dim * k + c];
            }
        set_state(cell->child(i), child);
      }
  }

  template class StateTransfer<2>;
  template class StateTransfer<3>;
} // namespace coapt
