#include <deal.II/base/utilities.h>

#include <coapt/base/exceptions.h>
#include <coapt/contact/contact_parameters.h>

#include <cmath>
#include <sstream>

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
    prm.declare_entry("Law",
                      "linear",
                      dealii::Patterns::Selection("linear|exponential|table"),
                      "How the pressure grows when a gap closes: linear with "
                      "the penalty stiffness; exponential, softly from the "
                      "clearance on; or by the Table. No law is steeper than "
                      "the penalty stiffness.");
    prm.declare_entry("Pressure at touch",
                      "10",
                      Double(1e-6, 1e6),
                      "Pressure of the exponential law where the surfaces "
                      "touch (kPa).");
    prm.declare_entry("Table",
                      "0.5: 0, 0.2: 2, 0: 20",
                      dealii::Patterns::List(dealii::Patterns::Anything(), 2),
                      "Gaps (mm) and pressures (kPa) of the law table, from "
                      "the clearance, which it replaces, on to smaller gaps.");
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
    prm.declare_entry(
      "Damping",
      "0.3",
      Double(0., 1.),
      "Normal damping as a fraction of the critical one (-). In blood, where "
      "the force of contact acts over the step after, at least 0.3 sqrt(f) "
      "(1 + f) with f = Stiffness factor, which is at most 0.5 there.");
    prm.declare_entry("Friction coefficient",
                      "0.2",
                      Double(0., 10.),
                      "Coulomb's coefficient of friction (-).");
    prm.declare_entry("Stick stiffness",
                      "0.5",
                      Double(1e-3, 1.),
                      "Stiffness against slip before the surfaces slide, as a "
                      "fraction of the normal one (-).");
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
    clearance              = millimetre * prm.get_double("Clearance");
    stiffness_factor       = prm.get_double("Stiffness factor");
    max_stiffness          = prm.get_double("Largest stiffness");
    damping                = prm.get_double("Damping");
    friction               = prm.get_double("Friction coefficient");
    search_interval        = prm.get_integer("Search interval");
    exclusion_distance     = millimetre * prm.get_double("Exclusion distance");
    search_margin          = millimetre * prm.get_double("Search margin");
    stick_stiffness        = prm.get_double("Stick stiffness");
    pressure_at_touch      = 1e3 * prm.get_double("Pressure at touch");
    const std::string name = prm.get("Law");
    law                    = name == "linear"    ? ContactLaw::linear
                         : name == "exponential" ? ContactLaw::exponential
                                                 : ContactLaw::table;
    const std::string text = prm.get("Table");
    prm.leave_subsection();

    if (law == ContactLaw::exponential && !(clearance > 0))
      throw InputError("Contact: Law exponential needs a Clearance above zero");
    if (law == ContactLaw::table)
      parse_table(text);
  }



  // Bound, within 20 %, of what 60 phases of an impact ask for: a mass that
  // meets a spring of the stiffness f m/dt^2 with the damping 2 zeta sqrt(k m).
  // A vibration that stays in contact asks for less: its position and velocity
  // are multiplied by a matrix of the determinant 1 - 2 zeta sqrt(f) + f/2.
  double
  ContactParameters::least_damping() const
  {
    return 0.3 * std::sqrt(stiffness_factor) * (1 + stiffness_factor);
  }



  void
  ContactParameters::check_damping() const
  {
    std::ostringstream message;
    if (stiffness_factor > largest_stiffness_factor)
      message << "Contact/Stiffness factor is " << stiffness_factor
              << ", but must be at most " << largest_stiffness_factor
              << " in blood";
    else if (damping < least_damping())
      message << "Contact/Damping is " << damping << ", but must be from "
              << std::ceil(1e3 * least_damping()) / 1e3
              << " to 1 in blood with Contact/Stiffness factor = "
              << stiffness_factor;
    else
      return;
    throw InputError(message.str() + ", or impacts create energy");
  }



  void
  ContactParameters::parse_table(const std::string &text)
  {
    const auto refuse = [&](const std::string &reason) {
      throw InputError("Contact: Table is '" + text + "', but " + reason);
    };
    table.clear();
    for (const std::string &entry :
         dealii::Utilities::split_string_list(text, ','))
      {
        const auto numbers = dealii::Utilities::split_string_list(entry, ':');
        if (numbers.size() != 2)
          refuse("must be pairs 'gap: pressure'");
        try
          {
            table.push_back(
              {1e-3 * dealii::Utilities::string_to_double(numbers[0]),
               1e3 * dealii::Utilities::string_to_double(numbers[1])});
          }
        catch (const dealii::ExceptionBase &)
          {
            refuse("'" + entry + "' is not a pair of numbers");
          }
        if (!std::isfinite(table.back().gap) ||
            !std::isfinite(table.back().pressure))
          refuse("'" + entry + "' is not finite");
        if (table[0].gap > 10e-3)
          refuse("gaps must be at most 10 mm");
        if (table.size() == 1 && table[0].pressure != 0)
          refuse("must begin with a pressure of zero");
        if (table.size() > 1 &&
            (!(table.back().gap < table[table.size() - 2].gap) ||
             table.back().pressure < table[table.size() - 2].pressure))
          refuse("gaps must fall and pressures must not");
      }
    clearance = table[0].gap;
  }
} // namespace coapt
