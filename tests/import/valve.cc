// Valves from files: surfaces, thickness, chordae that branch, and what is
// wrong with files.

#include <coapt/chordae/chordae_network.h>
#include <coapt/geometry/boundary_faces.h>
#include <coapt/import/fibres.h>
#include <coapt/import/imported_valve.h>
#include <coapt/import/thicken.h>
#include <coapt/solid/solid_operator.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::string folder = SOURCE_DIR;

  std::string
  content(const std::string &file)
  {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  /** The text of a file of the tube with @p old replaced, in a file of the same
   * name here, whose name is returned. */
  std::string
  changed(const std::string &name,
          const std::string &old,
          const std::string &by)
  {
    std::string text        = content(folder + "/" + name);
    const std::size_t where = text.find(old);
    if (where == std::string::npos)
      throw std::runtime_error(name + " does not contain " + old);
    text.replace(where, old.size(), by);
    std::ofstream(name) << text;
    return name;
  }

  bool
  says(const std::string &text, const std::string &part)
  {
    if (text.find(part) == std::string::npos)
      std::cout << text << std::endl;
    return text.find(part) != std::string::npos;
  }

  double
  area(const SurfaceMesh &mesh)
  {
    double sum = 0;
    for (const auto &t : triangulate(mesh.quads))
      sum += 0.5 *
        cross_product_3d(mesh.points[t[1]] - mesh.points[t[0]],
                         mesh.points[t[2]] - mesh.points[t[0]])
          .norm();
    return sum;
  }

  /** Whether neighbours follow their common edges in opposite directions. */
  bool
  is_oriented(const SurfaceMesh &mesh)
  {
    using Way = std::array<unsigned int, 2>;
    std::set<Way> ways;
    for (const auto &quad : mesh.quads)
      for (unsigned int c = 0; c < 4; ++c)
        if (!ways.insert(Way{{quad[c], quad[(c + 1) % 4]}}).second)
          return false;
    return true;
  }

  void
  surfaces()
  {
    const SurfaceMesh tube = read_surface_mesh(folder + "/tube.msh", 1e-3);
    check("quadrilaterals, numbers",
          tube.points.size() == 80 && tube.quads.size() == 64 &&
            tube.n_elements == 64 && tube.n_vertices == 80);
    check("quadrilaterals, vertices keep their numbers",
          tube.points[1].distance(Point<3>(9.2388e-3, 3.8268e-3, 0)) < 1e-9);
    check("quadrilaterals, labels",
          std::count(tube.labels.begin(), tube.labels.end(), 1) == 32 &&
            std::count(tube.labels.begin(), tube.labels.end(), 2) == 32);
    check("quadrilaterals, boundary", boundary_edges(tube.quads).size() == 32);

    // One quadrilateral goes round the other way.
    const SurfaceMesh turned = read_surface_mesh(
      changed("tube.msh", "2 3 2 1 1 2 18 19 3", "2 3 2 1 1 2 3 19 18"), 1e-3);
    check("quadrilaterals, sense of rotation", is_oriented(turned));

    // A square of two triangles and a quadrilateral beside it.
    std::ofstream("mixed.msh")
      << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n"
      << "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n6 2 1 0\n$EndNodes\n"
      << "$Elements\n3\n1 2 2 7 7 1 2 3\n2 2 2 7 7 1 3 4\n"
      << "3 3 2 8 8 2 5 6 3\n$EndElements\n";
    const SurfaceMesh mixed = read_surface_mesh("mixed.msh", 1);
    check("triangles, cut into quadrilaterals",
          mixed.quads.size() == 10 && mixed.n_elements == 3 &&
            is_oriented(mixed));
    check_relative("triangles, area", area(mixed), 2, 1e-12);
    check("triangles, they fit", boundary_edges(mixed.quads).size() == 12);
  }

  void
  thickness()
  {
    // A flat, distorted sheet: the volume is exact.
    SurfaceMesh sheet;
    const unsigned int n = 5;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double inner = i > 0 && i < n && j > 0 && j < n ? 0.2 : 0.;
          sheet.points.emplace_back(i + inner * std::sin(7. * i + j),
                                    j + inner * std::cos(3. * j + i),
                                    0.);
        }
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        sheet.quads.push_back({{j * (n + 1) + i,
                                j * (n + 1) + i + 1,
                                (j + 1) * (n + 1) + i + 1,
                                (j + 1) * (n + 1) + i}});
    const Leaflet leaflet = thicken(sheet.points, sheet.quads, 0.3, 2);
    double volume = 0, least = 1;
    for (const auto &cell : leaflet.mesh.cells)
      {
        const Point<3> &o = leaflet.mesh.points[cell[0]];
        const double part = cross_product_3d(leaflet.mesh.points[cell[1]] - o,
                                             leaflet.mesh.points[cell[2]] - o) *
          (leaflet.mesh.points[cell[3]] - o) / 6;
        volume += part;
        least = std::min(least, part);
      }
    check("thickness, tetrahedra",
          leaflet.mesh.cells.size() == 6 * 2 * n * n && least > 0,
          least);
    check_relative("thickness, volume", volume, 0.3 * n * n, 1e-12);
    // Both faces, and four sides of two layers: nothing else is exposed.
    check("thickness, tetrahedra fit",
          boundary_faces<3>(leaflet.mesh.cells).size() ==
            2 * (2 * n * n) + 2 * 2 * (4 * n));
    check("thickness, last nodes on the side of the normal",
          leaflet.mesh.points[leaflet.columns[8].back()][2] > 0.149);
  }

  ImportParameters
  tube_parameters()
  {
    ImportParameters parameters;
    parameters.is_wanted  = true;
    parameters.mesh       = folder + "/tube.msh";
    parameters.held_nodes = folder + "/held.csv";
    parameters.chordae    = folder + "/chordae.csv";
    parameters.regions    = {{1, Region::anterior}, {2, Region::posterior}};
    return parameters;
  }

  ImportedValve
  tube(const ImportParameters &parameters)
  {
    ValveParameters valve;
    valve.thickness                  = 0.8e-3;
    valve.circumferential_prestretch = valve.radial_prestretch = 1;
    valve.annulus_hold = AnnulusHold::clamped;
    return ImportedValve(parameters, valve, 1000, "");
  }

  void
  leaflets()
  {
    const ImportedValve valve = tube(tube_parameters());
    const Leaflet &leaflet    = valve.leaflet();
    double outward = 1, tilt = 0;
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      {
        const Point<3> x = leaflet.mesh.points[leaflet.columns[c].front()];
        const Tensor<1, 3> n =
          leaflet.mesh.points[leaflet.columns[c].back()] - x;
        outward = std::min(outward, (n[0] * x[0] + n[1] * x[1]) / 1e-6);
      }
    for (const auto &fibre : leaflet.fibre)
      tilt = std::max(tilt, std::abs(fibre[2]));
    check("leaflets, ventricular side is outside", outward > 0, outward);
    check("leaflets, fibres parallel to the annulus", tilt < 1e-12, tilt);
    check("leaflets, lines",
          leaflet.annulus_columns.size() == 16 &&
            leaflet.free_edge_columns.size() == 16);
    check("leaflets, coordinates",
          leaflet.column_coordinates[0][1] == 0 &&
            leaflet.column_coordinates[79][1] == 1 &&
            std::abs(leaflet.column_coordinates[32][1] - 0.5) < 1e-4);
    check("leaflets, held nodes",
          leaflet.held_sets.at("annulus").size() == 16 * 3 &&
            leaflet.held_sets.at("papillary").size() == 2 &&
            std::count(leaflet.pinned.begin(), leaflet.pinned.end(), true) ==
              50);
    check_relative("leaflets, extents of the annulus",
                   valve.semi_axes()[0],
                   10e-3,
                   1e-12);
  }

  void
  chordae()
  {
    const ImportedValve valve = tube(tube_parameters());
    const Leaflet &leaflet    = valve.leaflet();
    SolidParameters solid;
    solid.material = "neo-Hookean";
    const SolidOperator<3> tissue(leaflet.mesh,
                                  solid,
                                  leaflet.fibre,
                                  leaflet.prestretch,
                                  MPI_COMM_WORLD,
                                  {},
                                  leaflet.chordae_mass);
    const std::vector<Chorda> strings = valve.chordae(tissue.mass());
    check("chordae, segments become strings", strings.size() == 10);
    const auto trunk =
      std::find_if(strings.begin(), strings.end(), [](const auto &c) {
        return c.id == "100-102";
      });
    check("chordae, trunk", trunk != strings.end());
    const Point<3> a(0.6629, 3.3327, -30), b(0.7955, 3.9992, -26),
      c(0.9281, 4.6658, -21);
    const double length = 1e-3 * (a.distance(b) + b.distance(c));
    check_relative("chordae, length of the trunk",
                   trunk->rest_length,
                   length,
                   1e-9);
    check("chordae, the trunk hangs on the anterior leaflet",
          trunk->chorda_class == ChordaClass::anterior_secondary);

    // Half of the trunk and of four branches, half as thick.
    double mass = 1e-3 * dealii::numbers::PI_4 * length;
    for (const Point<3> &end : {Point<3>(5.3033, 5.3033, -12),
                                Point<3>(2.8701, 6.9291, -12),
                                Point<3>(0, 7.5, -12),
                                Point<3>(-2.8701, 6.9291, -12)})
      mass += 0.25e-3 * dealii::numbers::PI_4 * 1e-3 * c.distance(end);
    check_relative("chordae, mass of the branching",
                   tissue.mass()[trunk->nodes[0]],
                   mass / 2,
                   1e-9);

    // The trunks pulled by 0.3 mm.
    const ChordaeNetwork network(strings, tissue.mass(), 0., 0.2);
    std::vector<double> X, F;
    for (const auto &x : leaflet.mesh.points)
      X.insert(X.end(), {x[0], x[1], x[2]});
    for (const unsigned int node : leaflet.held_sets.at("papillary"))
      X[3 * node + 2] -= 0.3e-3;
    X[3 * trunk->nodes[0] + 2] -= 0.15e-3;
    F.assign(X.size(), 0.);
    const std::vector<double> V(X.size(), 0.);
    network.add_forces(1., X.data(), V.data(), F.data(), 0, 1);
    Tensor<1, 3> sum;
    double largest = 0, work = 0;
    for (unsigned int i = 0; i < F.size(); ++i)
      {
        sum[i % 3] += F[i];
        largest = std::max(largest, std::abs(F[i]));
      }
    check("chordae, forces balance",
          largest > 0.1 && sum.norm() < 1e-12 * largest,
          sum.norm());
    // The force is the derivative of the energy.
    std::vector<double> Y = X;
    for (unsigned int i = 0; i < Y.size(); ++i)
      {
        const double way = 1e-8 * std::sin(0.7 * i);
        Y[i] += way;
        work += way * F[i];
        X[i] -= way;
      }
    check_relative("chordae, forces from the energy",
                   network.elastic_energy(1., X.data()) -
                     network.elastic_energy(1., Y.data()),
                   2 * work,
                   1e-4);
    const double k = network.max_frequency();
    check("chordae, frequency at least that of the trunk",
          k >= std::sqrt(trunk->modulus * dealii::numbers::PI_4 * 1e-6 /
                         length / tissue.mass()[trunk->nodes[0]]),
          k);
  }

  std::string
  refusal(const std::function<void(ImportParameters &)> &change)
  {
    ImportParameters parameters = tube_parameters();
    change(parameters);
    return error_of([&]() { tube(parameters); });
  }

  void
  wrong_meshes()
  {
    const auto mesh = [](const std::string &old, const std::string &by) {
      return refusal(
        [&](ImportParameters &p) { p.mesh = changed("tube.msh", old, by); });
    };
    check("refuses a node without element",
          says(mesh("$Nodes\n80\n", "$Nodes\n81\n81 1 1 1\n"),
               "1 of 81 nodes belong to no element"));
    check("refuses what is no mesh",
          says(mesh("$MeshFormat", "$Format"), "is no surface"));
    check("refuses an unlabelled element",
          says(mesh("2 3 2 1 1 2 18", "2 3 2 4 4 2 18"),
               "no region for the label 4 of element 2"));
    check("refuses a third element at an edge",
          says(mesh("64\n1 3 2", "65\n65 3 2 1 1 1 17 40 35\n1 3 2"),
               "belongs to 3 elements"));
  }

  void
  wrong_tables()
  {
    const auto held = [](const std::string &old, const std::string &by) {
      return refusal([&](ImportParameters &p) {
        p.held_nodes = changed("held.csv", old, by);
      });
    };
    check("refuses a missing column",
          says(held("chordae_node", "node"), "column chordae_node is missing"));
    check("refuses a vertex beyond the mesh",
          says(held("annulus,3,", "annulus,300,"),
               "line 5: there is no vertex"));
    check("refuses an annulus inside",
          says(held("annulus,3,", "annulus,20,"), "vertex 20 of the annulus"));
    check("refuses a number that is none",
          says(held("annulus,3,", "annulus,three,"),
               "line 5, column vertex: 'three'"));

    const auto chordae = [](const std::string &old, const std::string &by) {
      return refusal([&](ImportParameters &p) {
        p.chordae = changed("chordae.csv", old, by);
      });
    };
    check(
      "refuses chordae that end nowhere",
      says(chordae("-1,66,", "-1,-1,"),
           "1 nodes are attached to nothing: they end one segment, but have "
           "no vertex and are not held: 103 at (5.3033 5.3033 -12) mm"));
    check("refuses a wrong vertex",
          says(chordae("-1,66,", "-1,60,"), "mm away from vertex 60"));
    check("refuses chordae without a diameter",
          says(chordae("-1,-1,1.0", "-1,-1,0"), "both must be positive"));
    check("refuses a node at two places",
          says(chordae("-26,0.9281", "-25,0.9281"), "another position"));
    check("refuses held nodes that are none",
          says(held("-1,200", "-1,300"), "there is no node 300"));
  }

  void
  wrong_fibres()
  {
    const SurfaceMesh mesh = read_surface_mesh(folder + "/tube.msh", 1e-3);
    const auto with        = [&](const std::string &fifth) {
      std::ofstream out("fibres.csv");
      out << "fx,fy,fz\n";
      for (unsigned int i = 0; i < 64; ++i)
        out << (i == 4 ? fifth : "0,0,1") << '\n';
      out.close();
      return error_of([&]() { read_fibres("fibres.csv", mesh); });
    };
    check("fibres, accepted", with("0,0,-2") == "none");
    check("refuses a fibre of length zero",
          says(with("0,0,0"), "fibres.csv, line 6: the fibre is zero"));
    check("refuses a fibre across the leaflet",
          says(with("-0.7,0.7,0"), "degrees away from the tangential plane"));
    check("refuses a fibre that is no number",
          says(with("0,nan,0"), "line 6, column fy: 'nan'"));
    std::ofstream("fibres.csv") << "fx,fy,fz\n0,0,1\n";
    check("refuses too few fibres",
          says(error_of([&]() { read_fibres("fibres.csv", mesh); }),
               "1 fibres are given for 64 elements"));
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  surfaces();
  thickness();
  leaflets();
  chordae();
  wrong_meshes();
  wrong_tables();
  wrong_fibres();
}
