#ifndef coapt_flow_flow_model_h
#define coapt_flow_flow_model_h

#include <coapt/flow/expressions.h>
#include <coapt/flow/flow_parameters.h>
#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>

#include <vector>

namespace coapt
{
  /**
   * The flow in a box at one level of refinement: octree, operator, initial
   * state and right-hand side. A state is a rank's owned velocities (dim
   * entries a node), followed by its pressures.
   */
  template <int dim>
  class FlowModel
  {
  public:
    /** Throws InputError if the parameters do not fit together. Collective. */
    FlowModel(const FlowParameters &parameters,
              const unsigned int level,
              MPI_Comm communicator);

    /** The state at time 0. */
    std::vector<double>
    initial_state() const;

    /** y' = f(t, y). Collective. */
    void
    rhs(const double time, const double *y, double *y_dot) const;

    /** Velocities of all nodes known here. Collective. */
    std::vector<double>
    local_velocity(const double *y) const;

    /** The pressures in a state. */
    const double *
    pressure(const double *y) const;

    /** Forces of the fluid on what holds it, at owned nodes (N). Collective. */
    std::vector<double>
    nodal_forces(const double time, const double *y) const;

    /** Whether a side gives the pressure, which is unique then. */
    bool
    has_pressure_boundary() const;

    /** Depth (m) in the obstacle, negative outside; empty without obstacle. */
    const std::function<double(const dealii::Point<dim> &)> &
    obstacle() const;

    const FluidGrid<dim> &
    grid() const;

    const FluidOperator<dim> &
    fluid() const;

    FluidOperator<dim> &
    fluid();

    /** Edge length (m) of cells outside the patch. */
    double
    cell_size() const;

    /** Edge length (m) of the smallest cells. */
    double
    smallest_cell_size() const;

    /** Exact solution, empty if there is none. @{ */
    const VectorField<dim> exact_velocity;
    const ScalarField<dim> exact_pressure;
    /** @} */

    /** Ranks that share the model. */
    const MPI_Comm communicator;

  private:
    FluidBoundaries<dim>
    boundaries(const NamedConstants &constants) const;

    FlowParameters parameters;
    unsigned int level;
    VectorField<dim> initial_velocity;
    ScalarField<dim> initial_pressure;
    std::function<double(const dealii::Point<dim> &)> obstacle_depth;
    FluidGrid<dim> octree;
    FluidOperator<dim> op;
    mutable std::vector<double> velocity, force; // local
  };
} // namespace coapt

#endif
