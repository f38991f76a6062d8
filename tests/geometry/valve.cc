// The generated valve: mesh, labels, fibres, held nodes, chordae, bad input.

#include <coapt/base/exceptions.h>
#include <coapt/geometry/valve_generator.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include "geometry/mesh_checks.h"

using namespace coapt;
using namespace dealii;

std::vector<double>
nodal_mass(const SimplexMesh<3> &mesh)
{
  std::vector<double> mass(mesh.points.size());
  for (const auto &cell : mesh.cells)
    for (const unsigned int node : cell)
      mass[node] += 1060 * volume(mesh, cell) / 4;
  return mass;
}

void
test_labels(const ValveParameters &valve, const Leaflet &leaflet)
{
  check("sizes",
        leaflet.columns.size() == 84 * 14 && leaflet.quads.size() == 84 * 13 &&
          leaflet.mesh.cells.size() == 84 * 13 * 10 &&
          leaflet.cell_quad.size() == leaflet.mesh.cells.size() &&
          leaflet.quad_region.size() == leaflet.quads.size() &&
          leaflet.fibre.size() == leaflet.mesh.cells.size() &&
          leaflet.prestretch.size() == leaflet.mesh.cells.size() &&
          leaflet.pinned.size() == leaflet.mesh.points.size() &&
          leaflet.column_coordinates.size() == leaflet.columns.size() &&
          leaflet.annulus_columns.size() == 84 &&
          leaflet.free_edge_columns.size() == 84);
  unsigned int count[4] = {};
  for (const Region region : leaflet.quad_region)
    ++count[static_cast<unsigned int>(region)];
  // commissures: 15 of 360 / 84 degrees around each
  check("regions",
        count[3] == 84 && count[2] >= 2 * 3 * 12 && count[2] <= 2 * 4 * 12 &&
          count[0] > 20 * 12 && count[1] > 40 * 12 &&
          count[0] + count[1] + count[2] == 84 * 12,
        count[2]);

  double edge = 0, annulus = 0, thickness = 0, outward = 1;
  for (const unsigned int c : leaflet.free_edge_columns)
    edge = std::max(edge, std::abs(leaflet.column_coordinates[c][1] - 1));
  for (const unsigned int c : leaflet.annulus_columns)
    {
      const Point<3> &p = leaflet.mesh.points[leaflet.columns[c][1]];
      annulus =
        std::max(annulus,
                 p.distance(
                   annulus_point(valve, leaflet.column_coordinates[c][0])));
    }
  for (const auto &q : leaflet.quads)
    {
      std::vector<Tensor<1, 3>> mid, across;
      for (const unsigned int c : q)
        {
          const auto &nodes = leaflet.columns[c];
          mid.emplace_back(leaflet.mesh.points[nodes[1]]);
          across.push_back(leaflet.mesh.points[nodes[2]] -
                           leaflet.mesh.points[nodes[0]]);
        }
      Tensor<1, 3> normal = cross_product_3d(mid[2] - mid[0], mid[3] - mid[1]);
      normal /= normal.norm();
      outward                = std::min(outward, normal * across[0]);
      double normal_distance = 0;
      for (const auto &vector : across)
        normal_distance += vector * normal / 4;
      thickness =
        std::max(thickness, std::abs(normal_distance / valve.thickness - 1));
    }
  check("free edge columns", edge == 0, edge);
  check("annulus columns on the annulus", annulus < 1e-12, annulus);
  check("quads point to the ventricle", outward > 0, outward);
  check("thickness within 2 %", thickness < 0.02, thickness);
}

