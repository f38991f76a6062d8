#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <coapt/base/exceptions.h>
#include <coapt/import/surface_mesh.h>

#include <fstream>
#include <map>
#include <queue>
#include <sstream>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    using Edge = std::array<unsigned int, 2>;

    /** Both ends, the lower number first. */
    Edge
    edge(const unsigned int a, const unsigned int b)
    {
      return {{std::min(a, b), std::max(a, b)}};
    }

    /** Sides of each edge: quadrilaterals, and whether they follow it from the
     * lower number to the higher. */
    using Sides = std::map<Edge, std::vector<std::pair<unsigned int, bool>>>;

    Sides
    sides_of_edges(const std::vector<std::array<unsigned int, 4>> &quads)
    {
      Sides sides;
      for (unsigned int q = 0; q < quads.size(); ++q)
        for (unsigned int c = 0; c < 4; ++c)
          {
            const unsigned int a = quads[q][c], b = quads[q][(c + 1) % 4];
            sides[edge(a, b)].emplace_back(q, a < b);
          }
      return sides;
    }

    /** Refuses versions of the format that are not understood here, whose
     * sections have other contents; a file without "$MeshFormat" is of version
     * 1 or none of Gmsh's, which is found out later. */
    void
    check_format(const std::string &file)
    {
      std::ifstream stream(file);
      std::string word, version;
      while (stream >> word && word != "$MeshFormat")
        ;
      int is_binary = 0;
      if (!(stream >> version >> is_binary))
        return;
      if (version.substr(0, 2) == "2." && !is_binary)
        return;
      throw InputError(file + ": is in Gmsh's format " + version +
                       (is_binary ? ", binary" : "") +
                       "; understood is 2.2, ASCII (gmsh -save -format msh22)");
    }

    /** Number of nodes that the file announces. */
    unsigned int
    announced_nodes(const std::string &file)
    {
      std::ifstream stream(file);
      for (std::string word; stream >> word;)
        if (word == "$Nodes" || word == "$NOD")
          {
            unsigned int n = 0;
            stream >> n;
            return n;
          }
      return 0;
    }

    void
    read_with_gridin(const std::string &file,
                     dealii::Triangulation<2, 3> &triangulation)
    {
      std::ifstream stream(file);
      if (!stream)
        throw InputError(file + ": cannot be opened");
      check_format(file);
      try
        {
          dealii::GridIn<2, 3> grid_in(triangulation);
          grid_in.read_msh(stream);
        }
      catch (const dealii::ExceptionBase &exception)
        {
          throw InputError(file +
                           ": is no surface of quadrilaterals or "
                           "triangles in Gmsh's format 2.2, ASCII (" +
                           exception.get_exc_name() + ")");
        }
      const unsigned int n = announced_nodes(file);
      if (n != triangulation.n_vertices())
        throw InputError(
          file + ": " + std::to_string(n - triangulation.n_vertices()) +
          " of " + std::to_string(n) + " nodes belong to no element");
    }

    /** Cuts elements into quadrilaterals between corners, middles of edges and
     * the centre. */
    class Cutter
    {
    public:
      explicit Cutter(SurfaceMesh &mesh) : mesh(mesh)
      {
      }

      void
      add(const std::vector<unsigned int> &corners,
          const int label,
          const unsigned int element)
      {
        const unsigned int n = corners.size();
        Point<3> centre;
        for (const unsigned int corner : corners)
          centre += mesh.points[corner] / n;
        const unsigned int middle = new_vertex(centre, {{0, 0}});
        for (unsigned int c = 0; c < n; ++c)
          {
            mesh.quads.push_back(
              {{corners[c],
                middle_of(corners[c], corners[(c + 1) % n]),
                middle,
                middle_of(corners[c], corners[(c + n - 1) % n])}});
            mesh.labels.push_back(label);
            mesh.elements.push_back(element);
          }
      }

    private:
      unsigned int
      new_vertex(const Point<3> &x, const Edge &ends)
      {
        mesh.points.push_back(x);
        mesh.added_vertices.push_back(ends);
        return mesh.points.size() - 1;
      }

      unsigned int
      middle_of(const unsigned int a, const unsigned int b)
      {
        const auto found = middles.find(edge(a, b));
        if (found != middles.end())
          return found->second;
        return middles[edge(a, b)] =
                 new_vertex(mesh.points[a] +
                              0.5 * (mesh.points[b] - mesh.points[a]),
                            edge(a, b));
      }

      SurfaceMesh &mesh;
      std::map<Edge, unsigned int> middles;
    };

    void
    add_elements(const dealii::Triangulation<2, 3> &triangulation,
                 SurfaceMesh &mesh)
    {
      const bool only_quads =
        triangulation.all_reference_cells_are_hyper_cube();
      Cutter cutter(mesh);
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          std::vector<unsigned int> corners;
          for (const unsigned int v : cell->vertex_indices())
            corners.push_back(cell->vertex_index(v));
          if (corners.size() == 4)
            std::swap(corners[2], corners[3]); // deal.II's are lexicographic
          const int label = cell->material_id();
          if (only_quads)
            {
              mesh.quads.push_back(
                {{corners[0], corners[1], corners[2], corners[3]}});
              mesh.labels.push_back(label);
              mesh.elements.push_back(mesh.n_elements);
            }
          else
            cutter.add(corners, label, mesh.n_elements);
          ++mesh.n_elements;
        }
    }

    std::string
    place(const Point<3> &x)
    {
      std::ostringstream text;
      text << '(' << 1e3 * x << ") mm";
      return text.str();
    }

    /** Turns quadrilaterals so that two neighbours follow their edge in
     * opposite directions. */
    void
    orient(SurfaceMesh &mesh, const std::string &file)
    {
      const Sides sides = sides_of_edges(mesh.quads);
      std::vector<std::vector<std::pair<unsigned int, bool>>> neighbours(
        mesh.quads.size()); // and whether one of the two must turn
      for (const auto &[ends, of_edge] : sides)
        {
          if (of_edge.size() > 2)
            throw InputError(file + ": the edge from " +
                             place(mesh.points[ends[0]]) + " to " +
                             place(mesh.points[ends[1]]) + " belongs to " +
                             std::to_string(of_edge.size()) +
                             " elements; at most two are possible");
          if (of_edge.size() < 2)
            continue;
          const bool turn = of_edge[0].second == of_edge[1].second;
          neighbours[of_edge[0].first].emplace_back(of_edge[1].first, turn);
          neighbours[of_edge[1].first].emplace_back(of_edge[0].first, turn);
        }

      std::vector<int> turned(mesh.quads.size(), -1); // unknown
      for (unsigned int start = 0; start < mesh.quads.size(); ++start)
        {
          if (turned[start] >= 0)
            continue;
          turned[start] = 0;
          std::queue<unsigned int> waiting({start});
          for (; !waiting.empty(); waiting.pop())
            for (const auto &[next, turn] : neighbours[waiting.front()])
              {
                const int wanted = turned[waiting.front()] ^ turn;
                if (turned[next] >= 0 && turned[next] != wanted)
                  throw InputError(file + ": the surface has one side only");
                if (turned[next] < 0)
                  waiting.push(next);
                turned[next] = wanted;
              }
        }
      for (unsigned int q = 0; q < mesh.quads.size(); ++q)
        if (turned[q] == 1)
          std::swap(mesh.quads[q][1], mesh.quads[q][3]);
    }
  } // namespace



  std::vector<std::array<unsigned int, 2>>
  boundary_edges(const std::vector<std::array<unsigned int, 4>> &quads)
  {
    std::vector<Edge> result;
    for (const auto &[ends, of_edge] : sides_of_edges(quads))
      if (of_edge.size() == 1)
        result.push_back(ends);
    return result;
  }



  SurfaceMesh
  read_surface_mesh(const std::string &file, const double unit)
  {
    dealii::Triangulation<2, 3> triangulation;
    read_with_gridin(file, triangulation);
    SurfaceMesh mesh;
    for (const Point<3> &x : triangulation.get_vertices())
      mesh.points.push_back(unit * x);
    mesh.n_vertices = mesh.points.size();
    add_elements(triangulation, mesh);
    orient(mesh, file);
    return mesh;
  }
} // namespace coapt
