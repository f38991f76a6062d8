#ifndef coapt_flow_immersed_parameters_h
#define coapt_flow_immersed_parameters_h

#include <coapt/immersion/immersion_parameters.h>
#include <coapt/solid/solid_parameters.h>

#include <string>
#include <vector>

namespace coapt
{
  /** Shape and place of one body in a flow; lengths in m. */
  struct BodyParameters
  {
    /** "disc", "ring" or "strip"; the last one in 3D, too. */
    std::string shape = "disc";

    /** Disc and ring: centre, outer radius of the disc or inner one of the
     * ring, width of the ring. */
    std::vector<double> center{0.5, 0.5};
    double radius = 0.2, width = 0.05;

    /** Strip: ends of its middle line, thickness and its direction (empty:
     * across the line), and deflection of the middle. */
    std::vector<double> begin{0.5, 0}, end{0.5, 1};
    double thickness = 0.05;
    std::vector<double> thickness_direction;
    double bow = 0;
  };

  /** The elastic bodies in a flow: the subsections Body, Body 2, Solid and
   * Coupling. */
  struct ImmersedParameters
  {
    /** The bodies, at least one. */
    std::vector<BodyParameters> bodies;

    /** Distances of the nodes over the size of the smallest fluid cells, and
     * whether the elements are quadratic, between every second of them. */
    double element_size = 1;
    bool quadratic      = false;

    /** Whether the bodies are coupled with the fluid at their surfaces only
     * and not in their whole volume. */
    bool couples_surface = false;

    /** Whether the pressure of the fluid that fills the bodies is part of their
     * stress. */
    bool has_pressure_within = true;

    /** Whether bodies touch each other and themselves, at what gap over the
     * size of the smallest fluid cells, and Coulomb's coefficient. */
    bool has_contact = false;
    double clearance = 1, friction = 0.2;

    /** Rate (1/s) at which the bodies' velocities would decay by a drag in
     * proportion to their mass; it leads to a steady state. */
    double damping_rate = 0;

    /** Expression in the reference coordinates, positive where nodes of the
     * bodies are held; empty for none. */
    std::string held;

    /** Points (m) of the bodies of which displacements are recorded. */
    std::vector<std::vector<double>> displacement_points;

    /** Whether the flow out of the upper x side less the volume that the
     * strip sweeps is recorded. */
    bool measures_leak = false;

    /** Of all bodies. The density is that by which a body is heavier than the
     * fluid, since the fluid fills the bodies, too. */
    SolidParameters solid;
    ImmersionParameters coupling;

    /** Declares the subsections. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them for a flow of @p dimension. Throws InputError. */
    void
    parse_parameters(dealii::ParameterHandler &prm,
                     const unsigned int dimension);
  };
} // namespace coapt

#endif
