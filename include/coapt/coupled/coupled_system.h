#ifndef coapt_coupled_coupled_system_h
#define coapt_coupled_coupled_system_h

#include <coapt/base/timing.h>
#include <coapt/coupled/pressure_sink.h>
#include <coapt/coupled/replicated_nodes.h>
#include <coapt/coupled/state_layout.h>
#include <coapt/coupled/system_snapshot.h>
#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>
#include <coapt/immersion/coupling_points.h>
#include <coapt/immersion/fluid_within.h>
#include <coapt/solid/solid_operator.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <vector>

namespace coapt
{
  /**
   * The physics: y' = f(t, y) for fluid, solid and the multiplier that couples
   * them, and what happens between two steps.
   *
   * Between steps contact finds the force with which it acts over the next
   * step, and the coupling points find their new cells and weights, which stay
   * frozen over the stages of that step.
   */
  template <int dim>
  class CoupledSystem
  {
  public:
    /** Force on the solid's nodes besides its own: F += f(t, X, V), N. Each
     * rank adds its share. */
    using SolidLoad = std::function<
      void(double t, const double *X, const double *V, double *F)>;

    /** Change of the solid velocity after a step of length dt, the same on
     * all ranks: contact. */
    using SolidImpulse =
      std::function<void(const double *X, double *V, double dt)>;

    /** Sets positions and velocities of held nodes that move to those of time
     * t. */
    using HeldMotion = std::function<void(double t, double *X, double *V)>;

    /**
     * @p pinned nodes are held. Densities in kg/m^3, those of the operators.
     */
    CoupledSystem(FluidOperator<dim> &fluid,
                  const SolidOperator<dim> &solid,
                  CouplingPoints<dim> &points,
                  const std::vector<bool> &pinned,
                  const ImmersionParameters &parameters,
                  const double solid_density,
                  const double fluid_density,
                  Timing &timing,
                  MPI_Comm communicator);

    /** Adds a load on the solid. */
    void
    add_load(const SolidLoad &load);

    /**
     * Sets what changes the solid velocity between two steps. The change comes
     * about over the step that follows, by a constant force. Where that force
     * holds others in balance, velocities stay zero. At once, they would go
     * from plus to minus half of the change in each step: the coupling drags on
     * that, and a power sampled after the change is three times its mean over
     * the step.
     */
    void
    set_impulse(const SolidImpulse &impulse);

    /** Work (J) of the force of the impulses so far, along the way of the nodes
     * in each step: exact. */
    double
    work_of_impulse() const
    {
      return impulse_work;
    }

    /** Sets what takes fluid out of cells. It must live as long as this. */
    void
    set_sink(PressureSink *sink)
    {
      this->sink = sink;
    }

    /** Sets what takes the fluid's pressure off the solid; due before
     * state_at_rest(). It must live as long as this. */
    void
    set_within(FluidWithin<dim> *within)
    {
      this->within = within;
    }

    /** Power (W) of the sink in the state @p y, over all ranks. Collective. */
    double
    sink_power(const double *y) const
    {
      return dealii::Utilities::MPI::sum(
        sink ? sink->power(y + state_layout.pressure()) : 0., communicator);
    }

    /**
     * Lets held nodes move: after each step they are put where the @p motion
     * has them, and within a step they go on at the velocity from its start.
     */
    void
    set_motion(const HeldMotion &motion);

    /** Work (J) that has been done on the held nodes to move them. */
    double
    work_of_motion() const
    {
      return motion_work;
    }

    /**
     * State at rest: zero velocity and pressure, the solid at its reference
     * @p points. Distributes the coupling points.
     */
    std::vector<double>
    state_at_rest(const std::vector<dealii::Point<dim>> &points);

    /**
     * Adapts the octree to @p wanted_level and moves the state to the new one,
     * coupling points included. Returns whether anything changed.
     */
    bool
    adapt(FluidGrid<dim> &grid,
          const typename FluidGrid<dim>::WantedLevel &wanted_level,
          std::vector<double> &y);

    /** What the system needs to go on from the state @p y, without the fluid;
     * right after take_coupling_impulse(). Collective. */
    SystemSnapshot
    snapshot(const double *y) const;

    /** The state with this @p snapshot, and with what the fluid's nodes and
     * cells of this rank have: @p velocity and @p pressure. The octree is
     * the one that they belong to. Collective. */
    std::vector<double>
    restore(const SystemSnapshot &snapshot,
            const std::vector<double> &velocity,
            const std::vector<double> &pressure);

    /** Gives the coupling points to the ranks whose cells they lie in and
     * changes the length of @p y accordingly. */
    void
    redistribute_points(std::vector<double> &y);

    /** Sets the length of the step that follows (s) and with it the
     * coefficients of the relaxed multiplier. ERKStep evaluates the first
     * stage of a step at the end of the one before, so that stage still has
     * the coefficients of that step, also where the integration starts anew;
     * steps change slowly. */
    void
    begin_step(const double dt);

