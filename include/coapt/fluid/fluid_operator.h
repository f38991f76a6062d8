#ifndef coapt_fluid_fluid_operator_h
#define coapt_fluid_fluid_operator_h

#include <coapt/fluid/boundary_conditions.h>
#include <coapt/fluid/cell_kernel.h>
#include <coapt/fluid/cell_locator.h>
#include <coapt/fluid/checkerboard_filter.h>
#include <coapt/fluid/fluid_parameters.h>
#include <coapt/fluid/node_numbering.h>
#include <coapt/fluid/prescribed_velocity.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <vector>

namespace coapt
{
  template <int dim>
  class FluidGrid;

  /** Powers (W) in the fluid, summed over all ranks. The energy of the fluid
   * alone changes at the rate ends - (sum of the others). */
  struct FluidPowers
  {
    /** Dissipation by viscosity. */
    double viscous = 0;
    /** Dissipation by artificial viscosity. */
    double artificial = 0;
    /** Dissipation by the hourglass damping. */
    double hourglass = 0;
    /** Dissipation by the checkerboard filter. */
    double checkerboard = 0;
    /** Dissipation by the impedance of the ends. */
    double impedance = 0;
    /** Power of the pressures p(t) at the ends on the fluid. */
    double ends = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &viscous &artificial &hourglass &checkerboard &impedance &ends;
    }
  };

  /** The largest nodal velocity of all ranks (m/s) and its place (m). */
  template <int dim>
  struct LargestVelocity
  {
    double speed = 0;
    dealii::Point<dim> position;
  };

  /**
   * Weakly compressible Navier-Stokes on an octree, explicit: Q1 velocity
   * with lumped mass, one pressure a cell,
   *
   *   rho u' = -grad p + mu lap u - [rho u.grad u + div(rho u u)]/2,
   *   p'     = -rho c^2 div u,
   *
   * with hourglass damping, artificial viscosity and checkerboard filter
   * (see FluidParameters). One evaluation is gather(), add_forces(), forces
   * of others added to the same local array, finish().
   *
   * Nodal vectors have dim consecutive entries a node (see NodeNumbering
   * for owned and local ones), pressures one entry for each owned cell in the
   * order in which deal.II iterates over locally owned active cells.
   */
  template <int dim>
  class FluidOperator
  {
  public:
    /** A cell that this rank knows. */
    struct Cell
    {
      /** Lower corner (m). */
      dealii::Point<dim> lower;
      /** Edge length (m). */
      double size;
      /** Local numbers of the corners in deal.II's vertex order. */
      std::array<unsigned int, (1 << dim)> nodes;
      /** Rank that owns the cell. */
      int owner_rank;
    };

    /** Whether to count a cell, given its center. */
    using Mask = std::function<bool(const dealii::Point<dim> &center)>;

    /**
     * @p lumen is the signed distance (m) to the wall of the lumen, negative
     * inside; empty if the whole box is fluid. Nodes outside or on the wall
     * are held; cells with all nodes held carry nothing. Throws InputError
     * if a pressure end has no pressure or a negative impedance, or a side
     * with given velocity has none.
     */
    FluidOperator(const FluidParameters &parameters,
                  const FluidBoundaries<dim> &boundaries,
                  std::function<double(const dealii::Point<dim> &)> lumen);

    /** Sets everything up for @p grid as it is now. Collective. */
    void
    reinit(const FluidGrid<dim> &grid);

    /** Number of nodes this rank owns. */
    unsigned int
    n_owned_nodes() const;

    /** Number of owned nodes (first) and ghosts. */
    unsigned int
    n_local_nodes() const;

    /** Number of cells this rank owns, the length of its pressures. */
    unsigned int
    n_owned_cells() const;

    /** Number of cells that carry fluid, of all ranks. Collective. */
    unsigned int
    n_active_cells() const;

    /** Copies owned velocities, fetches the ghosts, and interpolates hanging
     * nodes. Collective. */
    void
    gather(const double *velocity_owned, double *velocity_local) const;

    /** Adds the fluid's own nodal forces (N) to @p force_local and overwrites
     * @p pressure_rate (Pa/s). Time in s. */
    void
    add_forces(const double time,
               const double *velocity_local,
               const double *pressure,
               double *force_local,
               double *pressure_rate) const;

    /** Sums forces over hanging nodes and ranks, and divides them by the
     * lumped mass: accelerations (m/s^2), zero for constrained components and
     * hanging nodes. Uses up @p force_local. Collective. */
    void
    finish(double *force_local, double *acceleration_owned) const;

    /** Divides forces that have been summed by the lumped mass: the last part
     * of finish(). */
    void
    divide_by_mass(const double *force_local, double *acceleration_owned) const;

    /** Sums forces (N) over hanging nodes and ranks into the owned part of
     * @p force_local. At held nodes they are the forces of the fluid on what
     * holds it. Collective; finish() includes it. */
    void
    sum_forces(double *force_local) const;

    /** Sets constrained components and hanging nodes to zero. */
    void
    apply_constraints(double *velocity_owned) const;

    /** Sets the nodes on sides with a given velocity to it. */
    void
    set_boundary_velocity(const double time, double *velocity_owned) const;

    /** Sets the accelerations of these nodes to its time derivative. Due
     * after finish() if there is such a side. */
    void
    set_boundary_acceleration(const double time,
                              double *acceleration_owned) const;

    /**
     * Largest stable step (s) of the five-stage scheme of Kinnmark and Gray
     * (1984), stable up to 3.87 on the imaginary axis: 3.87/omega with omega
     * = 2 c/h_min, the largest acoustic frequency of Q1/P0. It is lower
     * if viscosity (rate 4 nu/h^2) or an end with Z > 1.2 rho c (rate
     * 2 Z/(rho h)) demands it; convection is assumed to be slow against c.
     */
    double
    max_stable_step() const;

    /** A cell by number: owned ones first, in the order of the pressures,
     * then one layer of other ranks' cells. */
    const Cell &
    cell(const unsigned int i) const;

    /** Number of cells known here. */
    unsigned int
    n_known_cells() const;

    /** The cell known here that contains @p point (cells are half-open), or
     * -1. The cell @p hint is tried first. */
    int
    locate(const dealii::Point<dim> &point, const int hint = -1) const;

    /** Whether an owned cell carries fluid: has a node that is not held. */
    bool
    is_active_cell(const unsigned int owned_cell) const;

    /** Whether all components of a node are held; for a hanging node: of all
     * its masters. */
    bool
    is_constrained_node(const unsigned int local_node) const;

    /** Whether a node follows a given velocity; a hanging node: whether all of
     * its masters do. */
    bool
    is_driven_node(const unsigned int local_node) const;

    /** Numbers and hanging nodes. */
    const NodeNumbering<dim> &
    numbering() const;

    /** Position (m) of an owned node. */
    const dealii::Point<dim> &
    position(const unsigned int owned_node) const;

    /** Lumped mass of a node (kg), hanging nodes' masses on their masters. */
    double
    nodal_mass(const unsigned int local_node) const;

    /** Number of the owned cell with this active_cell_index in deal.II. */
    unsigned int
    owned_cell_index(const unsigned int active_cell_index) const;

    /** The parameters. */
    const FluidParameters &
    parameters() const;

    /** Kinetic energy (J) of all ranks. */
    double
    kinetic_energy(const double *velocity_owned) const;

    /** Energy p^2 V/(2 rho c^2) (J) of the compression, all ranks. */
    double
    acoustic_energy(const double *pressure) const;

    /** Flow (m^3/s) out of the box through one of its sides, all ranks. */
    double
    flux(const unsigned int boundary_id, const double *velocity_local) const;

    /** The powers in the fluid. Collective. */
    FluidPowers
    powers(const double time,
           const double *velocity_local,
           const double *pressure) const;

    /** Power (W) of what gives the sides of the box their velocity: of the
     * inertia of their nodes less the @p force (N) of all else on them, for
     * owned nodes as from sum_forces(). Collective. */
    double
    driving_power(const double time,
                  const double *velocity_owned,
                  const double *force) const;

    /** Root mean square (m/s) over active cells of all ranks of the hourglass
     * velocity, (sum_S |Gamma_S . u|^2)^{1/2} / 2^dim. */
    double
    hourglass_rms(const double *velocity_local, const Mask &mask = {}) const;

    /** Root mean square (Pa) over families of sibling cells of all ranks of
     * the amplitude of the filtered pressure patterns. */
    double
    checkerboard_rms(const double *pressure, const Mask &mask = {}) const;

    /** The largest velocity. Collective. */
    LargestVelocity<dim>
    largest_velocity(const double *velocity_owned) const;

  private:
    static constexpr unsigned int n_corners      = 1 << dim;
    static constexpr unsigned int n_face_corners = n_corners / 2;

    /** A face of an active owned cell on a side of the box. */
    struct Face
    {
      std::array<unsigned int, n_face_corners> nodes;
      double area_per_node; // m^2
    };

    void
    build_cells(const FluidGrid<dim> &grid);

    void
    build_constraints(const FluidGrid<dim> &grid);

    /** Bits of the components held at a node at @p x, by geometry alone. */
    unsigned char
    held_components(const dealii::Point<dim> &x,
                    const FluidGrid<dim> &grid) const;

    /** Whether the lumen does not contain @p x, by geometry alone. */
    bool
    is_in_wall(const dealii::Point<dim> &x, const FluidGrid<dim> &grid) const;

    /** Whether the velocity at @p x is given, by geometry alone. */
    bool
    has_given_velocity(const dealii::Point<dim> &x,
                       const FluidGrid<dim> &grid) const;

    void
    build_prescribed_velocity(const FluidGrid<dim> &grid);

    void
    build_kernel();

    void
    build_mass();

    void
    build_faces(const FluidGrid<dim> &grid);

    void
    build_families(const FluidGrid<dim> &grid);

    void
    add_end_tractions(const double time,
                      const double *velocity_local,
                      double *force_local) const;

    /** Integral of the normal velocity and of its square over a side, this
     * rank's part (m^3/s, m^4/s^2). */
    std::array<double, 2>
    normal_velocity_integrals(const unsigned int side,
                              const double *velocity_local) const;

    /** The modes of the velocities at the corners of a cell. */
    void
    cell_modes(const unsigned int cell,
               const double *velocity_local,
               double (&modes)[dim][n_corners]) const;

    FluidParameters fluid_parameters;
    FluidBoundaries<dim> boundaries;
    std::function<double(const dealii::Point<dim> &)> lumen;
    internal::CellCoefficients coefficients;

    MPI_Comm comm = MPI_COMM_SELF;
    NodeNumbering<dim> nodes;
    std::vector<Cell> cells;
    unsigned int n_owned = 0;
    CellLocator<dim> locator;
    std::vector<unsigned int> index_of_active_cell;
    std::vector<bool> active;                      // owned cells
    std::vector<unsigned int> inactive;            // owned cells
    std::vector<unsigned char> held;               // bits, local nodes
    std::vector<double> mass;                      // local nodes
    std::vector<double> inverse_mass;              // dim * owned nodes
    std::vector<dealii::Point<dim>> node_position; // owned nodes
    std::array<std::vector<Face>, 2 * dim> faces;
    PrescribedVelocity<dim> prescribed;
    std::vector<bool> driven; // local nodes, follow the given velocity
    internal::CellKernel<dim> kernel;
    CheckerboardFilter<dim> filter;
    double smallest_size = 0;
  };
} // namespace coapt

#endif
