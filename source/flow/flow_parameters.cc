#include <coapt/base/exceptions.h>
#include <coapt/flow/flow_parameters.h>
#include <coapt/flow/number_lists.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <map>

namespace coapt
{
  using dealii::ParameterHandler;
  using dealii::Utilities::split_string_list;
  using namespace dealii::Patterns;

  namespace
  {
    const std::array<std::string, 6> side_names = {
      {"x lower", "x upper", "y lower", "y upper", "z lower", "z upper"}};

    /** The range of the numbers that count them. */
    const double max_number_of_cells = std::ldexp(1., 31);

    const std::map<std::string, FluidBoundary> boundary_kinds = {
      {"no-slip", FluidBoundary::no_slip},
      {"slip", FluidBoundary::slip},
      {"velocity", FluidBoundary::velocity},
      {"pressure", FluidBoundary::pressure_end}};

    /** A line "0, 0 : 1, 0 : 11". */
    FlowParameters::Line
    line(const std::string &text, const unsigned int dimension)
    {
      const std::string name = "Flow/Profiles";
      const auto parts       = split_string_list(text, ':');
      if (parts.size() != 3)
        throw InputError(name + " contains '" + text +
                         "', expected is begin : end : number of points");
      const double n = checked_size(name, read_numbers(name, parts[2]), 1)[0];
      if (!(n >= 2 && n <= 1e5))
        throw InputError(name + " contains a line of " + parts[2] +
                         " points, allowed are 2 to 100000");
      return {checked_size(name, read_numbers(name, parts[0]), dimension),
              checked_size(name, read_numbers(name, parts[1]), dimension),
              static_cast<unsigned int>(n)};
    }

    /** Throws InputError unless a circle of a radius has a centre. */
    void
    check_plane_point(const std::string &name,
                      const std::vector<double> &center,
                      const double radius)
    {
      if (radius > 0 && center.size() != 2)
        throw InputError(name + " has " + std::to_string(center.size()) +
                         " coordinate(s), expected are 2 (x and y)");
    }

    /** Throws InputError unless the box has an inside and a number of cells
     * that can be counted. */
    void
    check_box(const FlowParameters &parameters)
    {
      double n_coarse = 1;
      for (unsigned int d = 0; d < parameters.dimension; ++d)
        {
          n_coarse *= parameters.coarse_cells[d];
          if (!(parameters.upper[d] > parameters.lower[d]))
            throw InputError("Flow/Upper corner is " +
                             join_numbers(parameters.upper) +
                             " m, each coordinate must be above that of "
                             "Flow/Lower corner, " +
                             join_numbers(parameters.lower) + " m");
        }
      for (const unsigned int level : parameters.refinements)
        {
          const double n = std::ldexp(n_coarse, level * parameters.dimension);
          if (n > max_number_of_cells)
            throw InputError("Flow/Refinements has the level " +
                             std::to_string(level) + ", which gives " +
                             dealii::Utilities::to_string(n) +
                             " cells, allowed are 2^31");
        }
    }

    void
    declare_box(ParameterHandler &prm)
    {
      const FlowParameters defaults;
      const List coordinates(Double(), 0, 3);
      prm.declare_entry("Dimension",
                        "2",
                        Integer(2, 3),
                        "Number of space dimensions. In two, forces and "
                        "energies are those of a depth of 1 m.");
      prm.declare_entry("Lower corner",
                        join_numbers(defaults.lower),
                        coordinates,
                        "Lower corner of the box (m).");
      prm.declare_entry("Upper corner",
                        join_numbers(defaults.upper),
                        coordinates,
                        "Upper corner of the box (m).");
      prm.declare_entry("Coarse cells",
                        "1, 1",
                        List(Integer(1, 1000), 2, 3),
                        "Cells of level 0 in each direction; they must be "
                        "squares or cubes.");
      prm.declare_entry("Refinements",
                        "3, 4, 5",
                        List(Integer(0, 14), 1, 20),
                        "Levels of refinement of these cells. There is one "
                        "run a level, and a table of all of them.");
      prm.declare_entry("Patch lower corner",
                        "",
                        coordinates,
                        "Lower corner (m) of a box with finer cells; empty "
                        "without one.");
      prm.declare_entry("Patch upper corner",
                        "",
                        coordinates,
                        "Upper corner (m) of the box with finer cells.");
      prm.declare_entry("Patch levels",
                        "1",
                        Integer(1, 6),
                        "Levels by which cells in that box are finer.");
    }

