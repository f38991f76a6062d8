#ifndef coapt_flow_flow_audit_h
#define coapt_flow_flow_audit_h

#include <coapt/flow/flow_model.h>
#include <coapt/metrics/energy_audit.h>

namespace coapt
{
  /**
   * Keeps the books of energy of a fluid without bodies, in the terms of
   * EnergyAudit: work of ends and driven sides = change of the kinetic and
   * acoustic energies + dissipation + what is left, the error. All in J, over
   * all ranks.
   */
  template <int dim>
  class FlowAudit
  {
  public:
    using Works    = typename EnergyAudit<dim>::Works;
    using Energies = typename EnergyAudit<dim>::Energies;

    explicit FlowAudit(const FlowModel<dim> &model);

    /** Samples the powers at time @p t, between which the trapezoidal rule
     * integrates; the first call starts the books. Collective. */
    void
    sample(const double t, const double *y);

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

    /** Its magnitude over the largest work of ends and driven sides so far or,
     * if that is larger, the energy at the start: some flows only decay. */
    double
    relative_error(const Energies &stored) const;

    /** Saves or restores the books. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &started &last_time &initial &scale &last &works;
    }

  private:
    struct Powers
    {
      FluidPowers fluid;
      double driven_sides = 0;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &fluid &driven_sides;
      }
    };

    Powers
    powers(const double t, const double *y) const;

    const FlowModel<dim> &model;
    bool started     = false;
    double last_time = 0;
    double initial   = 0;
    double scale     = 0; // of the relative error
    Powers last;
    Works works;
  };
} // namespace coapt

#endif
