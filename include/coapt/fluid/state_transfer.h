#ifndef coapt_fluid_state_transfer_h
#define coapt_fluid_state_transfer_h

#include <deal.II/distributed/tria.h>

#include <boost/range/iterator_range.hpp>

#include <array>
#include <vector>

namespace coapt
{
  template <int dim>
  class FluidOperator;

  /**
   * Carries velocity and pressure of the fluid from one octree to the next,
   * across ranks: constructed before the octree changes, unpacked
   * after it and after the operator has been set up anew.
   */
  template <int dim>
  class StateTransfer
  {
  public:
    /** Attaches the state to the cells of @p octree. Collective. */
    StateTransfer(dealii::parallel::distributed::Triangulation<dim> &octree,
                  const FluidOperator<dim> &op,
                  const std::vector<double> &velocity_owned,
                  const std::vector<double> &pressure_owned);

    /** Writes the state in the new numbering. Collective. */
    void
    unpack(std::vector<double> &velocity_owned,
           std::vector<double> &pressure_owned);

  private:
    static constexpr unsigned int n_corners = 1 << dim;
    using Triangulation = dealii::parallel::distributed::Triangulation<dim>;
    using Cell          = typename Triangulation::cell_iterator;
    using Status        = typename Triangulation::CellStatus;

    /** What is known of one cell. */
    struct CellState
    {
      std::array<double, dim * n_corners> velocity; // corner by corner
      double pressure;
    };

    /** The state of an active cell of this rank. */
    CellState
    state_of(const Cell &cell) const;

    /** The state of a cell that will be active after the change. */
    CellState
    packed_state(const Cell &cell, const Status status) const;

    /** Writes the state of an active cell of this rank. */
    void
    set_state(const Cell &cell, const CellState &state);

    /** Writes the state of a cell that came with the octree. */
    void
    set_packed_state(const Cell &cell,
                     const Status status,
                     const CellState &state);

    Triangulation &octree;
    const FluidOperator<dim> &op;
    std::vector<double> velocity; // local
    std::vector<double> pressure; // owned
    unsigned int handle;
  };
} // namespace coapt

#endif
