#include <coapt/base/exceptions.h>
#include <coapt/base/run_parameters.h>
#include <coapt/base/units.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using namespace dealii;

  bool
  RunParameters::is_over(const double t, const unsigned long steps) const
  {
    return t >= end_time * (1 - 1e-9) || (max_steps > 0 && steps >= max_steps);
  }



  std::string
  RunParameters::until() const
  {
    return "to " + Patterns::Tools::to_string(end_time) + " s";
  }



  void
  RunParameters::check_end_time(const double time) const
  {
    if (time > end_time * (1 + 1e-9))
      throw InputError(
        "Time/End time is " + Patterns::Tools::to_string(end_time) +
        " s, but must not be before the checkpoint, which is of " +
        Patterns::Tools::to_string(time) + " s");
  }



  void
  RunParameters::declare_parameters(ParameterHandler &prm)
  {
    const RunParameters defaults;
    // times have to be positive; the pattern's bounds are inclusive
    const double least = 1e-9;
    prm.enter_subsection("Time");
    prm.declare_entry("End time",
                      Patterns::Tools::to_string(defaults.end_time),
                      Patterns::Double(least, 100.),
                      "Time at which the run ends (s); it starts at 0.");
    prm.declare_entry("Largest number of steps",
                      "0",
                      Patterns::Integer(0),
                      "Steps after which the run ends even before the end "
                      "time, to try a file out (-); 0 for no such end.");
    prm.leave_subsection();

    prm.enter_subsection("Output");
    prm.declare_entry("Folder",
                      defaults.output_folder,
                      Patterns::FileName(Patterns::FileName::output),
                      "Folder for all results, relative to the folder in "
                      "which the program is started. Created if necessary.");
    prm.declare_entry("Overwrite",
                      "false",
                      Patterns::Bool(),
                      "Whether results of an earlier run in the folder may "
                      "be overwritten.");
    prm.declare_entry("Interval",
                      Patterns::Tools::to_string(defaults.output_interval),
                      Patterns::Double(least, 100.),
                      "Time between two rows of statistics.csv, and between "
                      "two lines on the terminal (s).");
    prm.declare_entry("Fields interval",
                      Patterns::Tools::to_string(defaults.fields_interval),
                      Patterns::Double(0., 100.),
                      "Time between two sets of files for ParaView (s). They "
                      "are written at the first row of statistics that is due "
                      "after it has passed; 0 writes none.");
    prm.declare_entry("Surface load",
                      "false",
                      Patterns::Bool(),
                      "Whether a valve in blood writes surface_load.csv: the "
                      "traction on each point of the leaflets, mean over each "
                      "Interval, which can drive a run without fluid "
                      "(Structure: Load).");
    prm.declare_entry(
      "Flow planes",
      "",
      Patterns::List(
        Patterns::List(Patterns::Double(), 6, 6, ","), 0, 100, ";"),
      "Planes x, y, z, nx, ny, nz; ... through a point (mm) with a normal (of "
      "any length). The flow of blood through each within the lumen, along its "
      "normal, and the same without what the leaflets sweep, which is the leak "
      "if the normal points to the atrium and the plane does not cut the "
      "leaflets, are columns of statistics.csv.");
    prm.leave_subsection();
  }



  namespace
  {
    std::vector<std::array<double, 6>>
    read_planes(const std::string &list)
    {
      using namespace dealii::Utilities;
      std::vector<std::array<double, 6>> planes;
      for (const std::string &entry : split_string_list(list, ';'))
        {
          const std::vector<double> numbers =
            string_to_double(split_string_list(entry, ','));
          std::array<double, 6> plane;
          std::copy(numbers.begin(), numbers.end(), plane.begin());
          if (std::hypot(plane[3], plane[4], plane[5]) == 0)
            throw InputError("Output/Flow planes: the plane " + entry +
                             " has a normal of length zero");
          for (unsigned int d = 0; d < 3; ++d)
            plane[d] *= units::millimetre;
          planes.push_back(plane);
        }
      return planes;
    }
  } // namespace



  void
  RunParameters::declare_checkpoints(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.declare_entry(
      "Checkpoint interval",
      "10",
      Patterns::Double(0.),
      "Wall time between two checkpoints, from which a run that "
      "was interrupted can go on (min). A checkpoint is "
      "written at the first row of statistics that is due after "
      "it has passed, and replaces the last one; 0 writes none. "
      "A valve without blood has no checkpoints.");
    prm.declare_entry("Resume",
                      "false",
                      Patterns::Selection("false|true|auto"),
                      "Whether to go on from the checkpoint in the folder: "
                      "false begins anew, true needs a checkpoint, auto goes "
                      "on if there is one. Meshes must be the same; other "
                      "parameters may have changed, and the number of "
                      "processes for a valve; not the values at the sides of a "
                      "flow. Tables and fields go on, too. A study goes on "
                      "with the first run that is not in its table, from its "
                      "checkpoint if it has one; its runs must be the same.");
    prm.leave_subsection();
  }



  void
  RunParameters::parse_checkpoints(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    checkpoint_interval    = 60 * prm.get_double("Checkpoint interval");
    const std::string text = prm.get("Resume");
    resume                 = text == "true" ? Resume::always
                      : text == "auto"      ? Resume::if_possible
                                            : Resume::never;
    prm.leave_subsection();
  }



  void
  RunParameters::parse_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    end_time  = prm.get_double("End time");
    max_steps = prm.get_integer("Largest number of steps");
    prm.leave_subsection();

    prm.enter_subsection("Output");
    output_folder   = prm.get("Folder");
    overwrite       = prm.get_bool("Overwrite");
    output_interval = prm.get_double("Interval");
    fields_interval = prm.get_double("Fields interval");
    surface_load    = prm.get_bool("Surface load");
    flow_planes     = read_planes(prm.get("Flow planes"));
    prm.leave_subsection();

    if (output_folder.empty())
      throw InputError("Output/Folder is empty, a folder's name is needed");
    if (end_time / output_interval > 1e6)
      throw InputError("Output/Interval asks for more than 10^6 rows, found " +
                       Patterns::Tools::to_string(output_interval) +
                       " s for an end time of " +
                       Patterns::Tools::to_string(end_time) + " s");
  }
} // namespace coapt
