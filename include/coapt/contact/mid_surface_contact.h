#ifndef coapt_contact_mid_surface_contact_h
#define coapt_contact_mid_surface_contact_h

#include <coapt/contact/contact_law.h>
#include <coapt/contact/contact_parameters.h>
#include <coapt/contact/encounter_finder.h>
#include <coapt/contact/mid_surface.h>
#include <coapt/contact/mid_surface_spin.h>
#include <coapt/contact/tributary_patch.h>

#include <mpi.h>

#include <array>
#include <limits>
#include <vector>

namespace coapt
{
  /**
   * Contact of a leaflet with itself, as an impulse on the velocities after
   * each completed step.
   *
   * A column touches another part of the mid-surface when their distance falls
   * below thickness plus clearance. It looks at the nearest part that faces it
   * (FacingRule), and at a second one on its other side, if it lies between two
   * parts of the leaflet. It stands for its tributary area: distance, velocity
   * and forces are means over it and what it faces (TributaryPatch), so that
   * pressures do not depend on how the meshes of both sides fit, and what hangs
   * over a free edge does not hook there. Every column acts by its own area and
   * is acted upon as part of what others face: two passes of half weight each.
   * Friction acts half-way between the two mid-surfaces, with a couple on each,
   * and slip is that of the surfaces there, which turn with their columns
   * (MidSurfaceSpin): moments balance, and what turns as one body does not
   * slip.
   *
   * Contact has no stable step of its own: the stiffness follows the step.
   *
   * The columns are divided among the ranks and their impulses summed, so that
   * the replicated velocities stay the same on all ranks.
   */
  class MidSurfaceContact
  {
  public:
    /** @p nodal_mass in kg, @p density in kg/m^3. Throws InputError if the
     * leaflet's columns or masses are not usable (see MidSurface). */
    MidSurfaceContact(const Leaflet &leaflet,
                      const std::vector<double> &nodal_mass,
                      const double density,
                      const ContactParameters &parameters,
                      MPI_Comm communicator);

    MidSurfaceContact(const MidSurfaceContact &) = delete;

    /** What happened in a step; the same on all ranks. */
    struct Result
    {
      double normal_force   = 0;    // N, from one side to the other
      double min_gap        = 1e-2; // m, distance minus thickness
      double friction_power = 0;    // W, work on the leaflet / step
      double normal_power   = 0;    // W
      unsigned int pairs    = 0;    // columns and parts that touch
    };

    /**
     * Changes the velocities @p V (m/s) of the step of length @p dt (s) that
     * has just ended at positions @p X (m), both nodal triples of all nodes
     * and the same on all ranks. Pinned nodes keep their velocity. Collective.
     * Throws NumericalError if a position is not finite.
     */
    Result
    apply_impulse(const double *X, double *V, const double dt);

    /** Spin of the mid-surface at each column (rad/s) for the columns'
     * @p points (m) and the nodal velocities @p V (m/s). */
    std::vector<dealii::Tensor<1, 3>>
    spins(const std::vector<dealii::Point<3>> &points, const double *V) const;

    /** State of the columns, the same on all ranks. */
    struct ColumnState
    {
      /** Distance to the nearest part of the mid-surface that faces the column
       * minus thickness (m), no_gap if there is none near. Gaps of more than
       * some clearances are measured every "search interval" steps only. */
      std::vector<double> gap;

      /** Integral of the contact pressure over time (Pa s) since
       * clear_accumulators(); both sides add up. */
      std::vector<double> pressure_impulse;

      /** Unit vector to the nearest facing part, zero if there is none;
       * measured with the gap. */
      std::vector<dealii::Tensor<1, 3>> normals;

      /** Triangle of the mid-surface where that part is nearest, measured with
       * the gap; no_partner if there is none. */
      std::vector<unsigned int> partner;

      /** Mid-surface area (m^2), reference and current. */
      std::vector<double> reference_area, current_area;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &gap &pressure_impulse &normals &partner;
        archive &reference_area &current_area;
      }
    };

    /** Gap of a column with nothing near (m). */
    static constexpr double no_gap = 1e-2;