void
test_pinned(ValveParameters valve)
{
  const auto count = [&](const AnnulusHold hold, const unsigned int layers) {
    valve.annulus_hold    = hold;
    valve.n_layers        = layers;
    const Leaflet leaflet = generate_leaflet(valve);
    return std::count(leaflet.pinned.begin(), leaflet.pinned.end(), true);
  };
  check("straps hold two rows", count(AnnulusHold::straps, 2) == 2 * 84);
  check("hinge holds one row", count(AnnulusHold::hinge, 2) == 84);
  check("clamped holds all", count(AnnulusHold::clamped, 2) == 3 * 2 * 84);
  check("odd number of layers", count(AnnulusHold::straps, 3) == 4 * 84);

  valve.n_layers        = 2;
  valve.annulus_hold    = AnnulusHold::straps;
  const Leaflet leaflet = generate_leaflet(valve);
  bool mid              = true;
  for (const unsigned int c : leaflet.annulus_columns)
    mid = mid && !leaflet.pinned[leaflet.columns[c][0]] &&
      leaflet.pinned[leaflet.columns[c][1]] &&
      !leaflet.pinned[leaflet.columns[c][2]];
  check("straps hold the mid-surface", mid);
}

void
test_fibres(ValveParameters valve)
{
  const Leaflet leaflet = generate_leaflet(valve);
  double unit = 0, horizontal = 0, tangential = 0, det = 0, stretch = 0;
  for (unsigned int cell = 0; cell < leaflet.fibre.size(); ++cell)
    {
      const auto &f = leaflet.fibre[cell];
      const auto &q = leaflet.quads[leaflet.cell_quad[cell]];
      const auto p  = [&](const unsigned int c) {
        return leaflet.mesh.points[leaflet.columns[q[c]][1]];
      };
      Tensor<1, 3> normal = cross_product_3d(p(2) - p(0), p(3) - p(1));
      normal /= normal.norm();
      const Tensor<2, 3> &F0 = leaflet.prestretch[cell];
      unit                   = std::max(unit, std::abs(f.norm() - 1));
      horizontal             = std::max(horizontal, std::abs(f[2]));
      tangential             = std::max(tangential, std::abs(f * normal));
      det                    = std::max(det, std::abs(determinant(F0) - 1));
      const bool root =
        leaflet.quad_region[leaflet.cell_quad[cell]] == Region::root;
      stretch = std::max(stretch,
                         std::abs((F0 * normal) * normal -
                                  (root ? 1 : 1 / (1.10 * 1.15))));
    }
  check("fibres of unit length", unit < 1e-12, unit);
  check("fibres horizontal", horizontal < 1e-12, horizontal);
  check("fibres tangential", tangential < 1e-6, tangential);
  check("prestretch keeps the volume", det < 1e-12, det);
  check("prestretch thins the leaflet only", stretch < 1e-12, stretch);

  valve.fibre_rule    = FibreRule::circumferential;
  const Leaflet along = generate_leaflet(valve);
  double cosine = 1, tilt = 0;
  for (unsigned int cell = 0; cell < leaflet.fibre.size(); ++cell)
    {
      cosine = std::min(cosine, along.fibre[cell] * leaflet.fibre[cell]);
      tilt   = std::max(tilt, std::abs(along.fibre[cell][2]));
    }
  check("circumferential fibres have the same sense", cosine > 0.7, cosine);
  check("circumferential fibres follow the rows", tilt > 0.1, tilt);
}

