#include <coapt/base/time_table.h>
#include <coapt/coupled/model_parameters.h>

namespace coapt
{
  void
  EndParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Double;
    const EndParameters defaults;
    prm.enter_subsection("Ends");
    prm.declare_entry("Pressure table",
                      defaults.pressure_table,
                      dealii::Patterns::FileName(),
                      "File with the pressure at the ventricular end over "
                      "time (s), sought beside the parameter file. The "
                      "atrial end is at zero.");
    prm.declare_entry("Pressure unit",
                      defaults.pressure_unit,
                      dealii::Patterns::Selection(TimeTable::unit_names()),
                      "Unit of the pressures in the table.");
    prm.declare_entry("Ventricular impedance",
                      std::to_string(defaults.ventricular_impedance),
                      Double(0., 1e9),
                      "Impedance Z of the ventricular end: its pressure "
                      "falls by Z times the inflow velocity (Pa s/m).");
    prm.declare_entry("Atrial impedance",
                      std::to_string(defaults.atrial_impedance),
                      Double(0., 1e9),
                      "Impedance Z of the atrial end (Pa s/m).");
    prm.leave_subsection();
  }



  void
  EndParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Ends");
    pressure_table        = prm.get("Pressure table");
    pressure_unit         = prm.get("Pressure unit");
    ventricular_impedance = prm.get_double("Ventricular impedance");
    atrial_impedance      = prm.get_double("Atrial impedance");
    prm.leave_subsection();
  }



  void
  ModelParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    MeshParameters::declare_parameters(prm);
    FluidParameters::declare_parameters(prm);
    LumenParameters::declare_parameters(prm);
    EndParameters::declare_parameters(prm);
    ValveParameters::declare_parameters(prm);
    ImportParameters::declare_parameters(prm);
    ChordaeParameters::declare_parameters(prm);
    SolidParameters::declare_parameters(prm);
    ImmersionParameters::declare_parameters(prm);
    ContactParameters::declare_parameters(prm);
    FilmParameters::declare_parameters(prm);
    MotionParameters::declare_parameters(prm);
  }



  void
  ModelParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    mesh.parse_parameters(prm);
    fluid.parse_parameters(prm);
    lumen.parse_parameters(prm);
    ends.parse_parameters(prm);
    valve.parse_parameters(prm);
    import.parse_parameters(prm);
    chordae.parse_parameters(prm);
    if (!import.is_wanted)
      valve.check();
    solid.parse_parameters(prm);
    coupling.parse_parameters(prm);
    contact.parse_parameters(prm);
    film.parse_parameters(prm);
    motion.parse_parameters(prm);
  }
} // namespace coapt
