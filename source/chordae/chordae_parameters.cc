#include <coapt/chordae/chordae_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace coapt
{
  void
  ChordaeParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Double;
    const ChordaeParameters defaults;
    prm.enter_subsection("Chordae");
    prm.declare_entry("Ramp time",
                      std::to_string(defaults.ramp_time),
                      Double(0, 10),
                      "Time (s) in which the rest lengths shrink from the "
                      "open lengths. A sudden tension can invert cells.");
    prm.declare_entry("Damping ratio",
                      std::to_string(defaults.damping_ratio),
                      Double(0, 2),
                      "Damping of each chorda relative to the critical one of "
                      "the mass that it holds (-).");
    prm.leave_subsection();
  }

  void
  ChordaeParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Chordae");
    ramp_time     = prm.get_double("Ramp time");
    damping_ratio = prm.get_double("Damping ratio");
    prm.leave_subsection();
  }
} // namespace coapt
