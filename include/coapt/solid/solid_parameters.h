#ifndef coapt_solid_solid_parameters_h
#define coapt_solid_solid_parameters_h

#include <coapt/solid/materials/material.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** The solid's material, density and damping: the subsection "Solid". */
  struct SolidParameters : Materials
  {
    /** Name of the material in use, as in its class. */
    std::string material = HolzapfelGasserOgden::name;

    /** Mass density in the reference (kg/m^3). */
    double density = 1060;

    /** Whether the ratios of volumes of linear cells are averaged over the
     * nodes. */
    bool averages_volume = false;

    /** Kelvin-Voigt viscosity (Pa s). */
    double viscosity = 0.4;

    /** Smallest principal stretch below which a cell counts as distorted, and
     * whether such cells are stiffened. */
    double distortion_threshold = 0.1;
    bool controls_distortion    = false;

    /** Smallest and largest stretch in the tangent plane for which
     * stability_warning() examines the material; none if they are equal. */
    double lowest_stretch = 1, highest_stretch = 1;

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

    /** The material in use. @throws InputError as check(). */
    Material
    selected_material() const;
  };
} // namespace coapt

#endif
