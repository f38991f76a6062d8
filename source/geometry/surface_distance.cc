#include <coapt/geometry/surface_distance.h>
#include <coapt/geometry/triangle.h>

#include <algorithm>
#include <map>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    template <int dim>
    Point<3>
    in_space(const Point<dim> &x)
    {
      Point<3> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = x[d];
      return result;
    }

    /** A face as a triangle, degenerate in 2D, and a ball that contains it. */
    struct Face
    {
      std::array<Point<3>, 3> corners;
      double radius = 0; // around the first corner

      bool
      is_nearer(const Point<3> &p, const double distance) const
      {
        if (p.distance(corners[0]) >= distance + radius)
          return false;
        double weights[3];
        return p.distance(closest_point_on_triangle(
                 p, corners[0], corners[1], corners[2], weights)) < distance;
      }
    };

    template <int dim>
    std::vector<Face>
    placed_faces(const SimplexMesh<dim> &mesh)
    {
      std::vector<Face> result;
      for (const auto &nodes : surface_faces(mesh))
        {
          Face face;
          for (unsigned int i = 0; i < 3; ++i)
            {
              face.corners[i] = in_space(
                mesh.points[nodes[std::min<unsigned int>(i, dim - 1)]]);
              face.radius = std::max(face.radius,
                                     face.corners[i].distance(face.corners[0]));
            }
          result.push_back(face);
        }
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<std::array<unsigned int, dim>>
  surface_faces(const SimplexMesh<dim> &mesh)
  {
    using Nodes = std::array<unsigned int, dim>;
    std::map<Nodes, std::pair<Nodes, unsigned int>> cells_of_face;
    for (const auto &cell : mesh.cells)
      for (unsigned int opposite = 0; opposite <= dim; ++opposite)
        {
          Nodes nodes;
          for (unsigned int i = 0; i < dim; ++i)
            nodes[i] = cell[i < opposite ? i : i + 1];
          Nodes sorted = nodes;
          std::sort(sorted.begin(), sorted.end());
          auto &face = cells_of_face[sorted];
          face.first = nodes;
          ++face.second;
        }
    std::vector<Nodes> result;
    for (const auto &face : cells_of_face)
      if (face.second.second == 1)
        result.push_back(face.second.first);
    return result;
  }



  template <int dim>
  std::vector<SamplePoint<dim>>
  away_from_surface(const SimplexMesh<dim> &mesh,
                    const std::vector<SamplePoint<dim>> &samples,
                    const double distance)
  {
    const std::vector<Face> faces = placed_faces(mesh);
    std::vector<SamplePoint<dim>> result;
    for (const SamplePoint<dim> &sample : samples)
      {
        Point<dim> x;
        for (unsigned int a = 0; a <= dim; ++a)
          x += sample.barycentric[a] * mesh.points[mesh.cells[sample.cell][a]];
        const Point<3> p = in_space(x);
        if (std::none_of(faces.begin(), faces.end(), [&](const Face &face) {
              return face.is_nearer(p, distance);
            }))
          result.push_back(sample);
      }
    return result;
  }

  template std::vector<std::array<unsigned int, 2>>
  surface_faces<2>(const SimplexMesh<2> &);
  template std::vector<std::array<unsigned int, 3>>
  surface_faces<3>(const SimplexMesh<3> &);
  template std::vector<SamplePoint<2>>
  away_from_surface<2>(const SimplexMesh<2> &,
                       const std::vector<SamplePoint<2>> &,
                       const double);
  template std::vector<SamplePoint<3>>
  away_from_surface<3>(const SimplexMesh<3> &,
                       const std::vector<SamplePoint<3>> &,
                       const double);
} // namespace coapt
