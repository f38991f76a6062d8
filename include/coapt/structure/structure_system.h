#ifndef coapt_structure_structure_system_h
#define coapt_structure_structure_system_h

#include <coapt/base/timing.h>
#include <coapt/coupled/replicated_nodes.h>
#include <coapt/coupled/valve_structure.h>
#include <coapt/structure/pressure_load.h>
#include <coapt/structure/structure_parameters.h>
#include <coapt/structure/surface_load.h>

#include <memory>
#include <vector>

namespace coapt
{
  /**
   * A valve without fluid under a given load: M X'' = -F_int - F_visc - alpha M
   * X' + F_chordae + F_load, and contact after each step. Nodal arrays hold
   * three entries a node; every rank has all of them.
   */
  class StructureSystem
  {
  public:
    /** Throws InputError if a file of loads is not usable. */
    StructureSystem(ValveStructure &valve,
                    const StructureParameters &parameters,
                    Timing &timing);

    /** Accelerations @p A (m/s^2) at time @p t without the mass damping.
     * Collective. */
    void
    acceleration(const double t, const double *X, const double *V, double *A);

    /** Puts the held nodes that move where they are at time @p t, the end of a
     * step of length @p dt (s), with their mean velocities in it. */
    void
    move_held_nodes(const double t, double *X, double *V, const double dt);

    /**
     * Contact at the end of a step of length @p dt (s). What it does to the
     * velocities is kept for the accelerations of the next step, so that it
     * acts together with the forces that answer it: where contact holds a
     * pressure, velocities stay zero. Collective.
     */
    void
    finish_step(const double *X, const double *V, const double dt);

    /** Work of contact so far (J): the mean of its forces at the ends of each
     * step, times the way in it. */
    double
    contact_work() const
    {
      return work_of_contact;
    }

    /** Work so far (J) on the held nodes to move them. */
    double
    work_of_motion() const
    {
      return motion_work;
    }

    /** Powers (W). */
    struct Powers
    {
      double load    = 0; // of pressure or tractions
      double chordae = 0;
      double damping = 0; // dissipated by viscosity and mass damping
    };

    /** Powers at one time. Collective. */
    Powers
    powers(const double t, const double *X, const double *V) const;

    /** Force of the load on all nodes (N, triples). Collective. */
    std::vector<double>
    load(const double t, const double *X) const;

    /** The rate alpha (1/s) of the mass damping. */
    const double mass_damping;

  private:
    void
    add_load(const double t, const double *X, double *F) const;

    ValveStructure &valve;
    Timing &timing;
    PressureLoad pressure;
    std::unique_ptr<RecordedLoad> recorded; // in the place of the pressure
    ReplicatedNodes nodes;
    unsigned int rank, n_ranks;

    /** Numbers of the timed sections. */
    struct Sections
    {
      unsigned int solid, loads, exchange, contact;
    } sections;

    /** Acceleration by contact in the coming step, of all nodes. */
    std::vector<double> contact_acceleration;
    std::vector<double> after_impulse; // scratch
    double work_of_contact = 0;

    /** Of each component of the nodes that are moved: force (N) at the last
     * evaluation, velocity before, and position. */
    std::vector<double> moved_force, moved_velocity, moved_position;
    double motion_work = 0;
    double last_step   = 0;
  };
} // namespace coapt

#endif
