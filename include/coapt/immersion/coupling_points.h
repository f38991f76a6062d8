#ifndef coapt_immersion_coupling_points_h
#define coapt_immersion_coupling_points_h

#include <coapt/base/node_register.h>
#include <coapt/fluid/fluid_operator.h>
#include <coapt/geometry/coupling_lattice.h>
#include <coapt/geometry/simplex_mesh.h>
#include <coapt/immersion/immersion_parameters.h>

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <algorithm>
#include <vector>

namespace coapt
{
  /**
   * The points that carry the coupling between fluid and solid: the
   * distributed-Lagrange-multiplier form of the immersed finite-element
   * method (Glowinski et al. 1999; Boffi and Gastaldi 2003; Heltai and
   * Costanzo 2012), with the multiplier relaxed in time so that it can be
   * stepped explicitly.
   *
   * A point belongs to the rank that owns the fluid cell it lies in, so that
   * interpolation needs no communication beyond the fluid's own ghost
   * exchange. It may wander through the ghost layer before its rank changes.
   * Interpolation weights are computed once a step by update() and frozen over
   * the stages.
   *
   * Points may be in groups that one point each stands for while all of a
   * group, and all cells beside them, are in larger cells, so that points are
   * not denser than the cells ask for. distribute() lets a group take over,
   * with the force that there is, when its cells become small. From then on it
   * keeps the coupling: to replace its multipliers by their mean would take
   * energy.
   */
  template <int dim>
  class CouplingPoints
  {
  public:
    /** @p points of all ranks, the same list on each of them; either all of a
     * surface, with normals, or all of a volume. Those of a surface lie below
     * it such that the flow comes to rest at the surface (wall_offset()). */
    CouplingPoints(const SimplexMesh<dim> &mesh,
                   const std::vector<SamplePoint<dim>> &points,
                   MPI_Comm communicator);

    /** The same for points some of which stand for groups of the others, in
     * cells that are larger than @p dense_cell (m). */
    CouplingPoints(const SimplexMesh<dim> &mesh,
                   const NestedLattice<dim> &lattice,
                   const double dense_cell,
                   MPI_Comm communicator);

    /**
     * Gives every point to the rank that owns its fluid cell and moves the
     * multipliers with it. @p multiplier, dim values for each point of this
     * rank (N/m^3), is replaced; it may be empty at first, which means zero.
     * Collective.
     */
    void
    distribute(const FluidOperator<dim> &fluid,
               const double *X,
               std::vector<double> &multiplier);

    /**
     * Recomputes cells and weights for the nodal positions @p X (m) and sets
     * the multiplier of points without a free fluid node to zero. Weights of
     * fluid nodes held at rest are zeroed and the others rescaled to sum
     * one; without this, the multiplier integrates against nodes that cannot
     * follow, and a leaflet that slides along a wall is glued to it. Nodes
     * that follow a given velocity take part, so that a body feels a moving
     * wall; what they get of its force goes to the wall.
     *
     * Returns whether all points of this rank lie in cells known to it, and
     * none stands for a group in a small one; if not so on some rank,
     * distribute() is due. Now and then puts the points, multipliers included,
     * in the order of their cells, since neighbours share what they need of the
     * fluid.
     */
    bool
    update(const FluidOperator<dim> &fluid,
           const double *X,
           double *multiplier);

    /**
     * Releases points from the fluid in one direction each: with the vectors
     * m of @p directions, one for each point of all ranks by its number, and
     * P = I - m m^T, the force becomes P f and the multiplier follows
     * lambda' = k P (v - J u) - m (m . lambda)/tau. Zero couples a point
     * fully, a unit vector frees it from the fluid in that direction, and a
     * shorter one does so in part. The coupling stays adjoint and dissipative.
     */
    void
    set_release(const std::vector<dealii::Tensor<1, dim>> &directions);

    /**
     * Adds the coupling force to the fluid and its reaction to the solid:
     * f = lambda + beta (v - J u) per volume at each point, spread by the
     * adjoint of the interpolation on both sides, so that momentum and power
     * are conserved to round-off. Writes lambda' = k (v - J u).
     *
     * @p fluid_velocity and @p fluid_force are node triples on the local nodes
     * of the fluid, @p V (m/s) and @p solid_force (N) on all solid nodes.
     */
    void
    add_forces(const RelaxationCoefficients &coefficients,
               const double *fluid_velocity,
               const double *V,
               const double *multiplier,
               double *fluid_force,
               double *solid_force,
               double *multiplier_rate);

