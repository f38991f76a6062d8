// The generated valve with elements of ten nodes: every node is in use, each
// face belongs to two elements or the surface, the first parts are at the
// vertices, the nodes of edges lie between those of their ends, and the parts
// in the quadrilateral they name.

#include <coapt/geometry/quadratic_mesh.h>
#include <coapt/geometry/valve_generator.h>

#include "geometry/mesh_checks.h"

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ValveParameters valve;
  valve.n_circumferential = 40;
  const Leaflet leaflet   = generate_leaflet(valve);
  const auto &mesh        = leaflet.mesh;
  test_mesh("parts of quadratic elements:", leaflet);
  check("sizes with quadratic elements",
        mesh.quadratic_cells.size() == 20 * 7 * 6 &&
          mesh.cells.size() == 8 * mesh.quadratic_cells.size() &&
          leaflet.cell_quad.size() == mesh.cells.size() &&
          mesh.n_elements() == mesh.quadratic_cells.size());

  std::vector<bool> used(mesh.points.size(), false);
  std::map<std::array<unsigned int, 3>, unsigned int> faces;
  bool at_vertices = true;
  double off       = 0;
  for (unsigned int i = 0; i < mesh.quadratic_cells.size(); ++i)
    {
      const auto &nodes = mesh.quadratic_cells[i];
      for (const unsigned int node : nodes)
        used[node] = true;
      for (unsigned int a = 0; a < 4; ++a)
        {
          const auto &part = mesh.cells[8 * i + a];
          at_vertices      = at_vertices &&
            std::find(part.begin(), part.end(), nodes[a]) != part.end();
          std::array<unsigned int, 3> face;
          std::remove_copy(nodes.begin(),
                           nodes.begin() + 4,
                           face.begin(),
                           nodes[a]);
          std::sort(face.begin(), face.end());
          ++faces[face];
        }
      for (unsigned int e = 0; e < 6; ++e)
        {
          const Point<3> &a = mesh.points[nodes[tetrahedron_edges[e][0]]];
          const Point<3> &b = mesh.points[nodes[tetrahedron_edges[e][1]]];
          const auto middle = 0.5 * (a + b);
          off               = std::max(off,
                         middle.distance(mesh.points[nodes[4 + e]]) /
                           a.distance(b));
        }
    }
  check("every node is in use",
        std::all_of(used.begin(), used.end(), [](const bool u) { return u; }));
  check("the first parts are at the vertices", at_vertices);
  // At a quarter of the edge, the map of the element begins to fold.
  check("nodes of edges are near their middles", off < 0.25, off);
  unsigned int outside = 0, most = 0;
  for (const auto &face : faces)
    {
      outside += face.second == 1;
      most = std::max(most, face.second);
    }
  check("quadratic elements conform",
        most == 2 && outside == 2 * (2 * 20 * 7 + 2 * 20),
        outside);

  unsigned int elsewhere = 0;
  for (unsigned int c = 0; c < mesh.cells.size(); ++c)
    for (const unsigned int node : mesh.cells[c])
      {
        const auto &quad = leaflet.quads[leaflet.cell_quad[c]];
        elsewhere +=
          std::none_of(quad.begin(), quad.end(), [&](const unsigned int q) {
            const auto &column = leaflet.columns[q];
            return std::find(column.begin(), column.end(), node) !=
              column.end();
          });
      }
  check("parts are in their quadrilaterals", elsewhere == 0, elsewhere);
}
