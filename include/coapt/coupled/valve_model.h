#ifndef coapt_coupled_valve_model_h
#define coapt_coupled_valve_model_h

#include <coapt/base/log.h>
#include <coapt/base/timing.h>
#include <coapt/coupled/cell_work.h>
#include <coapt/coupled/coupled_system.h>
#include <coapt/coupled/flow_indicator.h>
#include <coapt/coupled/solid_band.h>
#include <coapt/coupled/sub_grid_film.h>
#include <coapt/coupled/valve_snapshot.h>
#include <coapt/coupled/valve_structure.h>

#include <memory>
#include <vector>

namespace coapt
{
  /**
   * All parts of a mitral valve in blood, built from the parameters in the
   * order of their dependence: the structure, octree around it, operators,
   * coupling points, coupled system.
   *
   * The ventricle is at the low end in z, the atrium at the high end.
   */
  class ValveModel : public ValveStructure
  {
  public:
    /** Sides of the box that are the ends of the lumen (boundary ids). */
    static constexpr unsigned int ventricular_end = 4;
    static constexpr unsigned int atrial_end      = 5;

    /** Throws InputError. Collective. */
    ValveModel(const ModelParameters &parameters,
               Timing &timing,
               MPI_Comm communicator);

    /** State at rest. */
    std::vector<double>
    state_at_rest();

    /** What the valve needs to go on from the state @p y, without the octree
     * and without serialize(). Complete on the first rank. Collective. */
    ValveSnapshot
    snapshot(const double *y) const;

    /** Writes the octree with the fluid of the state @p y on it. Collective. */
    void
    save_octree(const std::string &name, const double *y);

    /** Throws InputError if the @p snapshot is of another valve. */
    void
    check_snapshot(const ValveSnapshot &snapshot) const;

    /** The state with this @p snapshot, and with an octree from files; after
     * serialize(). Collective. */
    std::vector<double>
    restore(const ValveSnapshot &snapshot, const std::string &octree);

    /** Saves or restores what the flow has led to. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &flow_indicator;
    }

    /** Whether the leaflet has used up the refined band around it. */
    bool
    band_is_used_up(const std::vector<double> &y) const;

    /** Lets the octree follow the leaflet and, if that is wanted, the flow;
     * returns whether the layout of the state has changed. Collective. */
    bool
    adapt(std::vector<double> &y, Log &log);

    /**
     * Warns where the resolution may let the leaflet leak or the computation
     * become unstable; throws InputError where it cannot hold. Needs points
     * that are distributed: call state_at_rest() before. Collective.
     */
    void
    check_resolution(Log &log) const;

    /** How cells, coupling points and ghost nodes are divided among the ranks,
     * one line. Collective. */
    std::string
    division() const;

    /** Coupling points for each fluid node that the leaflet's volume holds at
     * the finest cell (-). Below 1.5 it leaks. */
    double
    points_per_fluid_node() const;

    /** Largest distance between coupling points for the nodal positions @p X,
     * in units of the finest fluid cell. */
    double
    point_spacing(const std::vector<double> &X) const;

    /** Number of cells that carry fluid, of all ranks. Collective. */
    unsigned int
    n_active_cells() const;

    /** Relaxation time (s) of the multiplier at which the leaflet leaks no more
     * at @p time (s) than with Coupling/Largest relaxation time at the largest
     * ventricular pressure: the leak grows with pressure and with the square
     * of this time. */
    double
    largest_relaxation_time(const double time) const;

    /** Says in words which value of the state is not finite, and where.
     * Collective. */
    std::string
    name_not_finite(const std::vector<double> &y) const;

    std::unique_ptr<FluidGrid<3>> grid;
    std::unique_ptr<FluidOperator<3>> fluid;
    std::unique_ptr<CouplingPoints<3>> points;
    std::unique_ptr<CoupledSystem<3>> system;

    /** Empty if films are not drained. */
    std::unique_ptr<SubGridFilm> film;

  private:
    void
    build_fluid();

    /** Throws InputError if there would be more than can be counted. */
    void
    check_number_of_points() const;

    /** Coupling points; in groups if some lie in larger cells. */
    NestedLattice<3>
    coupling_lattice() const;

    void
    build_coupling(Timing &timing);

    /** Positions of all coupling points for nodal positions @p X (m), or
     * velocities for nodal velocities; without those that stand for groups. */
    std::vector<dealii::Point<3>>
    dense_positions(const std::vector<double> &X) const;

    /** Places the band around the solid with the nodes @p X (m) that move at
     * @p V (m/s; empty: at rest), and tells where the points make work. */
    void
    follow(const std::vector<double> &X, const std::vector<double> &V);

    /** A fluid cell of this rank that has the @p node. */
    unsigned int
    cell_of_node(const unsigned int node) const;

    /** Says in words what the entry @p i of this rank's state belongs to. */
    std::string
    name_of_entry(const std::size_t i) const;

    std::function<double(const dealii::Point<3> &)>
    distance_to_wall() const;

    /** Whether the part of the leaflet at each coupling point faces another
     * one, at the nodal positions @p X (m); empty if this does not matter. */
    std::vector<bool>
    facing_points(const std::vector<double> &X) const;

    /** Level that a cell is to have. */
    unsigned int
    wanted_level(const dealii::Point<3> &center, const double size) const;

    /** Column that is nearest to each coupling point. */
    std::vector<unsigned int> column_of_point;

    /** What the last follow() was given. */
    std::vector<double> followed_positions, followed_velocities;

    SolidBand<3> band;
    FlowIndicator<3> flow_indicator;
    std::unique_ptr<CellWork<3>> work;

    void
    build_film();

    void
    act_on_film(const double *X, const double dt);

    void
    update_film(const double *X);

    unsigned int steps_since_film = 0;
    double time_since_film        = 0;
    double time_of_film           = 0; // of the last update
  };
} // namespace coapt

#endif
