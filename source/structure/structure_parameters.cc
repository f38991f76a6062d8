#include <coapt/base/exceptions.h>
#include <coapt/structure/structure_parameters.h>

namespace coapt
{
  double
  StructureParameters::damping_rate() const
  {
    return mass_damping / (1 + added_mass);
  }



  void
  StructureParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Selection;
    const StructureParameters defaults;
    prm.enter_subsection("Structure");
    prm.declare_entry("Fluid",
                      "blood",
                      Selection("blood|none"),
                      "Whether the leaflets move in blood, or close under a "
                      "given load without any fluid, in about a minute. "
                      "Without it, what concerns the blood is ignored, and the "
                      "rest of this subsection counts.");
    prm.declare_entry("Load",
                      "pressure",
                      Selection("pressure|recorded"),
                      "Load without fluid: the ventricular pressure of Ends: "
                      "Pressure table on the ventricular face of the leaflets, "
                      "which it follows; or tractions that a run in blood has "
                      "recorded (Output: Surface load).");
    prm.declare_entry("Load file",
                      defaults.load_file,
                      dealii::Patterns::Anything(),
                      "File surface_load.csv of the run in blood, sought "
                      "beside the parameter file. The valve must be the same, "
                      "its elements need not.");
    prm.declare_entry("Added mass",
                      std::to_string(defaults.added_mass),
                      dealii::Patterns::Double(0., 1e3),
                      "Mass of the blood that moves with the leaflets over "
                      "their own (-). It slows them down before they shut, as "
                      "blood does, and steps grow with the root of one plus "
                      "this. The closed valve at rest does not depend on it.");
    prm.declare_entry("Mass damping",
                      std::to_string(defaults.mass_damping),
                      dealii::Patterns::Double(0., 1e6),
                      "Force against the velocity, per mass of the leaflets "
                      "alone (1/s), in the place of the blood that would slow "
                      "them down.");
    prm.leave_subsection();
  }



  void
  StructureParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Structure");
    in_blood         = prm.get("Fluid") == "blood";
    uniform_pressure = prm.get("Load") == "pressure";
    load_file        = prm.get("Load file");
    added_mass       = prm.get_double("Added mass");
    mass_damping     = prm.get_double("Mass damping");
    prm.leave_subsection();
    if (!in_blood && !uniform_pressure && load_file.empty())
      throw InputError("Structure/Load file is empty; Load = recorded needs "
                       "the surface_load.csv of a run in blood");
  }
} // namespace coapt