    void
    declare_boundaries(ParameterHandler &prm)
    {
      for (const std::string &name : side_names)
        prm.declare_entry("Side " + name,
                          "no-slip",
                          Selection("no-slip|slip|velocity|pressure"),
                          "What this side of the box does: holds the fluid, "
                          "lets it slip, gives it the boundary velocity, or "
                          "exerts the boundary pressure (with convection: "
                          "total pressure) while the tangential velocity is "
                          "zero.");
      prm.declare_entry("Boundary velocity",
                        "",
                        Anything(),
                        "Velocity (m/s) on sides of the kind velocity: "
                        "expressions in x, y, z, t and constants, separated "
                        "by semicolons.");
      prm.declare_entry("Boundary pressure",
                        "",
                        Anything(),
                        "Pressure (Pa) on sides of the kind pressure: an "
                        "expression, taken at the centre of the side. Empty "
                        "is zero.");
      prm.declare_entry("Boundary impedance",
                        "0",
                        Double(0),
                        "Impedance (Pa s/m) of sides of the kind pressure: "
                        "pressure that is added for each m/s of outflow, "
                        "which absorbs sound.");
    }

    void
    declare_fields(ParameterHandler &prm)
    {
      prm.declare_entry("Constants",
                        "",
                        Anything(),
                        "Constants for the expressions: a list name = "
                        "expression, separated by commas. There are also pi, "
                        "and rho, mu, nu and c of the fluid.");
      prm.declare_entry("Initial velocity",
                        "",
                        Anything(),
                        "Velocity (m/s) at time 0: expressions separated by "
                        "semicolons; empty for rest.");
      prm.declare_entry("Initial pressure",
                        "",
                        Anything(),
                        "Pressure (Pa) at time 0: an expression; empty for "
                        "zero.");
      prm.declare_entry("Exact velocity",
                        "",
                        Anything(),
                        "Velocity (m/s) from which the error is measured; "
                        "empty for no error.");
      prm.declare_entry("Exact pressure",
                        "",
                        Anything(),
                        "Pressure (Pa) from which the error is measured, "
                        "without its mean if no side is of the kind pressure; "
                        "empty for no error.");
    }

    void
    declare_measurements(ParameterHandler &prm)
    {
      prm.declare_entry("Obstacle centre",
                        "",
                        List(Double(), 0, 2),
                        "Centre (m, x and y) of a disc, in 3D of a cylinder "
                        "along z, that holds the fluid; empty without one.");
      prm.declare_entry("Obstacle radius",
                        "0",
                        Double(0),
                        "Radius (m) of the obstacle.");
      prm.declare_entry("Tube centre",
                        "",
                        List(Double(), 0, 2),
                        "Axis (m, x and y) of a tube along z that contains "
                        "the fluid, in 3D; empty without one.");
      prm.declare_entry("Tube radius",
                        "0",
                        Double(0),
                        "Radius (m) of the tube: the fluid is held at nodes "
                        "on and beyond it. The flow through it is recorded.");
      prm.declare_entry("Reference speed",
                        "0",
                        Double(0),
                        "Speed U (m/s) of coefficients: forces on the obstacle "
                        "are divided by rho U^2/2 times its diameter (and, in "
                        "3D, its length). 0 gives forces in N.");
      prm.declare_entry("Pressure points",
                        "",
                        Anything(),
                        "Points (m), separated by semicolons, at which the "
                        "pressure is recorded; of two or more also the "
                        "difference of the first two.");
      prm.declare_entry("Profiles",
                        "",
                        Anything(),
                        "Lines along which velocity and pressure are written "
                        "at the end time, separated by semicolons; each is "
                        "begin : end : number of points, for example "
                        "0.5, 0 : 0.5, 1 : 101 (m).");
      prm.declare_entry("Dissipation",
                        "false",
                        Bool(),
                        "Whether the powers (W) are recorded that viscosity, "
                        "artificial viscosity, hourglass damping and "
                        "checkerboard filter dissipate.");
      prm.declare_entry("Reference values",
                        "",
                        FileName(FileName::input),
                        "Table of velocities, relative to the parameter file: "
                        "a line of coordinates (m), number of the component "
                        "(from 0) and its value (m/s) each. The largest "
                        "deviation from it at the end time is reported.");
      prm.declare_entry("Errors",
                        "end",
                        Selection("end|largest"),
                        "Whether errors are measured at the end time, or at "
                        "each output (Output/Interval) and the largest ones "
                        "reported.");
      prm.declare_entry("Figures from",
                        "0",
                        Double(0),
                        "Time (s) from which mean, range and frequency of "
                        "forces and pressures are taken.");
    }
  } // namespace



