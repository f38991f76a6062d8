#include <coapt/base/exceptions.h>
#include <coapt/solid/materials/may_newman_yin.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace coapt
{
  using dealii::Patterns::Double;

  void
  MayNewmanYin::declare_parameters(dealii::ParameterHandler &prm)
  {
    const MayNewmanYin defaults;
    prm.enter_subsection(name);
    prm.declare_entry("c0",
                      std::to_string(defaults.c0),
                      Double(0, 1e12),
                      "Stiffness in front of the exponential (Pa).");
    prm.declare_entry("c1",
                      std::to_string(defaults.c1),
                      Double(0, 1e9),
                      "Factor of (I1 - 3)^2 in the exponent (-).");
    prm.declare_entry("c2",
                      std::to_string(defaults.c2),
                      Double(0, 1e9),
                      "Factor of the fourth power of the fibre's elongation "
                      "in the exponent (-).");
    prm.declare_entry("C10",
                      std::to_string(defaults.C10),
                      Double(0, 1e12),
                      "Stiffness of a neo-Hookean matrix (Pa), half its shear "
                      "modulus; zero in the published law, which then has "
                      "no shear stiffness at rest.");
    prm.declare_entry("Exponential limit",
                      std::to_string(defaults.exponential_limit),
                      Double(1e-3, 100),
                      "Value of the exponent (-) beyond which the "
                      "exponential is continued by a parabola.");
    prm.declare_entry("Bulk modulus",
                      std::to_string(defaults.bulk),
                      Double(1e-3, 1e14),
                      "Bulk modulus (Pa).");
    prm.leave_subsection();
  }

  void
  MayNewmanYin::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(name);
    c0                = prm.get_double("c0");
    c1                = prm.get_double("c1");
    c2                = prm.get_double("c2");
    C10               = prm.get_double("C10");
    exponential_limit = prm.get_double("Exponential limit");
    bulk              = prm.get_double("Bulk modulus");
    prm.leave_subsection();
    check();
  }

  void
  MayNewmanYin::check() const
  {
    if (c0 >= 0 && c1 >= 0 && c2 >= 0 && C10 >= 0 && exponential_limit > 0 &&
        bulk > 0)
      return;
    std::ostringstream message;
    message << "Material May-Newman-Yin: c0 = " << c0 << ", c1 = " << c1
            << ", c2 = " << c2 << ", C10 = " << C10
            << ", exponential limit = " << exponential_limit
            << ", bulk modulus = " << bulk
            << ": the last two must be positive, the others not negative "
               "(subsection Solid/May-Newman-Yin).";
    throw InputError(message.str());
  }
} // namespace coapt
