#include <coapt/base/exceptions.h>
#include <coapt/solid/solid_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <sstream>
#include <type_traits>

namespace coapt
{
  namespace
  {
    /** Names of all materials, with @p separator in between. */
    std::string
    material_names(const std::string &separator)
    {
      std::string names;
      const Materials all;
      Materials::for_each(all, [&](const auto &law) {
        names += (names.empty() ? "" : separator) + law.name;
      });
      return names;
    }

    /** Names of the materials that exist in 3D only. */
    std::string
    spatial_names()
    {
      std::string names;
      const Materials all;
      Materials::for_each(all, [&](const auto &law) {
        if (law.is_spatial)
          names += (names.empty() ? "" : ", ") + std::string(law.name);
      });
      return names;
    }

    /** Two stretches from a list; equal ones if it is empty. */
    void
    read_range(const std::string &list, double &lowest, double &highest)
    {
      using namespace dealii::Utilities;
      const auto numbers = string_to_double(split_string_list(list));
      lowest = highest = 1;
      if (numbers.empty())
        return;
      if (numbers.size() != 2 || !(numbers[0] > 0 && numbers[0] < numbers[1]))
        throw InputError("Solid/Examined stretches is \"" + list +
                         "\", expected are two positive stretches, the "
                         "smaller one first.");
      lowest  = numbers[0];
      highest = numbers[1];
    }
  } // namespace

  void
  SolidParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const SolidParameters defaults;
    prm.enter_subsection("Solid");
    prm.declare_entry("Material",
                      defaults.material,
                      Selection(material_names("|")),
                      "Law of the solid; each has a subsection. In 3D only: " +
                        spatial_names() + ".");
    prm.declare_entry("Density",
                      std::to_string(defaults.density),
                      Double(1, 1e5),
                      "Mass density (kg/m^3).");
    prm.declare_entry("Averaged volume",
                      "false",
                      Bool(),
                      "Whether the changes of volume of linear elements are "
                      "averaged over their nodes, so that they do not lock "
                      "where the material is nearly incompressible. Forces "
                      "then take 2.5 times as long. Without effect on elements "
                      "of ten nodes.");
    prm.declare_entry("Viscosity",
                      std::to_string(defaults.viscosity),
                      Double(0, 1e6),
                      "Kelvin-Voigt viscosity (Pa s).");
    prm.declare_entry("Distortion control",
                      "false",
                      Bool(),
                      "Whether cells that are crushed below the distortion "
                      "threshold are stiffened.");
    prm.declare_entry("Distortion threshold",
                      std::to_string(defaults.distortion_threshold),
                      Double(1e-3, 0.9),
                      "Smallest principal stretch, relative to the mesh "
                      "(-), below which a cell counts as distorted. The "
                      "summary says how many did.");
    prm.declare_entry("Examined stretches",
                      "",
                      List(Double(0.01, 100), 0, 2),
                      "Smallest and largest stretch (-) in the tangent "
                      "plane between which the material is examined: a "
                      "warning names the state where its tangent loses "
                      "positivity. Empty: none.");
    Materials all;
    Materials::for_each(all, [&](auto &law) { law.declare_parameters(prm); });
    prm.leave_subsection();
  }

  void
  SolidParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Solid");
    material             = prm.get("Material");
    density              = prm.get_double("Density");
    viscosity            = prm.get_double("Viscosity");
    averages_volume      = prm.get_bool("Averaged volume");
    controls_distortion  = prm.get_bool("Distortion control");
    distortion_threshold = prm.get_double("Distortion threshold");
    read_range(prm.get("Examined stretches"), lowest_stretch, highest_stretch);
    Materials::for_each(*this, [&](auto &law) { law.parse_parameters(prm); });
    prm.leave_subsection();
    check();
  }

  Material
  SolidParameters::selected_material() const
  {
    Material result;
    bool found = false;
    Materials::for_each(*this, [&](const auto &law) {
      if (material == law.name)
        {
          found  = true;
          result = law;
        }
    });
    if (!found)
      throw InputError("Solid/Material is \"" + material + "\", allowed are " +
                       material_names(", ") + ".");
    std::visit([](const auto &law) { law.check(); }, result);
    return result;
  }

  void
  SolidParameters::check() const
  {
    selected_material();
    std::ostringstream message;
    if (!(density > 0))
      message << "Solid/Density is " << density
              << " kg/m^3, it must be positive.";
    else if (!(viscosity >= 0))
      message << "Solid/Viscosity is " << viscosity
              << " Pa s, it must not be negative.";
    if (!message.str().empty())
      throw InputError(message.str());
  }
} // namespace coapt
