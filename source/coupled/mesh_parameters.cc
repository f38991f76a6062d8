#include <coapt/base/exceptions.h>
#include <coapt/base/units.h>
#include <coapt/coupled/mesh_parameters.h>

#include <string>

namespace coapt
{
  void
  MeshParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Bool;
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;
    prm.enter_subsection("Mesh");
    prm.declare_entry("Coarse cell",
                      "5",
                      Double(1e-3, 1e3),
                      "Edge of a cell of the coarse mesh (mm).");
    prm.declare_entry("Lumen level",
                      "2",
                      Integer(0, 10),
                      "Refinements of the lumen away from the leaflet (-).");
    prm.declare_entry("Leaflet level",
                      "3",
                      Integer(0, 12),
                      "Refinements around the leaflet (-); at least the "
                      "lumen's.");
    prm.declare_entry("Wall level",
                      "0",
                      Integer(0, 12),
                      "Refinements of the cells that the wall of the lumen "
                      "cuts (-); if it is below the lumen's, they are as "
                      "large as the others. Steps in a coarse wall make the "
                      "lumen wider.");
    prm.declare_entry("Band",
                      "2.5",
                      Double(2., 100.),
                      "Half width of the refined band around the leaflet, in "
                      "cells of the finest level (-).");
    prm.declare_entry("Levels coarser apart",
                      "0",
                      Integer(0, 12),
                      "By how many levels the cells around the leaflet are "
                      "coarser where it faces no other part of itself (-).");
    prm.declare_entry(
      "Sparser points apart",
      "false",
      Bool(),
      "Whether coupling points are twice as far apart there, as "
      "the larger cells ask for.");
    prm.declare_entry("Facing distance",
                      "4",
                      Double(1e-3, 1e3),
                      "Parts of the leaflet that are nearer than this face "
                      "each other (mm).");
    prm.declare_entry("Flow level",
                      "0",
                      Integer(0, 12),
                      "Deepest level of cells that are refined where the "
                      "velocity changes much (-); from the lumen's level "
                      "downwards, no cells are.");
    prm.declare_entry("Flow velocity jump",
                      "0.1",
                      Double(1e-6, 1e3),
                      "Change of velocity over a cell above which it is "
                      "refined for the flow (m/s); below a half of it, cells "
                      "are joined again.");
    prm.declare_entry("Flow interval",
                      "2e-3",
                      Double(1e-9, 1e3),
                      "Time between two adaptations to the flow (s).");
    prm.declare_entry("Largest number of cells",
                      "1000000",
                      Integer(1),
                      "Cells with fluid beyond which the velocity jump is "
                      "raised, by a fifth at each adaptation (-).");
    prm.leave_subsection();
  }



  void
  MeshParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Mesh");
    coarse_cell          = prm.get_double("Coarse cell") * units::millimetre;
    lumen_level          = prm.get_integer("Lumen level");
    leaflet_level        = prm.get_integer("Leaflet level");
    wall_level           = prm.get_integer("Wall level");
    band                 = prm.get_double("Band");
    levels_coarser_apart = prm.get_integer("Levels coarser apart");
    sparser_points_apart = prm.get_bool("Sparser points apart");
    facing_distance = prm.get_double("Facing distance") * units::millimetre;
    flow_level      = prm.get_integer("Flow level");
    flow_jump       = prm.get_double("Flow velocity jump");
    flow_interval   = prm.get_double("Flow interval");
    max_cells       = prm.get_integer("Largest number of cells");
    prm.leave_subsection();
    if (leaflet_level < lumen_level)
      throw InputError(
        "Mesh: Leaflet level is " + std::to_string(leaflet_level) +
        ", but must be at least Lumen level, " + std::to_string(lumen_level));
    if (leaflet_level - lumen_level < levels_coarser_apart)
      throw InputError("Mesh: Levels coarser apart is " +
                       std::to_string(levels_coarser_apart) +
                       ", but must be at most Leaflet level minus Lumen "
                       "level, " +
                       std::to_string(leaflet_level - lumen_level));
    if (wall_level > leaflet_level)
      throw InputError("Mesh: Wall level is " + std::to_string(wall_level) +
                       ", but must be at most Leaflet level, " +
                       std::to_string(leaflet_level));
    if (flow_level > leaflet_level)
      throw InputError("Mesh: Flow level is " + std::to_string(flow_level) +
                       ", but must be at most Leaflet level, " +
                       std::to_string(leaflet_level));
  }
} // namespace coapt