    /** The same with prescribed @p coefficients, to which no relaxation time
     * belongs: relaxation_time() is zero. */
    void
    begin_step(const double dt, const RelaxationCoefficients &coefficients);

    /** y' = f(t, y). Collective. */
    void
    rhs(const double t, const double *y, double *y_dot);

    /** Prepares the next step: contact, then new coupling weights. */
    void
    finish_step(const double t, double *y);

    /** Whether a coupling point of any rank has left the cells known to its
     * rank, so that redistribute_points() is due. */
    bool
    points_have_left() const
    {
      return points_left;
    }

    /** Where the blocks of y lie. */
    const StateLayout<dim> &
    layout() const
    {
      return state_layout;
    }

    /** Number of the first solid node in this rank's block of y. */
    unsigned int
    first_owned_node() const
    {
      return nodes.begin();
    }

    /** Coefficients in force since begin_step(). */
    const RelaxationCoefficients &
    relaxation() const
    {
      return coefficients;
    }

    /** Relaxation time in force (s). */
    double
    relaxation_time() const
    {
      return tau;
    }

    /**
     * Time integral of the coupling force on each solid node since the last
     * call (N s), weighted over the stages as the integrator weights them;
     * all nodes, summed over the ranks. Resets it. Collective.
     */
    std::vector<double>
    take_coupling_impulse();

    /** Positions and velocities of all solid nodes in the state @p y.
     * Collective. @{ */
    std::vector<double>
    solid_positions(const double *y) const;

    std::vector<double>
    solid_velocities(const double *y) const;
    /** @} */

    /** Fluid velocity on all local nodes, hanging ones included. */
    std::vector<double>
    local_velocity(const double *y) const;

    /** Power of the loads in the state @p y: sum of F.V over nodes (W). */
    double
    load_power(const double t, const double *y) const;

    /** Power (W) of what drives the fluid nodes with a given velocity: of
     * their inertia less the forces of fluid and bodies on them. Collective. */
    double
    driving_power(const double t, const double *y) const;

  private:
    /** Gives the points and their @p multiplier to the ranks that own their
     * cells, for the solid's @p positions (m). */
    void
    distribute_points(const double *positions, std::vector<double> &multiplier);

    void
    update_layout();

    /** Separates, in the table of times, what a rank waits for others from what
     * the exchange itself takes. */
    void
    wait_for_others() const;

    /** The terms of the right-hand side, in their order. @{ */
    void
    gather_inputs(const double *y);

    void
    add_fluid_forces(const double t,
                     const double *pressure,
                     double *pressure_rate);

    void
    add_coupling(const double *multiplier, double *multiplier_rate);

    void
    add_fluid_within(const double *pressure, double *pressure_rate);

    void
    add_solid_forces();

    void
    add_loads(const double t);

    void
    add_impulse();

    void
    finish_solid(double *position_rate, double *velocity_rate);

    void
    finish_fluid(const double t, double *acceleration);
    /** @} */

    /** Finds the force of the next step. */
    void
    update_impulse(const double *y);

    /** Moves held nodes in @p y to time @p t, and adds up the work. */
    void
    move_held_nodes(const double t, double *y);

    void
    accumulate_coupling_impulse();

    FluidOperator<dim> &fluid;
    const SolidOperator<dim> &solid;
    CouplingPoints<dim> &points;
    std::vector<bool> pinned;
    ImmersionParameters parameters;
    double solid_density;
    double fluid_density;
    MPI_Comm communicator;

    /** Sections of the right-hand side and of the end of a step. */
    struct Sections
    {
      unsigned int waiting, fluid_nodes, ghost_exchange, point_exchange,
        solid_exchange, fluid, coupling, solid, loads, contact, weights;
    };

    Timing &timing;
    Sections sections;
    ReplicatedNodes nodes;
    StateLayout<dim> state_layout;
    std::vector<SolidLoad> loads;
    SolidImpulse impulse;
    std::vector<double> impulse_force; // that it acts with, N
    std::vector<double> impulse_start; // positions when that began, m
    double impulse_work      = 0;
    PressureSink *sink       = nullptr;
    FluidWithin<dim> *within = nullptr;
    HeldMotion motion;
    double motion_work = 0;
    RelaxationCoefficients coefficients;
    RelaxationCoefficients first_coefficients; // of the first stage
    double tau         = 0;
    double step_length = 0;
    unsigned int stage = 0;
    bool points_left   = false;

    // Work arrays: the solid replicated, the fluid with its ghosts.
    std::vector<double> X, V, solid_force, first_stage_force, coupling_impulse;
    std::vector<double> fluid_velocity, fluid_force;
  };
} // namespace coapt

#endif
