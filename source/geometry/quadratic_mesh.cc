#include <coapt/geometry/quadratic_mesh.h>

#include <algorithm>
#include <map>

namespace coapt
{
  namespace
  {
    /** Appends the element with these @p nodes and its linear @p parts. */
    template <int dim, std::size_t n_nodes, std::size_t n_parts>
    void
    add_cell(const std::array<unsigned int, n_nodes> &nodes,
             const unsigned int (&parts)[n_parts][dim + 1],
             SimplexMesh<dim> &mesh)
    {
      mesh.quadratic_cells.push_back(nodes);
      for (const auto &part : parts)
        {
          mesh.cells.emplace_back();
          for (unsigned int a = 0; a <= dim; ++a)
            mesh.cells.back()[a] = nodes[part[a]];
        }
    }
  } // namespace



  void
  add_quadratic_cell(const std::array<unsigned int, 6> &nodes,
                     SimplexMesh<2> &mesh)
  {
    constexpr unsigned int parts[4][3] = {{0, 3, 4},
                                          {3, 1, 5},
                                          {4, 5, 2},
                                          {3, 5, 4}};
    add_cell<2>(nodes, parts, mesh);
  }



  void
  add_quadratic_cell(const std::array<unsigned int, 10> &nodes,
                     SimplexMesh<3> &mesh)
  {
    constexpr unsigned int parts[8][4] = {{0, 4, 5, 6},
                                          {4, 1, 7, 8},
                                          {5, 7, 2, 9},
                                          {6, 8, 9, 3},
                                          {4, 5, 6, 8},
                                          {4, 7, 5, 8},
                                          {5, 6, 8, 9},
                                          {5, 7, 9, 8}};
    add_cell<3>(nodes, parts, mesh);
  }



  SimplexMesh<3>
  quadratic_mesh(const SimplexMesh<3> &linear)
  {
    SimplexMesh<3> mesh;
    mesh.points = linear.points;
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> middle;
    for (const auto &cell : linear.cells)
      {
        std::array<unsigned int, 10> nodes;
        std::copy(cell.begin(), cell.end(), nodes.begin());
        for (unsigned int e = 0; e < 6; ++e)
          {
            const auto ends = std::minmax(cell[tetrahedron_edges[e][0]],
                                          cell[tetrahedron_edges[e][1]]);
            const auto [place, is_new] =
              middle.emplace(ends, mesh.points.size());
            if (is_new)
              mesh.points.push_back(
                0.5 * (mesh.points[ends.first] + mesh.points[ends.second]));
            nodes[4 + e] = place->second;
          }
        add_quadratic_cell(nodes, mesh);
      }
    return mesh;
  }
} // namespace coapt
