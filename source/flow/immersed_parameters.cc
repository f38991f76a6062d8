#include <coapt/base/exceptions.h>
#include <coapt/flow/immersed_parameters.h>
#include <coapt/flow/number_lists.h>

#include <deal.II/base/parameter_handler.h>

namespace coapt
{
  using dealii::ParameterHandler;
  using namespace dealii::Patterns;

  namespace
  {
    void
    declare_shape(ParameterHandler &prm, const std::string &default_shape)
    {
      const BodyParameters defaults;
      const List plane(Double(), 0, 2);
      prm.declare_entry("Shape",
                        default_shape,
                        Selection("disc|ring|strip|none"),
                        "Disc, ring, or strip, which in 3D is a plate that "
                        "reaches from one z side of the box to the other; or "
                        "no body.");
      prm.declare_entry("Centre",
                        join_numbers(defaults.center),
                        plane,
                        "Centre (m) of a disc or ring.");
      prm.declare_entry("Radius",
                        std::to_string(defaults.radius),
                        Double(1e-9),
                        "Radius of a disc, inner radius of a ring (m).");
      prm.declare_entry("Width",
                        std::to_string(defaults.width),
                        Double(1e-9),
                        "Outer less inner radius of a ring (m).");
      prm.declare_entry("Begin",
                        join_numbers(defaults.begin),
                        plane,
                        "Beginning (m, x and y) of a strip's middle line.");
      prm.declare_entry("End",
                        join_numbers(defaults.end),
                        plane,
                        "End (m, x and y) of a strip's middle line.");
      prm.declare_entry("Thickness",
                        std::to_string(defaults.thickness),
                        Double(1e-9),
                        "Thickness of a strip (m).");
      prm.declare_entry("Thickness direction",
                        "",
                        plane,
                        "Direction (x and y) in which the thickness of a strip "
                        "is measured, for ends that are not at right angles; "
                        "empty: at right angles.");
      prm.declare_entry("Bow",
                        "0",
                        Double(),
                        "Deflection of the middle of a strip in the direction "
                        "of its thickness (m), a parabola.");
    }

    BodyParameters
    parse_shape(ParameterHandler &prm, const std::string &section)
    {
      const auto plane = [&](const std::string &entry) {
        const auto result = read_numbers(section + "/" + entry, prm.get(entry));
        if (result.size() != 2)
          throw InputError(section + "/" + entry + " has " +
                           std::to_string(result.size()) +
                           " coordinate(s), expected are 2 (x and y)");
        return result;
      };
      BodyParameters body;
      body.shape     = prm.get("Shape");
      body.center    = plane("Centre");
      body.radius    = prm.get_double("Radius");
      body.width     = prm.get_double("Width");
      body.begin     = plane("Begin");
      body.end       = plane("End");
      body.thickness = prm.get_double("Thickness");
      if (!prm.get("Thickness direction").empty())
        body.thickness_direction = plane("Thickness direction");
      body.bow = prm.get_double("Bow");
      if (body.begin == body.end)
        throw InputError(section + "/Begin and End are the same point");
      if (!body.thickness_direction.empty() &&
          (body.end[0] - body.begin[0]) * body.thickness_direction[1] ==
            (body.end[1] - body.begin[1]) * body.thickness_direction[0])
        throw InputError(section + "/Thickness direction is '" +
                         prm.get("Thickness direction") +
                         "', it must not be zero nor point from Begin to End");
      return body;
    }
  } // namespace