    /** Energy stored in the multiplier, sum w lambda^2 / (2 k), and power
     * dissipated by the drag, sum w beta |v - J u|^2, and by release. J and W,
     * all ranks. */
    struct EnergyAndPower
    {
      double energy      = 0;
      double dissipation = 0;
      double slip_rms    = 0; // root of the mean of |v - J u|^2, m/s
    };
    EnergyAndPower
    energy_and_power(const RelaxationCoefficients &coefficients,
                     const double *fluid_velocity,
                     const double *V,
                     const double *multiplier) const;

    /** Volume of solid in each fluid cell that this rank owns (m^3). */
    std::vector<double>
    solid_volume(const FluidOperator<dim> &fluid) const;

    /**
     * Largest ratio of coupled solid mass to the mass of a fluid node, over
     * all ranks (-). ImmersionParameters::largest_mass_ratio() bounds it.
     */
    double
    largest_mass_ratio(const FluidOperator<dim> &fluid,
                       const double solid_density) const;

    /** Number of points of this rank. */
    unsigned int
    n_owned() const
    {
      return ids.size();
    }

    /** Number, among the points of all ranks, of the point @p q of this one. */
    unsigned int
    id(const unsigned int q) const
    {
      return ids[q];
    }

    /** Fluid cell that the point @p q of this rank is coupled with; -1 if all
     * of its nodes are held. */
    int
    coupled_cell(const unsigned int q) const
    {
      return stencils[q].scale > 0 ? stencils[q].cell : -1;
    }

    /** Number of points of all ranks; of those in groups, but not of what
     * stands for these. */
    unsigned int
    n_points() const
    {
      return stand_in.empty() ? points.size() : stand_in.size();
    }

    /** Whether the point with the number @p id carries coupling now. */
    bool
    is_active(const unsigned int id) const
    {
      return active[id];
    }

    /** Whether each point carries coupling now, by its number. */
    const std::vector<bool> &
    active_points() const
    {
      return active;
    }

    /** Multipliers (N/m^3) of all points by number, zero for those that carry
     * no coupling, from the @p multiplier of those of this rank (empty: zero).
     * Collective. */
    std::vector<double>
    all_multipliers(const std::vector<double> &multiplier) const;

    /** Sets which points carry coupling, as they did in an earlier run;
     * distribute_all() is due then. */
    void
    set_active(const std::vector<bool> &active)
    {
      this->active = active;
    }

    /** Gives every point to the rank that owns its fluid cell, with the
     * multipliers @p all of all points by number. Sets @p multiplier.
     * Collective. */
    void
    distribute_all(const FluidOperator<dim> &fluid,
                   const double *X,
                   const std::vector<double> &all,
                   std::vector<double> &multiplier);

    /** Number of points of all ranks that carry coupling now. */
    unsigned int
    n_active() const
    {
      return std::count(active.begin(), active.end(), true);
    }

    /** All points, by number; what stands for groups comes last. */
    const std::vector<SamplePoint<dim>> &
    samples() const
    {
      return points;
    }

    /** Positions of all points for nodal positions @p X (m), or velocities
     * for nodal velocities. */
    std::vector<dealii::Point<dim>>
    positions(const double *X) const;

  private:
    static constexpr unsigned int n_fluid = 1u << dim;
    static constexpr unsigned int n_solid = dim + 1;

    /** The bits of all nodes of a fluid cell. */
    static constexpr unsigned char all_nodes = (1u << n_fluid) - 1;

    /** What is needed of a point, together in memory. */
    struct Stencil
    {
      std::array<double, dim> local; // coordinates in the fluid cell, 0 to 1
      double scale;                  // of the fluid weights; 0: held
      std::array<double, n_solid> solid_weights;
      std::array<unsigned int, n_solid> solid_nodes;
      double volume;
      int cell;
    };

    /** Consecutive points in the same fluid cell. */
    struct Run
    {
      std::array<unsigned int, n_fluid> nodes;
      unsigned char constrained; // a bit for each node
      bool released;             // some of the points in some direction
      unsigned int begin, end;
    };

