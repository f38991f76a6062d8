#include <coapt/geometry/body_shapes.h>
#include <coapt/geometry/quadratic_mesh.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Number of parts of about this @p size; an even one @p in_pairs. */
    unsigned int
    n_parts(const double length, const double size, const bool in_pairs = false)
    {
      return in_pairs ? 2 * n_parts(length, 2 * size)
                      : std::max(1l, std::lround(length / size));
    }

    /** Unit vectors around @p center at the centroids of the cells. */
    std::vector<Tensor<1, 2>>
    around(const Point<2> &center, const SimplexMesh<2> &mesh)
    {
      std::vector<Tensor<1, 2>> result;
      for (const auto &cell : mesh.cells)
        {
          Tensor<1, 2> r;
          for (const unsigned int node : cell)
            r += (mesh.points[node] - center) / 3.;
          const Tensor<1, 2> turned({-r[1], r[0]});
          result.push_back(turned / turned.norm());
        }
      return result;
    }

    /** The triangle with these nodes in the mathematical sense. */
    void
    add_triangle(SimplexMesh<2> &mesh,
                 const unsigned int a,
                 const unsigned int b,
                 const unsigned int c)
    {
      const Tensor<1, 2> u = mesh.points[b] - mesh.points[a];
      const Tensor<1, 2> v = mesh.points[c] - mesh.points[a];
      if (u[0] * v[1] - u[1] * v[0] > 0)
        mesh.cells.push_back({{a, b, c}});
      else
        mesh.cells.push_back({{a, c, b}});
    }

    /** The triangle of six nodes with these vertices in the mathematical
     * sense. */
    void
    add_triangle(SimplexMesh<2> &mesh,
                 const std::array<unsigned int, 3> &vertices,
                 const std::array<unsigned int, 3> &on_edges)
    {
      const auto edge = [&](const unsigned int i) {
        return mesh.points[vertices[i]] - mesh.points[vertices[0]];
      };
      std::array<unsigned int, 6> nodes = {{vertices[0],
                                            vertices[1],
                                            vertices[2],
                                            on_edges[0],
                                            on_edges[1],
                                            on_edges[2]}};
      if (edge(1)[0] * edge(2)[1] - edge(1)[1] * edge(2)[0] < 0)
        {
          std::swap(nodes[1], nodes[2]);
          std::swap(nodes[3], nodes[4]);
        }
      add_quadratic_cell(nodes, mesh);
    }
  } // namespace



  ShapedBody<2>
  disc_body(const Point<2> &center, const double radius, const double size)
  {
    ShapedBody<2> body;
    SimplexMesh<2> &mesh         = body.mesh;
    const unsigned int n_circles = n_parts(radius, size);
    mesh.points.push_back(center);
    // circle k has 6 k nodes, k of them in each sector of 60 degrees
    const auto node = [](const unsigned int k, const unsigned int i) {
      return k == 0 ? 0 : 1 + 3 * k * (k - 1) + i % (6 * k);
    };
    for (unsigned int k = 1; k <= n_circles; ++k)
      {
        const double r = radius * k / n_circles;
        for (unsigned int i = 0; i < 6 * k; ++i)
          {
            const double angle = std::acos(-1.) * i / (3. * k);
            mesh.points.push_back(
              center +
              Tensor<1, 2>({r * std::cos(angle), r * std::sin(angle)}));
          }
        for (unsigned int sector = 0; sector < 6; ++sector)
          for (unsigned int i = 0; i < k; ++i)
            {
              const unsigned int outer = node(k, sector * k + i);
              const unsigned int next  = node(k, sector * k + i + 1);
              const unsigned int inner = node(k - 1, sector * (k - 1) + i);
              add_triangle(mesh, outer, next, inner);
              if (i + 1 < k)
                add_triangle(mesh,
                             inner,
                             next,
                             node(k - 1, sector * (k - 1) + i + 1));
            }
      }
    body.fibre = around(center, mesh);
    return body;
  }



  ShapedBody<2>
  ring_body(const Point<2> &center,
            const double inner_radius,
            const double width,
            const double size)
  {
    ShapedBody<2> body;
    SimplexMesh<2> &mesh       = body.mesh;
    const double pi            = std::acos(-1.);
    const unsigned int n_width = n_parts(width, size);
    const unsigned int n_around =
      n_parts(2 * pi * (inner_radius + width / 2), size);
    for (unsigned int k = 0; k <= n_width; ++k)
      for (unsigned int i = 0; i < n_around; ++i)
        {
          const double r     = inner_radius + width * k / n_width;
          const double angle = 2 * pi * i / n_around;
          mesh.points.push_back(
            center + Tensor<1, 2>({r * std::cos(angle), r * std::sin(angle)}));
        }
    for (unsigned int k = 0; k < n_width; ++k)
      for (unsigned int i = 0; i < n_around; ++i)
        {
          const unsigned int next = (i + 1) % n_around;
          const unsigned int a = k * n_around + i, b = k * n_around + next;
          const unsigned int c = a + n_around, d = b + n_around;
          // diagonals that alternate prefer no direction
          if ((i + k) % 2 == 0)
            {
              add_triangle(mesh, a, b, d);
              add_triangle(mesh, a, d, c);
            }
          else
            {
              add_triangle(mesh, a, b, c);
              add_triangle(mesh, b, d, c);
            }
        }
    body.fibre = around(center, mesh);
    return body;
  }



  namespace
  {
    /** Position in a strip at @p s along and @p r through it, 0 to 1. */
    template <int dim>
    Point<2>
    strip_point(const StripShape<dim> &shape, const double s, const double r)
    {
      return shape.begin + s * (shape.end - shape.begin) +
        (r - 0.5 + shape.bow / shape.thickness.norm() * 4 * s * (1 - s)) *
        shape.thickness;
    }

    /** The triangles of six nodes of two by two quadrilaterals: their corners
     * begin at @p corner, their middles at @p middle, in rows of @p stride and
     * @p middle_stride. */
    void
    add_block(SimplexMesh<2> &mesh,
              const unsigned int corner,
              const unsigned int stride,
              const unsigned int middle,
              const unsigned int middle_stride)
    {
      const auto at = [&](const unsigned int i, const unsigned int j) {
        return corner + j * stride + i;
      };
      const unsigned int a = middle, b = middle + 1;
      const unsigned int c = middle + middle_stride, d = c + 1;
      add_triangle(mesh, {{at(0, 0), at(2, 0), at(1, 1)}}, {{at(1, 0), a, b}});
      add_triangle(mesh, {{at(2, 0), at(2, 2), at(1, 1)}}, {{at(2, 1), b, d}});
      add_triangle(mesh, {{at(2, 2), at(0, 2), at(1, 1)}}, {{at(1, 2), d, c}});
      add_triangle(mesh, {{at(0, 2), at(0, 0), at(1, 1)}}, {{at(0, 1), c, a}});
    }

    void
    fill(ShapedBody<2> &body,
         const StripShape<2> &shape,
         const unsigned int n_long,
         const unsigned int n_thick,
         const double,
         const bool quadratic)
    {
      SimplexMesh<2> &mesh         = body.mesh;
      const unsigned int n_corners = (n_long + 1) * (n_thick + 1);
      for (unsigned int j = 0; j <= n_thick; ++j)
        for (unsigned int i = 0; i <= n_long; ++i)
          mesh.points.push_back(
            strip_point(shape, double(i) / n_long, double(j) / n_thick));
      for (unsigned int j = 0; j < n_thick; ++j)
        for (unsigned int i = 0; i < n_long; ++i)
          mesh.points.push_back(
            strip_point(shape, (i + 0.5) / n_long, (j + 0.5) / n_thick));
      const Tensor<1, 2> t =
        shape.thickness * (shape.thickness[0] < 0 ? -1 : 1);
      for (unsigned int j = 0; j < n_thick; ++j)
        for (unsigned int i = 0; i < n_long; ++i)
          {
            const unsigned int a = j * (n_long + 1) + i, b = a + 1;
            const unsigned int c = a + n_long + 1, d = c + 1;
            const unsigned int middle = n_corners + j * n_long + i;
            if (!quadratic)
              {
                add_triangle(mesh, a, b, middle);
                add_triangle(mesh, b, d, middle);
                add_triangle(mesh, d, c, middle);
                add_triangle(mesh, c, a, middle);
              }
            else if (i % 2 == 0 && j % 2 == 0)
              add_block(mesh, a, n_long + 1, middle, n_long);
            // the normal (dy, -dx) of an edge is to point as t does
            const auto oriented = [&](const unsigned int p,
                                      const unsigned int q) {
              const Tensor<1, 2> e = mesh.points[q] - mesh.points[p];
              return e[1] * t[0] - e[0] * t[1] > 0
                ? std::array<unsigned int, 2>{{p, q}}
                : std::array<unsigned int, 2>{{q, p}};
            };
            if (j == 0)
              body.lower_face.push_back(oriented(a, b));
            if (j == n_thick - 1)
              body.upper_face.push_back(oriented(c, d));
          }
    }

    /** The node along the axes from the corner @p from of a cube, by bits. */
    std::array<unsigned int, 8>
    corners(const unsigned int from, const std::array<unsigned int, 3> &strides)
    {
      std::array<unsigned int, 8> result;
      for (unsigned int v = 0; v < 8; ++v)
        result[v] = from + (v & 1) * strides[0] + ((v >> 1) & 1) * strides[1] +
          ((v >> 2) & 1) * strides[2];
      return result;
    }

    /** Six tetrahedra along the diagonal of a cube (Freudenthal, 1942). Those
     * of ten nodes need corners of which any two have a node between them,
     * with the mean of their numbers. */
    void
    add_tetrahedra(SimplexMesh<3> &mesh,
                   const std::array<unsigned int, 8> &v,
                   const bool quadratic)
    {
      std::array<unsigned int, 3> path = {{0, 1, 2}};
      do
        {
          const unsigned int first         = 1u << path[0];
          std::array<unsigned int, 4> cell = {
            {v[0], v[first], v[first + (1u << path[1])], v[7]}};
          const auto edge = [&](const unsigned int i) {
            return mesh.points[cell[i]] - mesh.points[cell[0]];
          };
          if (dealii::cross_product_3d(edge(1), edge(2)) * edge(3) < 0)
            std::swap(cell[0], cell[1]);
          if (!quadratic)
            {
              mesh.cells.push_back(cell);
              continue;
            }
          std::array<unsigned int, 10> nodes;
          std::copy(cell.begin(), cell.end(), nodes.begin());
          for (unsigned int e = 0; e < 6; ++e)
            nodes[4 + e] =
              (cell[tetrahedron_edges[e][0]] + cell[tetrahedron_edges[e][1]]) /
              2;
          add_quadratic_cell(nodes, mesh);
      } while (std::next_permutation(path.begin(), path.end()));
    }

    void
    fill(ShapedBody<3> &body,
         const StripShape<3> &shape,
         const unsigned int n_long,
         const unsigned int n_thick,
         const double size,
         const bool quadratic)
    {
      SimplexMesh<3> &mesh       = body.mesh;
      const double height        = shape.z_upper - shape.z_lower;
      const unsigned int n_z     = n_parts(height, size, quadratic);
      const unsigned int layer   = n_long + 1;
      const unsigned int section = layer * (n_thick + 1);
      const std::array<unsigned int, 3> strides = {{1, layer, section}};
      const std::array<unsigned int, 3> doubled = {{2, 2 * layer, 2 * section}};
      for (unsigned int k = 0; k <= n_z; ++k)
        for (unsigned int j = 0; j <= n_thick; ++j)
          for (unsigned int i = 0; i <= n_long; ++i)
            {
              const Point<2> x =
                strip_point(shape, double(i) / n_long, double(j) / n_thick);
              mesh.points.emplace_back(x[0],
                                       x[1],
                                       shape.z_lower + height * k / n_z);
            }
      const double sign = shape.thickness[0] < 0 ? -1 : 1;
      const Tensor<1, 3> t(
        {sign * shape.thickness[0], sign * shape.thickness[1], 0.});
      const auto add_face = [&](auto &face,
                                const unsigned int a,
                                const unsigned int b,
                                const unsigned int c,
                                const unsigned int d) {
        for (auto triangle : {std::array<unsigned int, 3>{{a, b, d}},
                              std::array<unsigned int, 3>{{a, d, c}}})
          {
            const Tensor<1, 3> normal = dealii::cross_product_3d(
              mesh.points[triangle[1]] - mesh.points[triangle[0]],
              mesh.points[triangle[2]] - mesh.points[triangle[0]]);
            if (normal * t < 0)
              std::swap(triangle[0], triangle[1]);
            face.push_back(triangle);
          }
      };
      for (unsigned int k = 0; k < n_z; ++k)
        for (unsigned int j = 0; j < n_thick; ++j)
          for (unsigned int i = 0; i < n_long; ++i)
            {
              const unsigned int from = k * section + j * layer + i;
              const auto v            = corners(from, strides);
              if (!quadratic)
                add_tetrahedra(mesh, v, false);
              else if (i % 2 == 0 && j % 2 == 0 && k % 2 == 0)
                add_tetrahedra(mesh, corners(from, doubled), true);
              if (j == 0)
                add_face(body.lower_face, v[0], v[1], v[4], v[5]);
              if (j == n_thick - 1)
                add_face(body.upper_face, v[2], v[3], v[6], v[7]);
            }
    }
  } // namespace



  template <int dim>
  ShapedBody<dim>
  strip_body(const StripShape<dim> &shape,
             const double size,
             const bool quadratic)
  {
    ShapedBody<dim> body;
    const Tensor<1, 2> along = shape.end - shape.begin;
    fill(body,
         shape,
         n_parts(along.norm(), size, quadratic),
         n_parts(shape.thickness.norm(), size, quadratic),
         size,
         quadratic);
    Tensor<1, dim> direction;
    for (unsigned int d = 0; d < 2; ++d)
      direction[d] = along[d] / along.norm();
    body.fibre.assign(body.mesh.cells.size(), direction);
    return body;
  }



  template <int dim>
  void
  append(ShapedBody<dim> &body, const ShapedBody<dim> &other)
  {
    const unsigned int shift = body.mesh.points.size();
    const auto add           = [shift](auto &to, const auto &from) {
      for (auto nodes : from)
        {
          for (unsigned int &node : nodes)
            node += shift;
          to.push_back(nodes);
        }
    };
    add(body.mesh.quadratic_cells, other.mesh.quadratic_cells);
    body.mesh.points.insert(body.mesh.points.end(),
                            other.mesh.points.begin(),
                            other.mesh.points.end());
    add(body.mesh.cells, other.mesh.cells);
    add(body.lower_face, other.lower_face);
    add(body.upper_face, other.upper_face);
    body.fibre.insert(body.fibre.end(), other.fibre.begin(), other.fibre.end());
  }



  template <int dim>
  double
  volume_behind(const std::vector<std::array<unsigned int, dim>> &face,
                const std::vector<double> &X)
  {
    double volume = 0;
    for (const auto &simplex : face)
      {
        const auto edge = [&](const unsigned int i, const unsigned int d) {
          return X[dim * simplex[i] + d] - X[dim * simplex[0] + d];
        };
        double area; // its component along x
        if constexpr (dim == 2)
          area = edge(1, 1);
        else
          area = 0.5 * (edge(1, 1) * edge(2, 2) - edge(1, 2) * edge(2, 1));
        double x = 0;
        for (const unsigned int node : simplex)
          x += X[dim * node] / dim;
        volume += x * area;
      }
    return volume;
  }

  template struct ShapedBody<2>;
  template struct ShapedBody<3>;
  template ShapedBody<2>
  strip_body(const StripShape<2> &, const double, const bool);
  template ShapedBody<3>
  strip_body(const StripShape<3> &, const double, const bool);
  template void
  append(ShapedBody<2> &, const ShapedBody<2> &);
  template void
  append(ShapedBody<3> &, const ShapedBody<3> &);
  template double
  volume_behind<2>(const std::vector<std::array<unsigned int, 2>> &,
                   const std::vector<double> &);
  template double
  volume_behind<3>(const std::vector<std::array<unsigned int, 3>> &,
                   const std::vector<double> &);
} // namespace coapt
