#include <coapt/base/exceptions.h>
#include <coapt/import/import_parameters.h>

namespace coapt
{
  namespace
  {
    const std::map<std::string, Region> region_names = {
      {"anterior", Region::anterior},
      {"posterior", Region::posterior},
      {"commissure", Region::commissure},
      {"root", Region::root},
      {"septal", Region::septal}};

    const std::map<std::string, double> units = {{"mm", 1e-3},
                                                 {"cm", 1e-2},
                                                 {"m", 1.}};
  } // namespace



  void
  ImportParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Valve");
    prm.declare_entry("Source",
                      "generated",
                      Selection("generated|imported"),
                      "Where the valve comes from: from the shape that is "
                      "described here, or from the files of Import. Of this "
                      "subsection, an imported valve takes thickness, elements "
                      "through the thickness, prestretches, fibres and what is "
                      "held at the annulus; of Chordae, modulus and influence "
                      "radius. It needs Structure/Fluid = none.");
    prm.leave_subsection();

    prm.enter_subsection("Import");
    prm.declare_entry("Mesh",
                      "",
                      Anything(),
                      "Mesh of the mid-surface, quadrilaterals or triangles, "
                      "in Gmsh's format 2.2 (ASCII), sought beside the "
                      "parameter file. The atrium lies at larger z.");
    prm.declare_entry("Unit",
                      "mm",
                      Selection("mm|cm|m"),
                      "Unit of the lengths in mesh and chordae.");
    prm.declare_entry("Regions",
                      "1:anterior, 2:posterior",
                      Map(Integer(0),
                          Selection("anterior|posterior|commissure|root|"
                                    "septal"),
                          1,
                          Map::max_int_value),
                      "Region of each physical label of the mesh.");
    prm.declare_entry("Held nodes",
                      "",
                      Anything(),
                      "File with the nodes that are held: a CSV with the "
                      "columns set (its name; one is annulus), vertex (number "
                      "in the mesh, from 0, or -1), chordae_node (number in "
                      "the file of chordae, or -1).");
    prm.declare_entry("Chordae",
                      "",
                      Anything(),
                      "File with the segments of chordae: a CSV with the "
                      "columns node1, node2, x1, y1, z1, x2, y2, z2, vertex1, "
                      "vertex2 (of the mesh where an end is attached to it, or "
                      "-1), diameter_mm. Segments may branch. Empty: none.");
    prm.declare_entry("Fibres",
                      "",
                      Anything(),
                      "File with the fibre direction of each element of the "
                      "mesh, in its order: a CSV with the columns fx, fy, fz. "
                      "Empty: the rule Valve/Fibres.");
    prm.declare_entry("Chordae length factor",
                      "1",
                      Double(0.5, 2),
                      "Lengths at which chordae begin to pull, over their "
                      "lengths in the file (-).");
    prm.leave_subsection();
  }



  void
  ImportParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Valve");
    is_wanted = prm.get("Source") == "imported";
    prm.leave_subsection();

    prm.enter_subsection("Import");
    mesh          = prm.get("Mesh");
    held_nodes    = prm.get("Held nodes");
    chordae       = prm.get("Chordae");
    fibres        = prm.get("Fibres");
    unit          = units.at(prm.get("Unit"));
    length_factor = prm.get_double("Chordae length factor");
    regions.clear();
    for (const std::string &entry :
         dealii::Utilities::split_string_list(prm.get("Regions")))
      {
        const auto parts = dealii::Utilities::split_string_list(entry, ':');
        regions[dealii::Utilities::string_to_int(parts[0])] =
          region_names.at(parts[1]);
      }
    prm.leave_subsection();
    for (const auto &[name, value] :
         {std::pair<std::string, std::string>{"Mesh", mesh},
          std::pair<std::string, std::string>{"Held nodes", held_nodes}})
      if (is_wanted && value.empty())
        throw InputError("Import/" + name +
                         " is empty; Valve/Source = imported needs it");
  }
} // namespace coapt
