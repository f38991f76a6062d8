#include <coapt/contact/contact_parameters.h>

namespace coapt
{
  using dealii::Patterns::Double;
  using dealii::Patterns::Integer;

  void
  ContactParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.declare_entry("Clearance",
                      "0.5",
                      Double(0., 10.),
                      "Gap between the surfaces at which contact begins (mm).");
    prm.declare_entry("Stiffness factor",
                      "0.2",
                      Double(1e-4, 1.),
                      "Penalty stiffness in units of density x element size / "
                      "(time step)^2 (-). From 0.03 to 0.3 contact is smooth, "
                      "at 1 it chatters.");
    prm.declare_entry("Largest stiffness",
                      "4e8",
                      Double(1., 1e15),
                      "Upper bound of the penalty stiffness (Pa/m).");
    prm.declare_entry("Damping",
                      "0.3",
                      Double(0., 1.),
                      "Normal damping as a fraction of the critical one (-).");
    prm.declare_entry("Friction coefficient",
                      "0.2",
                      Double(0., 10.),
                      "Coulomb's coefficient of friction (-).");
    prm.declare_entry(
      "Search interval",
      "10",
      Integer(1, 10000),
      "Number of steps after which gaps beyond the clearance are "
      "measured again, and after which the pairs that may "
      "touch are looked for again if the leaflet has moved "
      "(-). After a large movement they are looked for at "
      "once.");
    prm.declare_entry("Exclusion distance",
                      "1.8",
                      Double(0., 100.),
                      "Parts of the leaflet that are nearer to each other than "
                      "this plus the clearance in the reference configuration "
                      "are neighbours and do not touch (mm).");
    prm.declare_entry("Search margin",
                      "2",
                      Double(0.01, 100.),
                      "Distance beyond the onset of contact within which pairs "
                      "are gathered (mm). Gaps are known up to the clearance "
                      "plus half of this.");
    prm.leave_subsection();
  }



  void
  ContactParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    const double millimetre = 1e-3;
    prm.enter_subsection("Contact");
    clearance          = millimetre * prm.get_double("Clearance");
    stiffness_factor   = prm.get_double("Stiffness factor");
    max_stiffness      = prm.get_double("Largest stiffness");
    damping            = prm.get_double("Damping");
    friction           = prm.get_double("Friction coefficient");
    search_interval    = prm.get_integer("Search interval");
    exclusion_distance = millimetre * prm.get_double("Exclusion distance");
    search_margin      = millimetre * prm.get_double("Search margin");
    prm.leave_subsection();
  }
} // namespace coapt
