#ifndef coapt_contact_contact_parameters_h
#define coapt_contact_contact_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace coapt
{
  /** How the pressure of contact grows when a gap closes. */
  enum class ContactLaw
  {
    linear,
    exponential,
    table
  };

  /** Parameters of the leaflet's contact with itself (subsection "Contact"). */
  struct ContactParameters
  {
    /** Contact begins at this gap between the surfaces, that is, at a distance
     * of thickness plus clearance between mid-surfaces (m). */
    double clearance = 0.5e-3;

    /** The pressure as a function of the gap. */
    ContactLaw law = ContactLaw::linear;

    /** Pressure (Pa) where surfaces touch, of the exponential law. */
    double pressure_at_touch = 10e3;

    /** A gap (m) and the pressure (Pa) there. */
    struct GapAndPressure
    {
      double gap;
      double pressure;
    };

    /** The table of the law, from the clearance without pressure on to
     * smaller gaps; it goes on straight beyond its end. */
    std::vector<GapAndPressure> table;

    /** Penalty stiffness over density x element size / (time step)^2. */
    double stiffness_factor = 0.2;

    /** Upper bound of the penalty stiffness (Pa/m), whatever the time step. */
    double max_stiffness = 4e8;

    /** Fraction of the critical damping of a pair in contact. */
    double damping = 0.3;

    /** Coulomb's coefficient of friction. */
    double friction = 0.2;

    /** Stiffness against slip before sliding, over the normal one. */
    double stick_stiffness = 0.5;

    /** Steps between two measurements of gaps beyond the clearance, and between
     * two looks at whether candidates should be renewed early. */
    unsigned int search_interval = 10;

    /** A column never touches triangles that are nearer than this, plus the
     * clearance, in the reference configuration (m). */
    double exclusion_distance = 1.8e-3;

    /** Distance beyond the onset of contact within which candidates are
     * gathered (m). Gaps are known up to clearance plus half of it. */
    double search_margin = 2e-3;

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them; throws InputError if the table is not one of falling gaps
     * and pressures that do not fall, from zero on. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** Damping with which no impact creates energy if the force of contact is
     * found at the start of a step and acts over all of it; for stiffness
     * factors up to largest_stiffness_factor. */
    double
    least_damping() const;

    static constexpr double largest_stiffness_factor = 0.5;

    /** Throws InputError if an impact could create energy in this way. */
    void
    check_damping() const;

  private:
    void
    parse_table(const std::string &text);
  };
} // namespace coapt

#endif
