#include <coapt/base/exceptions.h>
#include <coapt/solid/solid_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace coapt
{
  void
  SolidParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const SolidParameters defaults;
    prm.enter_subsection("Solid");
    prm.declare_entry("Material",
                      defaults.material,
                      Selection("HGO|Ogden|neo-Hookean|"
                                "St Venant-Kirchhoff|tense fibres"),
                      "Law of the solid: HGO (Holzapfel-Gasser-Ogden, with "
                      "fibres), Ogden (isotropic), neo-Hookean, St "
                      "Venant-Kirchhoff, or tense fibres without matrix; each "
                      "has a subsection. In 2D, HGO and Ogden are not "
                      "available.");
    prm.declare_entry("Density",
                      std::to_string(defaults.density),
                      Double(1, 1e5),
                      "Mass density (kg/m^3).");
    prm.declare_entry("Viscosity",
                      std::to_string(defaults.viscosity),
                      Double(0, 1e6),
                      "Kelvin-Voigt viscosity (Pa s).");
    HolzapfelGasserOgden::declare_parameters(prm);
    Ogden::declare_parameters(prm);
    NeoHookean::declare_parameters(prm);
    SaintVenantKirchhoff::declare_parameters(prm);
    TenseFibres::declare_parameters(prm);
    prm.leave_subsection();
  }

  void
  SolidParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Solid");
    material  = prm.get("Material");
    density   = prm.get_double("Density");
    viscosity = prm.get_double("Viscosity");
    holzapfel_gasser_ogden.parse_parameters(prm);
    ogden.parse_parameters(prm);
    neo_hookean.parse_parameters(prm);
    saint_venant_kirchhoff.parse_parameters(prm);
    tense_fibres.parse_parameters(prm);
    prm.leave_subsection();
    check();
  }

  void
  SolidParameters::check() const
  {
    if (material == "HGO")
      holzapfel_gasser_ogden.check();
    else if (material == "Ogden")
      ogden.check();
    else if (material == "neo-Hookean")
      neo_hookean.check();
    else if (material == "St Venant-Kirchhoff")
      saint_venant_kirchhoff.check();
    else if (material == "tense fibres")
      tense_fibres.check();
    else
      throw InputError("Solid/Material is \"" + material +
                       "\", allowed are HGO, Ogden, neo-Hookean, St "
                       "Venant-Kirchhoff and tense fibres.");

    std::ostringstream message;
    if (!(density > 0))
      message << "Solid/Density is " << density
              << " kg/m^3, it must be positive.";
    else if (!(viscosity >= 0))
      message << "Solid/Viscosity is " << viscosity
              << " Pa s, it must not be negative.";
    if (!message.str().empty())
      throw InputError(message.str());
  }
} // namespace coapt
