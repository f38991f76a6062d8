#ifndef coapt_fluid_state_transfer_h
#define coapt_fluid_state_transfer_h

#include <coapt/fluid/nodal_gradients.h>

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
   *
   * Pressures are handed down and averaged. Where cells are joined,
   * velocities are kept at the nodes that stay. At the nodes that appear where
   * a cell is divided, they come from the corners of the edge, face, or cell
   * in whose middle x the node is, with velocities u_m and gradients G_m:
   *
   *   u = 1/n sum_m [u_m + a G_m (x - x_m)/2].
   *
   * This is linear interpolation for a = 0 and cubic Hermite interpolation for
   * a = 1. The first takes kinetic energy from every profile that is not
   * constant, for masses are lumped: a node half-way between two others takes
   * half of their mass and moves with the mean of their velocities. The second
   * gives that back if a smooth profile is divided as a whole, and about half
   * of it if a jet is divided bit by bit. So a is chosen in [0, 2] such that
   * the kinetic energy stays as it is; with 2 the error is that of linear
   * interpolation with the other sign.
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

    /** What is known of one cell, corner by corner. */
    struct CellState
    {
      std::array<double, dim * n_corners> velocity;
      std::array<double, dim * n_corners> correction; // for a = 1
      double pressure;
    };

    /** The correction (m/s) in the middle of the nodes @p corners. */
    std::array<double, dim>
    correction_between(const std::vector<unsigned int> &corners) const;

    /** Gives the hanging nodes the correction that they have if the larger
     * cell beside them is divided, so that all cells know the same. */
    void
    correct_hanging_nodes();

    /** The factor a for the velocities after the change. Collective. */
    double
    energy_keeping_factor() const;

    /** The state of an active cell of this rank. */
    CellState
    state_of(const Cell &cell) const;

    /** The state of a cell made from its children. */
    CellState
    state_of_children(const Cell &cell) const;

    /** The state of child @p child of an active cell of this rank. */
    CellState
    state_of_child(const Cell &cell, const unsigned int child) const;

    /** The states of the cells that come from one, in the order of children. */
    std::vector<CellState>
    packed_states(const Cell &cell, const Status status) const;

    /** Writes the state of an active cell of this rank. */
    void
    set_state(const Cell &cell, const CellState &state);

    Triangulation &octree;
    const FluidOperator<dim> &op;
    double kinetic_energy;          // J, before the change
    std::vector<double> velocity;   // local
    NodalGradients<dim> gradients;  // local
    std::vector<double> position;   // local, laid out like the velocity
    std::vector<double> correction; // local, like the velocity
    std::vector<double> pressure;   // owned
    unsigned int handle;
  };
} // namespace coapt

#endif
