#include <coapt/fluid/fluid_operator.h>
#include <coapt/fluid/state_transfer.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coapt
{
  namespace
  {
    /** Up to this the interpolation is at least as near to a smooth profile as
     * a linear one. */
    constexpr double largest_factor = 2;
  } // namespace



  template <int dim>
  StateTransfer<dim>::StateTransfer(Triangulation &octree,
                                    const FluidOperator<dim> &op,
                                    const std::vector<double> &velocity_owned,
                                    const std::vector<double> &pressure_owned)
    : octree(octree)
    , op(op)
    , kinetic_energy(op.kinetic_energy(velocity_owned.data()))
    , velocity(dim * op.n_local_nodes())
    , position(velocity.size())
    , correction(velocity.size())
    , pressure(pressure_owned)
  {
    op.gather(velocity_owned.data(), velocity.data());
    gradients = nodal_gradients(op, velocity);
    std::vector<double> position_owned(dim * op.n_owned_nodes());
    for (unsigned int i = 0; i < op.n_owned_nodes(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        position_owned[dim * i + d] = op.position(i)[d];
    op.gather(position_owned.data(), position.data());
    correct_hanging_nodes();
    handle = octree.register_data_attach(
      [this](const Cell &cell, const Status status) {
        const auto states = packed_states(cell, status);
        std::vector<char> bytes(states.size() * sizeof(CellState));
        std::memcpy(bytes.data(), states.data(), bytes.size());
        return bytes;
      },
      true);
  }



  template <int dim>
  void
  StateTransfer<dim>::unpack(std::vector<double> &velocity_owned,
                             std::vector<double> &pressure_owned)
  {
    velocity.assign(dim * op.n_local_nodes(), 0.);
    correction.assign(dim * op.n_local_nodes(), 0.);
    pressure.assign(op.n_owned_cells(), 0.);
    octree.notify_ready_to_unpack(
      handle,
      [this](
        const Cell &cell,
        const Status status,
        const boost::iterator_range<std::vector<char>::const_iterator> &bytes) {
        std::vector<CellState> states(bytes.size() / sizeof(CellState));
        std::memcpy(states.data(), &*bytes.begin(), bytes.size());
        if (status == Triangulation::CELL_REFINE)
          for (unsigned int i = 0; i < n_corners; ++i)
            set_state(cell->child(i), states[i]);
        else
          set_state(cell, states[0]);
      });
    op.apply_constraints(velocity.data());
    op.apply_constraints(correction.data());
    const double factor       = energy_keeping_factor();
    const unsigned int n_kept = dim * op.n_owned_nodes();
    velocity_owned.resize(n_kept);
    for (unsigned int i = 0; i < n_kept; ++i)
      velocity_owned[i] = velocity[i] + factor * correction[i];
    pressure_owned = pressure;
  }



  template <int dim>
  double
  StateTransfer<dim>::energy_keeping_factor() const
  {
    std::vector<double> corrected(dim * op.n_owned_nodes());
    for (unsigned int i = 0; i < corrected.size(); ++i)
      corrected[i] = velocity[i] + correction[i];
    // kinetic energy: without + a linear + a^2 quadratic
    const double without   = op.kinetic_energy(velocity.data());
    const double quadratic = op.kinetic_energy(correction.data());
    const double linear =
      op.kinetic_energy(corrected.data()) - without - quadratic;
    const double wanted = kinetic_energy - without;
    if (wanted <= 0 || quadratic <= 0)
      return 0;
    const double root =
      (std::sqrt(linear * linear + 4 * quadratic * wanted) - linear) /
      (2 * quadratic);
    return std::min(root, largest_factor);
  }



  template <int dim>
  std::array<double, dim>
  StateTransfer<dim>::correction_between(
    const std::vector<unsigned int> &corners) const
  {
    std::array<double, dim> middle{}, sum{};
    for (const unsigned int m : corners)
      for (unsigned int d = 0; d < dim; ++d)
        middle[d] += position[dim * m + d] / corners.size();
    for (const unsigned int m : corners)
      for (unsigned int k = 0; k < dim; ++k)
        {
          sum[k] += correction[dim * m + k] / corners.size();
          for (unsigned int d = 0; d < dim; ++d)
            sum[k] += 0.5 * gradients[d][dim * m + k] *
              (middle[d] - position[dim * m + d]) / corners.size();
        }
    return sum;
  }



  template <int dim>
  void
  StateTransfer<dim>::correct_hanging_nodes()
  {
    const auto &hanging = op.numbering().hanging_nodes();
    for (unsigned int row = 0; row < hanging.size(); ++row)
      {
        const auto between = correction_between(op.numbering().masters(row));
        std::copy_n(between.begin(), dim, &correction[dim * hanging[row]]);
      }
  }



  template <int dim>
  typename StateTransfer<dim>::CellState
  StateTransfer<dim>::state_of(const Cell &cell) const
  {
    const unsigned int index = op.owned_cell_index(cell->active_cell_index());
    CellState state;
    for (unsigned int i = 0; i < n_corners; ++i)
      {
        const unsigned int node = op.cell(index).nodes[i];
        std::copy_n(&velocity[dim * node], dim, &state.velocity[dim * i]);
        std::copy_n(&correction[dim * node], dim, &state.correction[dim * i]);
      }
    state.pressure = pressure[index];
    return state;
  }



  template <int dim>
  typename StateTransfer<dim>::CellState
  StateTransfer<dim>::state_of_children(const Cell &cell) const
  {
    CellState state;
    state.pressure = 0;
    for (unsigned int i = 0; i < n_corners; ++i)
      {
        const CellState child = state_of(cell->child(i));
        std::copy_n(&child.velocity[dim * i], dim, &state.velocity[dim * i]);
        std::copy_n(&child.correction[dim * i],
                    dim,
                    &state.correction[dim * i]);
        state.pressure += child.pressure / n_corners;
      }
    return state;
  }



  template <int dim>
  typename StateTransfer<dim>::CellState
  StateTransfer<dim>::state_of_child(const Cell &cell,
                                     const unsigned int child) const
  {
    const unsigned int index = op.owned_cell_index(cell->active_cell_index());
    const auto &nodes        = op.cell(index).nodes;
    CellState state;
    state.velocity.fill(0);
    for (unsigned int j = 0; j < n_corners; ++j)
      {
        // corner j of child i lies in the middle of the corners of the cell
        // that agree with i and j where these agree
        std::vector<unsigned int> corners;
        for (unsigned int k = 0; k < n_corners; ++k)
          if (((k ^ child) & ~(child ^ j) & (n_corners - 1)) == 0)
            corners.push_back(nodes[k]);
        for (const unsigned int m : corners)
          for (unsigned int d = 0; d < dim; ++d)
            state.velocity[dim * j + d] +=
              velocity[dim * m + d] / corners.size();
        const auto between = correction_between(corners);
        std::copy_n(between.begin(), dim, &state.correction[dim * j]);
      }
    state.pressure = pressure[index];
    return state;
  }



  template <int dim>
  std::vector<typename StateTransfer<dim>::CellState>
  StateTransfer<dim>::packed_states(const Cell &cell, const Status status) const
  {
    if (status == Triangulation::CELL_COARSEN)
      return {state_of_children(cell)};
    if (status == Triangulation::CELL_PERSIST)
      return {state_of(cell)};
    std::vector<CellState> states;
    for (unsigned int i = 0; i < n_corners; ++i)
      states.push_back(state_of_child(cell, i));
    return states;
  }



  template <int dim>
  void
  StateTransfer<dim>::set_state(const Cell &cell, const CellState &state)
  {
    const unsigned int index = op.owned_cell_index(cell->active_cell_index());
    for (unsigned int i = 0; i < n_corners; ++i)
      {
        const unsigned int node = op.cell(index).nodes[i];
        std::copy_n(&state.velocity[dim * i], dim, &velocity[dim * node]);
        std::copy_n(&state.correction[dim * i], dim, &correction[dim * node]);
      }
    pressure[index] = state.pressure;
  }

  template class StateTransfer<2>;
  template class StateTransfer<3>;
} // namespace coapt