void
test_chordae(ValveParameters valve)
{
  const Leaflet leaflet          = generate_leaflet(valve);
  const std::vector<double> mass = nodal_mass(leaflet.mesh);
  std::vector<Chorda> chordae    = generate_chordae(valve, leaflet, mass);

  unsigned int primary = 0, anterior = 0;
  double weight = 0, radius = 0, mirror = 0;
  for (const Chorda &chorda : chordae)
    {
      const bool is_primary =
        chorda.chorda_class == ChordaClass::anterior_primary ||
        chorda.chorda_class == ChordaClass::posterior_primary;
      primary += is_primary;
      anterior += chorda.chorda_class == ChordaClass::anterior_primary ||
        chorda.chorda_class == ChordaClass::anterior_secondary;
      double sum = 0;
      for (const double w : chorda.weights)
        sum += w;
      weight = std::max(weight, std::abs(sum - 1));
      for (const unsigned int a : chorda.nodes)
        for (const unsigned int b : chorda.nodes)
          radius =
            std::max(radius,
                     leaflet.mesh.points[a].distance(leaflet.mesh.points[b]));
    }
  for (unsigned int n = 0; n < 10; ++n)
    mirror =
      std::max(mirror,
               std::abs(chordae[n].rest_length / chordae[n + 10].rest_length -
                        1));
  check("14 primary, 6 secondary", chordae.size() == 20 && primary == 14);
  check("8 + 4 anterior", anterior == 12, anterior);
  check("weights of sum one", weight < 1e-12, weight);
  check("sphere of influence", radius < 2.5e-3 && radius > 1e-3, radius);
  check("left mirrors right", mirror < 1e-3, mirror);

  // lengths (mm) with which this valve was found to close
  const std::vector<std::pair<std::string, double>> table = {{"R-P1", 22.00},
                                                             {"R-P2", 20.23},
                                                             {"R-P3", 20.25},
                                                             {"R-P4", 19.68},
                                                             {"R-P5", 19.91},
                                                             {"R-P6", 21.27},
                                                             {"R-P7", 23.51},
                                                             {"R-S1", 32.84},
                                                             {"R-S2", 30.63},
                                                             {"R-S3", 27.95}};
  for (unsigned int n = 0; n < table.size(); ++n)
    {
      check("id " + table[n].first, chordae[n].id == table[n].first);
      check_relative("rest length " + table[n].first,
                     chordae[n].rest_length * 1e3,
                     table[n].second,
                     0.01);
    }

  valve.removed_chordae = {"R-P2", "L-S3"};
  chordae               = generate_chordae(valve, leaflet, mass);
  check("removal",
        chordae.size() == 18 &&
          std::none_of(chordae.begin(), chordae.end(), [](const Chorda &c) {
            return c.id == "R-P2" || c.id == "L-S3";
          }));
  valve.removed_chordae = chordae_ids(valve);
  check("all removed", generate_chordae(valve, leaflet, mass).empty());
}

/** A mesh of linear tetrahedra, with one row of the root. */
ValveParameters
linear_valve()
{
  ValveParameters valve;
  valve.quadratic         = false;
  valve.n_circumferential = 84;
  valve.n_root_rows       = 1;
  return valve;
}

void
test_shape(const ValveParameters &valve)
{
  constexpr double pi = numbers::PI;
  check_relative("anterior height",
                 leaflet_height(valve, pi / 2),
                 17.5e-3,
                 1e-12);
  check_relative("posterior height",
                 leaflet_height(valve, -pi / 2),
                 12.5e-3,
                 1e-12);
  check_relative("commissure height",
                 leaflet_height(valve, pi - valve.commissure_angle),
                 11.5e-3,
                 1e-9);
  double jump = 0, length = 0;
  for (unsigned int i = 0; i < 3600; ++i)
    {
      const double t = 2 * pi * i / 3600;
      jump           = std::max(jump,
                      std::abs(leaflet_height(valve, t + 1e-9) -
                               leaflet_height(valve, t - 1e-9)));
      length         = std::max(
        length,
        std::abs(open_position(valve, t, 1).distance(annulus_point(valve, t)) /
                   leaflet_height(valve, t) -
                 1));
    }
  check("height is continuous", jump < 1e-9, jump);
  check("open height along the leaflet", length < 1e-12, length);
  // mid-anterior: top of coaptation at (0, -3, -6), annulus at (0, 14, 2.5)
  const double straight = std::hypot(17e-3, 8.5e-3);
  const Point<3> edge   = closed_position(valve, pi / 2, 1);
  check("closed design, mid-anterior edge",
        edge.distance(Point<3>(0, -3e-3, -6e-3 - (1.2 * 17.5e-3 - straight))) <
          1e-9,
        edge[2]);
}

