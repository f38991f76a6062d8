#ifndef coapt_solid_solid_parameters_h
#define coapt_solid_solid_parameters_h

#include <coapt/solid/materials/holzapfel_gasser_ogden.h>
#include <coapt/solid/materials/neo_hookean.h>
#include <coapt/solid/materials/ogden.h>
#include <coapt/solid/materials/saint_venant_kirchhoff.h>
#include <coapt/solid/materials/tense_fibres.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** The solid's material, density and damping: the subsection "Solid". */
  struct SolidParameters
  {
    /** "HGO", "Ogden", "neo-Hookean", "St Venant-Kirchhoff" or "tense
     * fibres". */
    std::string material = "HGO";

    /** Mass density in the reference (kg/m^3). */
    double density = 1060;

    /** Kelvin-Voigt viscosity (Pa s). */
    double viscosity = 0.4;

    HolzapfelGasserOgden holzapfel_gasser_ogden;
    Ogden ogden;
    NeoHookean neo_hookean;
    SaintVenantKirchhoff saint_venant_kirchhoff;
    TenseFibres tense_fibres;

    /** Declares the subsection "Solid" and those of the materials in it. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError if a material is not admissible. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /**
     * @throws InputError if the material is unknown or its parameters are not
     * admissible, the density not positive, or the viscosity negative.
     */
    void
    check() const;
  };
} // namespace coapt

#endif
