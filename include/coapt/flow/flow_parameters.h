#ifndef coapt_flow_flow_parameters_h
#define coapt_flow_flow_parameters_h

#include <coapt/base/run_parameters.h>
#include <coapt/base/varied_parameters.h>
#include <coapt/flow/expressions.h>
#include <coapt/flow/immersed_parameters.h>
#include <coapt/fluid/boundary_conditions.h>
#include <coapt/fluid/fluid_parameters.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** What is in the fluid. */
  enum class FlowContents
  {
    nothing,
    bodies
  };

  /**
   * A flow in a box: what the task "flow" computes, or with elastic bodies in
   * it the task "immersed". Lengths in m, unlike those of valves, since
   * verification has no natural scale. Lists of coordinates have as many
   * entries as there are dimensions.
   */
  struct FlowParameters
  {
    RunParameters run;
    FluidParameters fluid;

    /** 2 or 3. */
    unsigned int dimension = 2;

    /** Corners of the box (m). */
    std::vector<double> lower{0, 0}, upper{1, 1};

    /** Cells of level 0 in each direction. */
    std::vector<unsigned int> coarse_cells{1, 1};

    /** Levels of refinement: a run for each of them. */
    std::vector<unsigned int> refinements{3, 4, 5};

    /** Corners of a box (m) in which cells are finer, empty without one. */
    std::vector<double> patch_lower, patch_upper;

    /** Levels by which they are finer. */
    unsigned int patch_levels = 1;

    /** Kinds of the sides: x lower, x upper, y lower, ... */
    std::array<FluidBoundary, 6> sides{};

    /** Impedance of pressure boundaries (Pa s/m). */
    double impedance = 0;

    /** Expressions; those that are empty are zero or not there. @{ */
    std::string constants;
    std::string initial_velocity, initial_pressure;
    std::string boundary_velocity, boundary_pressure;
    std::string exact_velocity, exact_pressure;
    /** @} */

    /** Disc or, along z, cylinder that holds the fluid: centre in the plane,
     * and radius (m), zero without one. */
    std::vector<double> obstacle_center;
    double obstacle_radius = 0;

    /** Tube along z that contains the fluid: axis in the plane, and radius
     * (m), zero without one. */
    std::vector<double> tube_center;
    double tube_radius = 0;

    /** Speed (m/s) that makes coefficients of forces on the obstacle, zero
     * for forces. */
    double reference_speed = 0;

    /** Positions (m) at which the pressure is recorded. */
    std::vector<std::vector<double>> pressure_points;

    /** Beginnings and ends (m) of lines, and numbers of points on them. */
    struct Line
    {
      std::vector<double> begin, end;
      unsigned int n_points;
    };
    std::vector<Line> profiles;

    /** Whether the powers that are dissipated are recorded. */
    bool records_dissipation = false;

    /** File of velocities to compare with, empty without one. */
    std::string reference_values;

    /** Whether errors are the largest of all outputs, instead of those at the
     * end time. */
    bool largest_errors = false;

    /** Mean, range and frequency of signals are taken from here on (s). */
    double figures_from = 0;

    /** Step over the stability limit. */
    double step_safety = 0.8;

    /** What is varied in place of the level. */
    VariedParameters varied;

    /** The bodies in the fluid, if there are any. */
    std::optional<ImmersedParameters> immersed;

    /** Declares the parameters of the task. */
    static void
    declare_parameters(dealii::ParameterHandler &prm,
                       const FlowContents contents = FlowContents::nothing);

    /** Reads them, those of bodies if immersed is there. Throws InputError for
     * what does not fit together. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** The constants that expressions may use: those of the fluid (rho, mu,
     * nu, c), the given ones, and pi. */
    NamedConstants
    named_constants() const;
  };
} // namespace coapt

#endif
