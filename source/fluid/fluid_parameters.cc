#include <coapt/fluid/fluid_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace coapt
{
  using dealii::Patterns::Bool;
  using dealii::Patterns::Double;

  void
  FluidParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Fluid");
    prm.declare_entry("Density",
                      "1060",
                      Double(1, 1e5),
                      "Density of blood in kg/m^3.");
    prm.declare_entry("Viscosity",
                      "2e-3",
                      Double(0, 1e3),
                      "Dynamic viscosity in Pa s.");
    prm.declare_entry(
      "Sound speed",
      "50",
      Double(1, 1e4),
      "Sound speed in m/s of the weakly compressible fluid. The time step is "
      "inversely proportional to it. Blood has 1450; 50 changes the density "
      "by 0.6 % at 16 kPa.");
    prm.declare_entry(
      "Hourglass speed",
      "1",
      Double(0, 100),
      "Velocity modes that no gradient sees decay at the rate of this speed "
      "in m/s divided by the cell size.");
    prm.declare_entry(
      "Checkerboard filter",
      "0.25",
      Double(0, 1),
      "Pressures that alternate between the children of an octree cell decay "
      "at this number times sound speed divided by cell size.");
    prm.declare_entry(
      "Artificial viscosity",
      "0.1",
      Double(0, 1),
      "Additional viscosity in units of density times cell size times local "
      "speed.");
    prm.declare_entry("Convection",
                      "true",
                      Bool(),
                      "Whether the convective term is included.");
    prm.leave_subsection();
  }



  void
  FluidParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Fluid");
    density              = prm.get_double("Density");
    viscosity            = prm.get_double("Viscosity");
    sound_speed          = prm.get_double("Sound speed");
    hourglass_speed      = prm.get_double("Hourglass speed");
    checkerboard         = prm.get_double("Checkerboard filter");
    artificial_viscosity = prm.get_double("Artificial viscosity");
    convection           = prm.get_bool("Convection");
    prm.leave_subsection();
  }
} // namespace coapt
