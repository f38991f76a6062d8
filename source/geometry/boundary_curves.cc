#include <coapt/geometry/boundary_curves.h>
#include <coapt/geometry/boundary_faces.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    const double cosine_of_corner = std::sqrt(0.75); // 30 degrees

    /** Goes around the boundary edge by edge. */
    class Walk
    {
    public:
      explicit Walk(const SimplexMesh<2> &mesh) : mesh(mesh)
      {
        for (const BoundaryFace<2> &face : boundary_faces<2>(mesh.cells))
          {
            for (const unsigned int node : face.nodes)
              edges_at[node].push_back(faces.size());
            faces.push_back(face);
          }
        used.assign(faces.size(), false);
      }

      /** The nodes where curves begin, best ones first: corners, then in the
       * order of falling x. */
      std::vector<unsigned int>
      starts() const
      {
        std::vector<unsigned int> nodes;
        for (const auto &[node, edges] : edges_at)
          nodes.push_back(node);
        std::stable_sort(nodes.begin(), nodes.end(), [&](auto a, auto b) {
          return mesh.points[a][0] > mesh.points[b][0];
        });
        std::stable_partition(nodes.begin(), nodes.end(), [&](auto node) {
          return is_corner(node);
        });
        return nodes;
      }

      /** The curve from @p node along an edge that no curve has; without edges
       * if there is none. */
      BoundaryCurve
      curve_from(const unsigned int node)
      {
        BoundaryCurve curve;
        unsigned int at = node;
        for (int next = unused_at(at); next >= 0; next = unused_at(at))
          {
            used[next]                 = true;
            const BoundaryFace<2> face = faces[next];
            BoundaryCurve::Edge edge{face.cell, face.vertices, 0.};
            if (mesh.cells[face.cell][edge.vertices[0]] != at)
              std::swap(edge.vertices[0], edge.vertices[1]);
            const unsigned int end = mesh.cells[face.cell][edge.vertices[1]];
            edge.length            = mesh.points[at].distance(mesh.points[end]);
            curve.length += edge.length;
            curve.edges.push_back(edge);
            at = end;
            if (is_corner(at))
              break;
          }
        curve.closed = at == node && !is_corner(node);
        return curve;
      }

    private:
      bool
      is_corner(const unsigned int node) const
      {
        const auto &edges = edges_at.at(node);
        if (edges.size() != 2)
          return true;
        Tensor<1, 2> away[2];
        for (unsigned int i = 0; i < 2; ++i)
          {
            const auto &nodes        = faces[edges[i]].nodes;
            const unsigned int other = nodes[0] == node ? nodes[1] : nodes[0];
            away[i]                  = mesh.points[other] - mesh.points[node];
            away[i] /= away[i].norm();
          }
        return -(away[0] * away[1]) < cosine_of_corner;
      }

      int
      unused_at(const unsigned int node) const
      {
        for (const unsigned int edge : edges_at.at(node))
          if (!used[edge])
            return edge;
        return -1;
      }

      const SimplexMesh<2> &mesh;
      std::vector<BoundaryFace<2>> faces;
      std::map<unsigned int, std::vector<unsigned int>> edges_at; // of a node
      std::vector<bool> used;
    };
  } // namespace



  std::vector<BoundaryCurve>
  boundary_curves(const SimplexMesh<2> &mesh)
  {
    Walk walk(mesh);
    std::vector<BoundaryCurve> curves;
    for (const unsigned int node : walk.starts())
      for (BoundaryCurve curve = walk.curve_from(node); !curve.edges.empty();
           curve               = walk.curve_from(node))
        curves.push_back(curve);
    return curves;
  }
} // namespace coapt