void
test_input()
{
  const auto refused = [](const std::function<void(ParameterHandler &)> &set) {
    ParameterHandler prm;
    ValveParameters::declare_parameters(prm);
    try
      {
        set(prm);
        ValveParameters valve;
        valve.parse_parameters(prm);
        const Leaflet leaflet = generate_leaflet(valve);
        generate_chordae(valve, leaflet, nodal_mass(leaflet.mesh));
      }
    catch (const std::exception &)
      {
        return true;
      }
    return false;
  };
  const auto entry = [](const std::string &section,
                        const std::string &name,
                        const std::string &value) {
    return [=](ParameterHandler &prm) {
      prm.enter_subsection(section);
      prm.set(name, value);
      prm.leave_subsection();
    };
  };
  check("defaults are accepted", !refused([](ParameterHandler &) {}));
  check("thickness 0 refused", refused(entry("Valve", "Thickness", "0")));
  check("odd elements refused",
        refused(entry("Valve", "Elements around", "83")));
  check("odd layers of quadratic elements refused",
        refused(entry("Valve", "Layers", "3")));
  check("elements around no multiple of eight refused for quadratic ones",
        refused(entry("Valve", "Elements around", "84")));
  check("both accepted for linear elements",
        !refused([&](ParameterHandler &prm) {
          entry("Valve", "Element", "P1")(prm);
          entry("Valve", "Elements around", "84")(prm);
          entry("Valve", "Layers", "3")(prm);
        }));
  check("unknown chorda refused",
        refused(entry("Chordae", "Removed chordae", "R-P1, R-P9")));
  check("missing height refused",
        refused(entry("Chordae", "Secondary heights", "0.45, 0.5")));
  check("tip of two numbers refused",
        refused(entry("Chordae", "Papillary tip", "11, -5")));
  check("unknown hold refused", refused(entry("Valve", "Annulus", "glue")));

  check("leaflet through itself refused",
        refused(entry("Valve", "Anterior height", "60")));
  ValveParameters wrong;
  wrong.removed_chordae = {"R-P9"};
  std::string message;
  try
    {
      const Leaflet leaflet = generate_leaflet(wrong);
      generate_chordae(wrong, leaflet, nodal_mass(leaflet.mesh));
    }
  catch (const InputError &error)
    {
      message = error.what();
    }
  check("message names the chorda, the valid ones and the parameter",
        message.find("R-P9") != std::string::npos &&
          message.find("L-S3") != std::string::npos &&
          message.find("Removed chordae") != std::string::npos &&
          message.find('\n') == std::string::npos);

  ParameterHandler prm;
  ValveParameters::declare_parameters(prm);
  ValveParameters parsed;
  parsed.anterior_height = 0;
  parsed.parse_parameters(prm);
  check_relative("declared default, length",
                 parsed.anterior_height,
                 17.5e-3,
                 1e-12);
  check_relative("declared default, angle",
                 parsed.commissure_angle,
                 ValveParameters().commissure_angle,
                 1e-6);
  check("declared default, lists",
        parsed.primary_angles.size() == 7 && parsed.removed_chordae.empty() &&
          std::abs(parsed.papillary_tip[2] + 30e-3) < 1e-12);
}

void
test_preview(const ValveParameters &valve)
{
  const Leaflet leaflet = generate_leaflet(valve);
  const auto chordae =
    generate_chordae(valve, leaflet, nodal_mass(leaflet.mesh));
  write_valve_preview("preview", leaflet, chordae);
  const auto lines = [](const std::string &name) {
    std::ifstream in("preview/" + name);
    unsigned int n = 0;
    for (std::string line; std::getline(in, line);)
      ++n;
    return n;
  };
  check("chordae.csv", lines("chordae.csv") == 21, lines("chordae.csv"));
  check("columns.csv", lines("columns.csv") == 84 * 14 + 1);
  check("valve.vtu", lines("valve.vtu") > 4 * 84 * 13 * 10);
  check("chordae.vtu", lines("chordae.vtu") > 2 * 20 * 3);
  std::filesystem::remove_all("preview");
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ValveParameters valve = linear_valve();
  test_shape(valve);
  test_mesh("two layers:", generate_leaflet(valve));
  valve.n_layers    = 3;
  valve.n_root_rows = 2;
  test_mesh("three layers:", generate_leaflet(valve));
  valve = linear_valve();
  test_labels(valve, generate_leaflet(valve));
  test_pinned(valve);
  test_fibres(valve);
  test_chordae(valve);
  test_input();
  test_preview(valve);
}
