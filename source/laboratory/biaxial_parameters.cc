#include <coapt/base/units.h>
#include <coapt/laboratory/biaxial_test.h>

#include <deal.II/base/parameter_handler.h>

namespace coapt
{
  using namespace dealii;

  void
  BiaxialParameters::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Biaxial");
    prm.declare_entry("Protocol",
                      BiaxialParameters().protocol_file,
                      Patterns::FileName(),
                      "Table of the states to pass through, with the columns "
                      "protocol, stretch1, stretch2 or protocol, "
                      "tension1_N_per_m, tension2_N_per_m. Each protocol "
                      "begins at rest. The file is looked for beside the "
                      "parameter file, then among those that come with the "
                      "program, and as it stands.");
    prm.declare_entry("Side",
                      "10",
                      Patterns::Double(1e-3, 1e4),
                      "Length of the sides at rest (mm).");
    prm.declare_entry("Thickness",
                      "1",
                      Patterns::Double(1e-4, 1e3),
                      "Thickness at rest (mm).");
    prm.declare_entry("Elements along a side",
                      "6",
                      Patterns::Integer(1, 100),
                      "Boxes of six tetrahedra along each side (-).");
    prm.declare_entry("Layers",
                      "1",
                      Patterns::Integer(1, 10),
                      "Boxes across the thickness (-).");
    prm.declare_entry("Fibre angle",
                      "0",
                      Patterns::Double(-180, 180),
                      "Angle of the fibres to side 1 (degrees). The state is "
                      "homogeneous at 0 and 90 degrees only.");
    prm.declare_entry("Methods",
                      "quasi-static, dynamic",
                      Patterns::MultipleSelection("quasi-static|dynamic"),
                      "Quasi-static: equilibrium by Newton's method; dynamic: "
                      "explicit, with damping that brings it to rest.");
    prm.declare_entry("Ramp time",
                      "10",
                      Patterns::Double(1e-3, 1e4),
                      "Time in which the explicit method goes from one state "
                      "to the next (ms).");
    prm.leave_subsection();
    SolidParameters::declare_parameters(prm);
  }



  void
  BiaxialParameters::parse_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Biaxial");
    protocol_file             = prm.get("Protocol");
    side                      = prm.get_double("Side") * units::millimetre;
    thickness                 = prm.get_double("Thickness") * units::millimetre;
    n_elements                = prm.get_integer("Elements along a side");
    n_layers                  = prm.get_integer("Layers");
    fibre_angle               = prm.get_double("Fibre angle") * units::degree;
    const std::string methods = prm.get("Methods");
    quasi_static = methods.find("quasi-static") != std::string::npos;
    dynamic      = methods.find("dynamic") != std::string::npos;
    ramp_time    = prm.get_double("Ramp time") * 1e-3;
    prm.leave_subsection();
    solid.parse_parameters(prm);
  }
} // namespace coapt