  void
  ImmersedParameters::declare_parameters(ParameterHandler &prm)
  {
    SolidParameters::declare_parameters(prm);
    ImmersionParameters::declare_parameters(prm);
    prm.enter_subsection("Body");
    declare_shape(prm, "disc");
    prm.declare_entry("Element size",
                      "1",
                      Double(0.05, 10),
                      "Distances between neighbouring nodes of all bodies over "
                      "the edges of the smallest fluid cells (-).");
    prm.declare_entry("Element",
                      "P1",
                      Selection("P1|P2"),
                      "Elements of all bodies: triangles of three nodes, in 3D "
                      "tetrahedra of four (P1), or, for strips, of six and ten "
                      "(P2), which bend better and are as large as two of P1.");
    prm.declare_entry("Coupled part",
                      "volume",
                      Selection("volume|surface"),
                      "Where all bodies are coupled with the fluid. volume is "
                      "for what is thin or shuts a channel: it fixes all "
                      "corners of the cells that a body reaches into, so for "
                      "the flow a body is too large by about half a cell and "
                      "moves by whole cells. surface, with Coupling/Point "
                      "spacing 1, is for bodies at least two cells thick: the "
                      "flow feels where in a cell the surface is.");
    prm.declare_entry("Fluid pressure within",
                      "true",
                      Bool(),
                      "Whether the pressure of the fluid that fills the bodies "
                      "acts on them besides the stress of their material: rho "
                      "c^2 adds to their bulk modulus where their elements are "
                      "no larger than the cells and they are several cells "
                      "thick. It does in bodies of fibres in a fluid and in "
                      "nearly incompressible ones. false, with Coupled part "
                      "volume, leaves a compressible body its own stress.");
    prm.declare_entry("Contact",
                      "false",
                      Bool(),
                      "Whether bodies touch each other and themselves, face "
                      "against face.");
    prm.declare_entry("Contact clearance",
                      "1",
                      Double(0, 10),
                      "Gap at which contact begins over the size of the "
                      "smallest fluid cells (-).");
    prm.declare_entry("Friction coefficient",
                      "0.2",
                      Double(0, 10),
                      "Coulomb's coefficient of friction between bodies (-).");
    prm.declare_entry("Damping rate",
                      "0",
                      Double(0),
                      "Rate at which the velocities of all bodies decay by a "
                      "drag in proportion to their mass (1/s); it shortens the "
                      "way to a steady state and does not change it.");
    prm.declare_entry("Held",
                      "",
                      Anything(),
                      "Nodes of the bodies at which this expression in x, y, z "
                      "is positive at time 0 are held; empty for none.");
    prm.declare_entry("Displacement points",
                      "",
                      Anything(),
                      "Points (m) of the bodies, separated by semicolons, of "
                      "which the displacement is recorded.");
    prm.declare_entry("Measure leak",
                      "false",
                      Bool(),
                      "Whether to record the leak past strips that shut a "
                      "channel along x: the flow out of the upper x side less "
                      "the volume that the strips sweep.");
    prm.leave_subsection();
    prm.enter_subsection("Body 2");
    declare_shape(prm, "none");
    prm.leave_subsection();
  }



  void
  ImmersedParameters::parse_parameters(ParameterHandler &prm,
                                       const unsigned int dimension)
  {
    solid.parse_parameters(prm);
    coupling.parse_parameters(prm);
    bodies.clear();
    for (const std::string section : {"Body", "Body 2"})
      {
        prm.enter_subsection(section);
        const BodyParameters body = parse_shape(prm, section);
        if (body.shape != "none")
          bodies.push_back(body);
        if (dimension == 3 && (body.shape == "disc" || body.shape == "ring"))
          throw InputError(section + "/Shape is " + body.shape +
                           ", but in 3D (Flow/Dimension) only strip is "
                           "available");
        prm.leave_subsection();
      }
    if (bodies.empty())
      throw InputError("Body/Shape is none, but the task immersed needs a "
                       "body; without one the task is flow");
    prm.enter_subsection("Body");
    element_size = prm.get_double("Element size");
    quadratic    = prm.get("Element") == "P2";
    for (const BodyParameters &body : bodies)
      if (quadratic && body.shape != "strip")
        throw InputError("Body/Element is P2, which is for strips, but there "
                         "is a " +
                         body.shape);
    couples_surface     = prm.get("Coupled part") == "surface";
    has_pressure_within = prm.get_bool("Fluid pressure within");
    if (couples_surface && !has_pressure_within)
      throw InputError("Body/Fluid pressure within is false, for which "
                       "Body/Coupled part must be volume");
    has_contact         = prm.get_bool("Contact");
    clearance           = prm.get_double("Contact clearance");
    friction            = prm.get_double("Friction coefficient");
    damping_rate        = prm.get_double("Damping rate");
    held                = prm.get("Held");
    displacement_points = read_points("Body/Displacement points",
                                      prm.get("Displacement points"),
                                      dimension);
    measures_leak       = prm.get_bool("Measure leak");
    prm.leave_subsection();
  }
} // namespace coapt
