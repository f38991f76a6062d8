#include <coapt/import/thicken.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    std::vector<Tensor<1, 3>>
    normals_at(const std::vector<Point<3>> &points,
               const std::vector<std::array<unsigned int, 4>> &quads)
    {
      std::vector<Tensor<1, 3>> normals(points.size());
      for (const auto &quad : quads)
        {
          const Tensor<1, 3> normal =
            cross_product_3d(points[quad[2]] - points[quad[0]],
                             points[quad[3]] - points[quad[1]]);
          for (const unsigned int corner : quad)
            normals[corner] += normal;
        }
      for (Tensor<1, 3> &normal : normals)
        normal /= normal.norm();
      return normals;
    }

    /** Whether an odd number of swaps sorts three numbers. */
    bool
    is_odd(const std::array<unsigned int, 3> &t)
    {
      return ((t[0] > t[1]) + (t[0] > t[2]) + (t[1] > t[2])) % 2 == 1;
    }

    /** Adds the tetrahedra of all layers on a triangle of the quadrilateral
     * @p q. */
    void
    add_prisms(std::array<unsigned int, 3> triangle,
               const unsigned int q,
               Leaflet &leaflet)
    {
      const bool mirrored = is_odd(triangle);
      std::sort(triangle.begin(), triangle.end());
      const auto &a = leaflet.columns[triangle[0]],
                 &b = leaflet.columns[triangle[1]],
                 &c = leaflet.columns[triangle[2]];
      for (unsigned int k = 0; k + 1 < a.size(); ++k)
        for (std::array<unsigned int, 4> cell :
             {std::array<unsigned int, 4>{{a[k], b[k], c[k], c[k + 1]}},
              std::array<unsigned int, 4>{{a[k], b[k], c[k + 1], b[k + 1]}},
              std::array<unsigned int, 4>{
                {a[k], a[k + 1], b[k + 1], c[k + 1]}}})
          {
            if (mirrored)
              std::swap(cell[2], cell[3]);
            leaflet.mesh.cells.push_back(cell);
            leaflet.cell_quad.push_back(q);
          }
    }
  } // namespace



  Leaflet
  thicken(const std::vector<Point<3>> &points,
          const std::vector<std::array<unsigned int, 4>> &quads,
          const double thickness,
          const unsigned int n_layers)
  {
    Leaflet leaflet;
    leaflet.thickness  = thickness;
    leaflet.quads      = quads;
    const auto normals = normals_at(points, quads);
    for (unsigned int c = 0; c < points.size(); ++c)
      {
        std::vector<unsigned int> column;
        for (unsigned int k = 0; k <= n_layers; ++k)
          {
            column.push_back(leaflet.mesh.points.size());
            leaflet.mesh.points.push_back(
              points[c] +
              thickness * (double(k) / n_layers - 0.5) * normals[c]);
          }
        leaflet.columns.push_back(column);
      }
    for (unsigned int q = 0; q < quads.size(); ++q)
      for (const auto &triangle : triangulate({quads[q]}))
        add_prisms(triangle, q, leaflet);
    return leaflet;
  }
} // namespace coapt