  void
  FlowParameters::declare_parameters(ParameterHandler &prm,
                                     const FlowContents contents)
  {
    RunParameters::declare_parameters(prm);
    RunParameters::declare_checkpoints(prm);
    prm.enter_subsection("Time");
    prm.declare_entry("Step safety",
                      "0.8",
                      Double(0.01, 1.5),
                      "Step length over the stability limit (-).");
    prm.leave_subsection();
    FluidParameters::declare_parameters(prm);
    prm.enter_subsection("Flow");
    declare_box(prm);
    declare_boundaries(prm);
    declare_fields(prm);
    declare_measurements(prm);
    prm.leave_subsection();
    VariedParameters::declare_parameters(prm);
    if (contents == FlowContents::bodies)
      ImmersedParameters::declare_parameters(prm);
  }



  void
  FlowParameters::parse_parameters(ParameterHandler &prm)
  {
    run.parse_parameters(prm);
    run.parse_checkpoints(prm);
    fluid.parse_parameters(prm);
    prm.enter_subsection("Time");
    step_safety = prm.get_double("Step safety");
    prm.leave_subsection();

    prm.enter_subsection("Flow");
    dimension           = prm.get_integer("Dimension");
    const auto point_of = [&](const std::string &name) {
      return read_numbers("Flow/" + name, prm.get(name));
    };
    const auto integers = [&](const std::string &name) {
      std::vector<unsigned int> result;
      for (const double number : point_of(name))
        result.push_back(static_cast<unsigned int>(number));
      return result;
    };
    lower =
      checked_size("Flow/Lower corner", point_of("Lower corner"), dimension);
    upper =
      checked_size("Flow/Upper corner", point_of("Upper corner"), dimension);
    coarse_cells =
      checked_size("Flow/Coarse cells", integers("Coarse cells"), dimension);
    refinements  = integers("Refinements");
    patch_lower  = point_of("Patch lower corner");
    patch_upper  = point_of("Patch upper corner");
    patch_levels = prm.get_integer("Patch levels");
    check_box(*this);
    if (!patch_lower.empty() || !patch_upper.empty())
      {
        checked_size("Flow/Patch lower corner", patch_lower, dimension);
        checked_size("Flow/Patch upper corner", patch_upper, dimension);
      }
    for (unsigned int i = 0; i < 6; ++i)
      sides[i] = boundary_kinds.at(prm.get("Side " + side_names[i]));
    impedance         = prm.get_double("Boundary impedance");
    constants         = prm.get("Constants");
    initial_velocity  = prm.get("Initial velocity");
    initial_pressure  = prm.get("Initial pressure");
    boundary_velocity = prm.get("Boundary velocity");
    boundary_pressure = prm.get("Boundary pressure");
    exact_velocity    = prm.get("Exact velocity");
    exact_pressure    = prm.get("Exact pressure");
    obstacle_center   = point_of("Obstacle centre");
    obstacle_radius   = prm.get_double("Obstacle radius");
    check_plane_point("Flow/Obstacle centre", obstacle_center, obstacle_radius);
    tube_center = point_of("Tube centre");
    tube_radius = prm.get_double("Tube radius");
    check_plane_point("Flow/Tube centre", tube_center, tube_radius);
    if (tube_radius > 0 && dimension != 3)
      throw InputError("Flow/Tube radius is " + prm.get("Tube radius") +
                       ", but a tube needs Flow/Dimension = 3");
    reference_speed = prm.get_double("Reference speed");
    pressure_points = read_points("Flow/Pressure points",
                                  prm.get("Pressure points"),
                                  dimension);
    profiles.clear();
    for (const std::string &text : split_string_list(prm.get("Profiles"), ';'))
      profiles.push_back(line(text, dimension));
    records_dissipation = prm.get_bool("Dissipation");
    reference_values    = prm.get("Reference values");
    largest_errors      = prm.get("Errors") == "largest";
    figures_from        = prm.get_double("Figures from");
    prm.leave_subsection();

    varied.parse_parameters(prm);
    if (varied.n_runs() > 0 && refinements.size() != 1)
      throw InputError("Study/Parameter is varied at one level, but "
                       "Flow/Refinements has " +
                       std::to_string(refinements.size()));
    if (immersed)
      immersed->parse_parameters(prm, dimension);
  }



  NamedConstants
  FlowParameters::named_constants() const
  {
    return read_constants("Flow/Constants",
                          constants,
                          {{"rho", fluid.density},
                           {"mu", fluid.viscosity},
                           {"nu", fluid.viscosity / fluid.density},
                           {"c", fluid.sound_speed}});
  }
} // namespace coapt