    using Node     = NodeRegister<dim>;
    using Register = typename Node::Register;

    /** An element of a std::vector, which takes no plain vector types. */
    struct Lanes
    {
      Register values;
    };

    /** Numbers for the nodes of a fluid cell. */
    using FluidWeights = typename VectorOfDoubles<n_fluid>::type;

    static dealii::Point<dim>
    to_point(const Register &x);

    static double
    dot(const Register &a, const Register &b);

    /** Copies one entry of dim numbers for each node. */
    static void
    to_lanes(const double *x, std::vector<Lanes> &result);

    /** Interpolation of a nodal field of the solid. */
    static Register
    solid_value(const Stencil &s, const std::vector<Lanes> &field);

    /** One for each node of a fluid cell that is free, zero for others. */
    static FluidWeights
    free_nodes(const unsigned char constrained);

    /** Weights of the nodes of the fluid cell, those of the constrained ones
     * zero and the others rescaled. */
    static FluidWeights
    fluid_weights(const Stencil &s, const FluidWeights &free);

    Stencil
    unplaced_stencil(const unsigned int id) const;

    /** Whether the point with the number @p id stands for a group, but has come
     * into a cell of a @p size (m) that asks for the group itself. */
    bool
    is_too_sparse(const unsigned int id, const double size) const
    {
      return !stand_in.empty() && id >= stand_in.size() &&
        size < 1.5 * dense_cell;
    }

    /** Whether the point with this @p stencil is in a cell larger than
     * dense_cell, and beside such cells only. */
    bool
    is_amid_large_cells(const FluidOperator<dim> &fluid,
                        const Stencil &stencil) const;

    /** Lets groups take over that are not amid large cells, for the nodes
     * @p positions of the solid, and hands multipliers on: @p multiplier holds
     * those of all points by number. Collective. */
    void
    make_dense(const FluidOperator<dim> &fluid,
               const std::vector<Lanes> &positions,
               std::vector<double> &multiplier);

    /** Which nodes of a fluid cell are held at rest, a bit for each. Nodes that
     * follow a given velocity are not among them. */
    static unsigned char
    constrained_nodes(const FluidOperator<dim> &fluid, const int cell);

    /** Sets the scale of a point whose local coordinates are known. */
    static void
    rescale(Stencil &stencil, const unsigned char constrained);

    /** Moves the points with the positions in solid_input; returns whether
     * all are in known cells. */
    bool
    move(const FluidOperator<dim> &fluid);

    /** Position of the point of a surface with the number @p id, which is at
     * @p x on the solid, in a fluid with cells like @p cell: below the surface
     * by wall_offset(). Needs the solid's nodes @p nodes. */
    Register
    coupled_position(const unsigned int id,
                     const Register &x,
                     const typename FluidOperator<dim>::Cell &cell,
                     const std::vector<Lanes> &nodes) const;

    /** Finds cell and weights of the point with the number @p id for the nodes
     * @p nodes of the solid; returns whether its cell is known, and otherwise
     * leaves what was there. */
    bool
    place(Stencil &stencil,
          const unsigned int id,
          const FluidOperator<dim> &fluid,
          const std::vector<Lanes> &nodes) const;

    /** Puts the points in the order of their cells. */
    void
    sort_by_cell(double *multiplier);

    void
    find_runs(const FluidOperator<dim> &fluid);

    void
    mark_released_runs();

    const SimplexMesh<dim> &mesh;
    std::vector<SamplePoint<dim>> points;

    /** For each point in a group the number of the one that can stand for it;
     * empty if there are no groups. Cells larger than dense_cell (m) ask for
     * that. */
    std::vector<unsigned int> stand_in;
    double dense_cell;

    /** Whether a point carries coupling now. */
    std::vector<bool> active;

    /** Whether the points are those of surfaces: all or none are. */
    bool on_surface;
    MPI_Comm communicator;

    /** Owned points, by cell except for what has moved since sorting. */
    std::vector<unsigned int> ids;
    std::vector<Stencil> stencils;
    std::vector<Run> runs;
    unsigned int updates_since_sorting = 0;

    /** Directions of release by the number of the point; empty if none. */
    std::vector<Lanes> releases;

    /** Nodal fields of the solid, for registers. */
    std::vector<Lanes> solid_input, solid_output;
  };
} // namespace coapt

#endif
