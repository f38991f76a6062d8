#include <coapt/base/exceptions.h>
#include <coapt/solid/materials/saint_venant_kirchhoff.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace coapt
{
  void
  SaintVenantKirchhoff::declare_parameters(dealii::ParameterHandler &prm)
  {
    const SaintVenantKirchhoff defaults;
    prm.enter_subsection("St Venant-Kirchhoff");
    prm.declare_entry("Shear modulus",
                      std::to_string(defaults.mu),
                      dealii::Patterns::Double(1e-3, 1e12),
                      "Shear modulus mu (Pa).");
    prm.declare_entry("First Lame parameter",
                      std::to_string(defaults.lambda),
                      dealii::Patterns::Double(0, 1e14),
                      "Lambda (Pa): the bulk modulus is lambda + 2/3 mu.");
    prm.leave_subsection();
  }

  void
  SaintVenantKirchhoff::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("St Venant-Kirchhoff");
    mu     = prm.get_double("Shear modulus");
    lambda = prm.get_double("First Lame parameter");
    prm.leave_subsection();
    check();
  }

  void
  SaintVenantKirchhoff::check() const
  {
    if (mu > 0 && lambda >= 0)
      return;
    std::ostringstream message;
    message << "Material St Venant-Kirchhoff: mu is " << mu << " Pa and lambda "
            << lambda
            << " Pa, mu must be positive and lambda not negative (subsection "
               "Solid/St Venant-Kirchhoff).";
    throw InputError(message.str());
  }
} // namespace coapt
