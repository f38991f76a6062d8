#include <coapt/base/exceptions.h>
#include <coapt/base/units.h>
#include <coapt/solid/materials/holzapfel_gasser_ogden.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <sstream>

namespace coapt
{
  using dealii::Patterns::Double;

  void
  HolzapfelGasserOgden::declare_parameters(dealii::ParameterHandler &prm)
  {
    const HolzapfelGasserOgden defaults;
    prm.enter_subsection("Holzapfel-Gasser-Ogden");
    prm.declare_entry("C10",
                      std::to_string(defaults.C10),
                      Double(1e-3, 1e12),
                      "Stiffness of the matrix (Pa); half the initial shear "
                      "modulus.");
    prm.declare_entry("K1",
                      std::to_string(defaults.K1),
                      Double(0, 1e12),
                      "Stiffness of the fibres (Pa).");
    prm.declare_entry("K2",
                      std::to_string(defaults.K2),
                      Double(1e-6, 1e6),
                      "Exponent of the fibres (-).");
    prm.declare_entry("Dispersion",
                      std::to_string(defaults.kappa),
                      Double(),
                      "Dispersion kappa of the fibres (-), from 0 (all "
                      "parallel) to 1/3 (isotropic).");
    prm.declare_entry("Exponential limit",
                      std::to_string(defaults.exponential_limit),
                      Double(1e-3, 10),
                      "Value of the fibre strain E (-) beyond which the "
                      "fibre stress is continued by its tangent.");
    prm.declare_entry("Bulk factor",
                      std::to_string(defaults.bulk_factor),
                      Double(1e-3, 1e9),
                      "Bulk modulus over the initial shear modulus 2 C10 "
                      "(-). Below 100, the leaflet swells by several "
                      "percent.");
    prm.declare_entry("Fibre angles",
                      "0",
                      dealii::Patterns::List(Double(-180, 180), 1),
                      "Angle (degrees) of each fibre family to the fibre "
                      "direction, in the tangent plane of the leaflet; such "
                      "as -30, 30 for two families.");
    prm.leave_subsection();
  }

  void
  HolzapfelGasserOgden::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Holzapfel-Gasser-Ogden");
    C10               = prm.get_double("C10");
    K1                = prm.get_double("K1");
    K2                = prm.get_double("K2");
    kappa             = prm.get_double("Dispersion");
    exponential_limit = prm.get_double("Exponential limit");
    bulk_factor       = prm.get_double("Bulk factor");
    families.clear();
    for (const std::string &angle :
         dealii::Utilities::split_string_list(prm.get("Fibre angles")))
      {
        const double radians =
          dealii::Utilities::string_to_double(angle) * units::degree;
        families.push_back({{std::cos(radians), std::sin(radians)}});
      }
    prm.leave_subsection();
    check();
  }

  void
  HolzapfelGasserOgden::check() const
  {
    std::ostringstream message;
    // A dispersion of 1/3 is often written with few digits.
    if (!(kappa >= 0 && kappa <= 1. / 3. + 1e-6))
      message << "the dispersion kappa is " << kappa
              << ", allowed are values from 0 to 1/3 (parameter "
                 "Solid/Holzapfel-Gasser-Ogden/Dispersion)";
    else if (!(C10 > 0 && K1 >= 0 && K2 > 0 && exponential_limit > 0 &&
               bulk_factor > 0))
      message << "C10 = " << C10 << ", K1 = " << K1 << ", K2 = " << K2
              << ", exponential limit = " << exponential_limit
              << ", bulk factor = " << bulk_factor
              << ": all must be positive (subsection "
                 "Solid/Holzapfel-Gasser-Ogden)";
    else if (families.empty())
      message << "there is no fibre family, expected is at least one "
                 "(parameter Solid/Holzapfel-Gasser-Ogden/Fibre angles)";
    if (!message.str().empty())
      throw InputError("Material HGO: " + message.str() + ".");
  }
} // namespace coapt
