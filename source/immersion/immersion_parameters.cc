#include <coapt/base/exceptions.h>
#include <coapt/immersion/immersion_parameters.h>

namespace coapt
{
  using dealii::Patterns::Double;
  using dealii::Patterns::Integer;

  void
  ImmersionParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    const ImmersionParameters defaults;
    prm.enter_subsection("Coupling");
    prm.declare_entry("Point spacing",
                      std::to_string(defaults.spacing),
                      Double(0.1, 1.4),
                      "Largest distance between coupling points in the "
                      "deformed leaflet, in units of the smallest fluid cell "
                      "(-). Above 0.9 the leaflet leaks, from 1.4 on the "
                      "computation is unstable.");
    prm.declare_entry("Expected stretch",
                      std::to_string(defaults.expected_stretch),
                      Double(1., 3.),
                      "In-plane stretch of the leaflet at peak load for which "
                      "the spacing must still hold (-).");
    prm.declare_entry("Layers",
                      std::to_string(defaults.min_layers),
                      Integer(1, 20),
                      "Least number of layers of coupling points through the "
                      "thickness (-). A single layer leaks.");
    prm.declare_entry("Relaxation steps",
                      std::to_string(defaults.relaxation_steps),
                      Double(1.5, 100.),
                      "Relaxation time of the multiplier in time steps (-).");
    prm.declare_entry("Largest relaxation time",
                      "16e-6",
                      Double(1e-9, 1.),
                      "Upper bound of the relaxation time (s). The slip left "
                      "by the relaxation grows with its square and with the "
                      "pressure; for a valve it is the bound at the largest "
                      "ventricular pressure, and before that a longer time "
                      "is taken, which leaves as much.");
    prm.declare_entry("Damping ratio",
                      std::to_string(defaults.damping_ratio),
                      Double(0., 2.),
                      "Damping ratio zeta of the relaxed constraint (-).");
    prm.leave_subsection();
  }



  void
  ImmersionParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Coupling");
    spacing             = prm.get_double("Point spacing");
    expected_stretch    = prm.get_double("Expected stretch");
    min_layers          = prm.get_integer("Layers");
    relaxation_steps    = prm.get_double("Relaxation steps");
    max_relaxation_time = prm.get_double("Largest relaxation time");
    damping_ratio       = prm.get_double("Damping ratio");
    prm.leave_subsection();

    // Equal masses are what every body brings about within it.
    if (largest_mass_ratio(1.) < 1.)
      throw InputError("Coupling: 4 Damping ratio / Relaxation steps is " +
                       std::to_string(4 * damping_ratio / relaxation_steps) +
                       ", but must be at most 2.5 to be stable");
  }



  double
  ImmersionParameters::largest_mass_ratio(const double density_ratio) const
  {
    const double real_axis = 2.5;
    return real_axis * relaxation_steps / (4 * damping_ratio) *
      (1 + density_ratio) -
      1;
  }



  void
  ImmersionParameters::warn_of_mass(const double mass_ratio,
                                    const double density_ratio,
                                    Log &log) const
  {
    const double largest = largest_mass_ratio(density_ratio);
    if (mass_ratio > largest)
      log.warn("mass ratio",
               "the solid mass coupled to a fluid node is " +
                 std::to_string(mass_ratio) +
                 " times the mass of that node (at most " +
                 std::to_string(largest) + " is stable)");
  }



  RelaxationCoefficients
  relaxation_coefficients(const double solid_density,
                          const double fluid_density,
                          const double tau,
                          const double damping_ratio)
  {
    const double density =
      2 * solid_density * fluid_density / (solid_density + fluid_density);
    return {density / (tau * tau), 2 * damping_ratio * density / tau, 1 / tau};
  }
} // namespace coapt