    /** Partner of a column with nothing near. */
    static constexpr unsigned int no_partner =
      std::numeric_limits<unsigned int>::max();

    /** What a column keeps from step to step of a contact. */
    struct Memory
    {
      ElasticSlip<3> history; // of friction
      TributaryPatch patch;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &history &patch;
      }
    };

    /** What a column keeps of its contacts with the nearest partner and the
     * opposite. */
    using Memories = std::array<Memory, 2>;

    /** What contact remembers. */
    struct Snapshot
    {
      ColumnState columns;
      double time = 0; // accumulated, s
      EncounterFinder::Phase search;
      std::vector<std::pair<unsigned int, Memories>> memories; // by column

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &columns &time &search &memories;
      }
    };

    /** That of all ranks; complete on the first one only. Collective. */
    Snapshot
    snapshot() const;

    /** Goes on from a snapshot that all ranks have. */
    void
    restore(const Snapshot &snapshot);

    /** The state after the last apply_impulse(). */
    const ColumnState &
    state() const;

    /** Forgets pressure impulses and accumulated time. */
    void
    clear_accumulators();

    /** Sum of the steps (s) since clear_accumulators(). */
    double
    accumulated_time() const;

    /** Penalty stiffness (Pa/m) for a time step @p dt (s): factor x density x
     * h / dt^2, h the smaller of thickness and mean column spacing, bounded by
     * the largest stiffness; single pairs may use less. */
    double
    stiffness(const double dt) const;

  private:
    /** A column and what it touches, as means over its tributary area. */
    struct Pair
    {
      const TributaryPatch *patch;
      double area; // that touches, m^2

      /** Of the mid-surfaces (m), and the unit vector to the partner. */
      double distance;
      dealii::Tensor<1, 3> normal;

      /** From the mid-surface of the column to the middle of the gap; against
       * this from that of the partner (m). */
      dealii::Tensor<1, 3> arm;

      /** One over the reduced mass (1/kg) against normal forces, and against
       * those along the surface, which turn both sides, too. */
      double inverse_mass, inverse_mass_along;

      /** Velocity of the partner's facing surface as seen from that of the
       * column, where they meet (m/s): along the normal and across it. */
      double opening;
      dealii::Tensor<1, 3> sliding;

      dealii::Tensor<1, 3> spin; // mean of both (rad/s)
    };

    /** The column of its own with the number @p i and what is around the
     * encounter. */
    Pair
    pair_up(const unsigned int i,
            const Encounter &encounter,
            TributaryPatch &patch);

    void
    find_masses(Pair &pair);

    void
    find_velocities(Pair &pair);

    /** Adds a normal @p impulse (N s) and one @p along the surface on the
     * partner, and against it on the column, to the sums. */
    void
    distribute(const Pair &pair,
               const double impulse,
               const dealii::Tensor<1, 3> &along);

    bool
    add_impulse(Pair &pair,
                const double stiffness,
                const double dt,
                ElasticSlip<3> &history);

    /** Brings what the i-th own column remembers of its contacts into the
     * order of the normals of its @p n @p encounters. */
    void
    sort_memories(const unsigned int i,
                  const Encounter *encounters,
                  const unsigned int n);

    void
    treat_column(const unsigned int i, const double stiffness, const double dt);

    /** Turns the couples of columns into impulses on those around them. */
    void
    spread_couples();

    Result
    apply_sums(double *V, const double dt);

    const ContactParameters parameters;
    const double thickness;
    const MPI_Comm communicator;

    const PressureLaw law;
    MidSurface surface;
    MidSurfaceSpin rotation;
    std::vector<unsigned int> own_columns;

    std::vector<dealii::Point<3>> points;
    double spacing;    // of columns, in the mean (m)
    double areal_mass; // density x h, kg/m^2

    /** Distance of mid-surfaces (m) below which a column is looked at: means
     * may touch although it does not. */
    double reach;

    FacingRule rule;
    EncounterFinder finder;
    TributaryPatches patches;

    std::vector<Memories> memories; // by own column

    std::vector<double> sums; // what is summed over the ranks

    ColumnState columns;
    double time = 0;
  };
} // namespace coapt

#endif
