#ifndef coapt_metrics_energy_audit_h
#define coapt_metrics_energy_audit_h

#include <coapt/coupled/coupled_system.h>

#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  /**
   * Keeps the books of energy: work of the ends, of driven sides, of chordae,
   * of contact and of prescribed motion = change of the kinetic, acoustic,
   * elastic and multiplier energies + dissipation + what is left, the error.
   * Powers are sampled and integrated by the trapezoidal rule; the work of
   * contact is exact, that of its force in each step. All in J, over all
   * ranks.
   */
  template <int dim>
  class EnergyAudit
  {
  public:
    /** Energies stored at one time (J). */
    struct Energies
    {
      double fluid_kinetic = 0;
      double acoustic      = 0;
      double solid_kinetic = 0;
      double elastic       = 0;
      double multiplier    = 0;

      /** Their sum. */
      double
      total() const
      {
        return fluid_kinetic + acoustic + solid_kinetic + elastic + multiplier;
      }

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &fluid_kinetic &acoustic &solid_kinetic &elastic &multiplier;
      }
    };

    /** Work done since the start (J). Dissipation is positive. */
    struct Works
    {
      double ends         = 0;
      double driven_sides = 0; // sides of the box with a given velocity
      double loads        = 0;
      double contact      = 0;
      double motion       = 0; // of what is held and moved
      double adaptation   = 0;
      double relaxation   = 0; // by the change of k with the step length
      FluidPowers fluid;       // their time integrals; the ends as above
      double solid_losses = 0;
      double slip_losses  = 0;
      double film_losses  = 0; // by drainage

      /** Adds the works of ends and of losses in the fluid during @p duration
       * (s) between the powers @p before and @p after, by the trapezoidal
       * rule. */
      void
      add_fluid(const double duration,
                const FluidPowers &before,
                const FluidPowers &after)
      {
        ends += 0.5 * duration * (before.ends + after.ends);
        for (const auto part : {&FluidPowers::viscous,
                                &FluidPowers::artificial,
                                &FluidPowers::hourglass,
                                &FluidPowers::checkerboard,
                                &FluidPowers::impedance})
          fluid.*part += 0.5 * duration * (before.*part + after.*part);
      }

      /** What has been put in. */
      double
      input() const
      {
        return ends + driven_sides + loads + contact + motion + adaptation +
          relaxation;
      }

      /** What has been dissipated. */
      double
      losses() const
      {
        return fluid.viscous + fluid.artificial + fluid.hourglass +
          fluid.checkerboard + fluid.impedance + solid_losses + slip_losses +
          film_losses;
      }

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &ends &driven_sides &loads &contact &motion &adaptation;
        archive &relaxation &fluid &solid_losses &slip_losses &film_losses;
      }
    };

    /** Names, with the unit, and values of works and energies. */
    static std::vector<std::pair<std::string, double>>
    entries(const Works &works, const Energies &energies);

    EnergyAudit(const CoupledSystem<dim> &system,
                const FluidOperator<dim> &fluid,
                const SolidOperator<dim> &solid,
                const CouplingPoints<dim> &points);

    /** Samples the powers at time @p t; the first call starts the books.
     * Collective. */
    void
    sample(const double t, const double *y);

    /** Books the energy that a re-adaptation of the mesh has added (J). */
    void
    add_adaptation(const double change)
    {
      works.adaptation += change;
    }

    /** Energies stored in the state @p y. Collective. */
    Energies
    energies(const double *y) const;

    /** Work of each kind until the last sample. */
    const Works &
    work() const
    {
      return works;
    }

    /** Work - change - dissipation (J), what is left over, with the @p stored
     * energies of the state of the last sample. */
    double
    closure_error(const Energies &stored) const;

    /** Its magnitude over the largest work of ends, driven
     * sides and prescribed motion so far. */
    double
    relative_error(const Energies &stored) const;

    /** Saves or restores the books. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &started &last_time &initial &largest_input &last &works;
    }

  private:
    struct Powers
    {
      FluidPowers fluid;
      double driven_sides = 0, loads = 0, solid = 0, slip = 0, film = 0;

      // Multiplier energy and its stiffness k, which follows the step length.
      double multiplier = 0, stiffness = 0;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &fluid &driven_sides &loads &solid &slip &film;
        archive &multiplier &stiffness;
      }
    };

    Powers
    powers(const double t, const double *y) const;

    const CoupledSystem<dim> &system;
    const FluidOperator<dim> &fluid;
    const SolidOperator<dim> &solid;
    const CouplingPoints<dim> &points;

    bool started         = false;
    double last_time     = 0;
    double initial       = 0;
    double largest_input = 0;
    Powers last;
    Works works;
  };
} // namespace coapt

#endif
