#include <coapt/base/exceptions.h>
#include <coapt/geometry/prestretch.h>
#include <coapt/geometry/quadratic_mesh.h>
#include <coapt/geometry/valve_generator.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    constexpr double pi = numbers::PI;

    /** Numbers of columns, nodes and angles on the grid of the valve. */
    struct Grid
    {
      explicit Grid(const ValveParameters &valve)
        : valve(valve), n_rows(valve.n_root_rows + valve.n_radial + 1)
      {
      }

      unsigned int
      column(const unsigned int i, const unsigned int j) const
      {
        return (i % valve.n_circumferential) * n_rows + j;
      }

      double
      angle(const unsigned int i) const
      {
        const double t = 2 * pi * i / valve.n_circumferential;
        return t > pi * (1 + 1e-12) ? t - 2 * pi : t;
      }

      /** Fraction of the height of row @p j. Rows of the root are lengths. */
      double
      fraction(const unsigned int i, const unsigned int j) const
      {
        const int row =
          static_cast<int>(j) - static_cast<int>(valve.n_root_rows);
        if (row >= 0)
          return static_cast<double>(row) / valve.n_radial;
        return row * valve.root_length / valve.n_root_rows /
          leaflet_height(valve, angle(i));
      }

      const ValveParameters &valve;
      const unsigned int n_rows;
    };

    /** Unit normal of the open mid-surface towards the ventricular side. */
    Tensor<1, 3>
    outward_normal(const ValveParameters &valve, const double t, const double s)
    {
      const double step = 1e-4;
      const Tensor<1, 3> around =
        open_position(valve, t + step, s) - open_position(valve, t - step, s);
      const Tensor<1, 3> down =
        open_position(valve, t, s + step) - open_position(valve, t, s - step);
      const Tensor<1, 3> normal = cross_product_3d(down, around);
      return normal / normal.norm();
    }

    void
    create_columns(const Grid &grid, Leaflet &leaflet)
    {
      const ValveParameters &valve = grid.valve;
      for (unsigned int i = 0; i < valve.n_circumferential; ++i)
        for (unsigned int j = 0; j < grid.n_rows; ++j)
          {
            const double t = grid.angle(i), s = grid.fraction(i, j);
            const Point<3> middle     = open_position(valve, t, s);
            const Tensor<1, 3> normal = outward_normal(valve, t, s);
            std::vector<unsigned int> column;
            for (unsigned int k = 0; k <= valve.n_layers; ++k)
              {
                const double depth = double(k) / valve.n_layers - 0.5;
                column.push_back(leaflet.mesh.points.size());
                leaflet.mesh.points.push_back(middle +
                                              valve.thickness * depth * normal);
              }
            leaflet.columns.push_back(column);
            leaflet.column_coordinates.push_back({{t, s}});
            if (j == valve.n_root_rows)
              leaflet.annulus_columns.push_back(leaflet.columns.size() - 1);
            if (j + 1 == grid.n_rows)
              leaflet.free_edge_columns.push_back(leaflet.columns.size() - 1);
          }
    }

    Region
    region(const Grid &grid, const unsigned int i, const unsigned int j)
    {
      if (j < grid.valve.n_root_rows)
        return Region::root;
      const double t = 2 * pi * (i + 0.5) / grid.valve.n_circumferential;
      // the left half mirrors the right half
      const double right = std::asin(std::sin(t));
      if (std::abs(right - grid.valve.commissure_angle) <
          grid.valve.commissure_half_width)
        return Region::commissure;
      return right > grid.valve.commissure_angle ? Region::anterior
                                                 : Region::posterior;
    }

    /** Cuts of a brick into five tetrahedra; the second mirrors the first, so
     * that neighbours in alternation share the diagonals of their faces. */
    constexpr unsigned int cuts[2][5][4] = {
      {{0, 1, 3, 4}, {1, 2, 3, 6}, {1, 4, 5, 6}, {3, 4, 6, 7}, {1, 3, 4, 6}},
      {{0, 1, 2, 5}, {0, 2, 3, 7}, {0, 4, 5, 7}, {2, 5, 6, 7}, {0, 5, 2, 7}}};

    double
    volume(const SimplexMesh<3> &mesh, const std::array<unsigned int, 4> &cell)
    {
      const Point<3> &origin = mesh.points[cell[0]];
      return cross_product_3d(mesh.points[cell[1]] - origin,
                              mesh.points[cell[2]] - origin) *
        (mesh.points[cell[3]] - origin) / 6;
    }

    /**
     * The five tetrahedra between two layers of a quadrilateral. The corners
     * go round as the quadrilateral does, atrial layer first, which is right-
     * handed: all volumes are positive unless the brick is inverted.
     */
    void
    create_brick(const unsigned int q,
                 const unsigned int layer,
                 const bool second_cut,
                 Leaflet &leaflet)
    {
      unsigned int corner[8];
      for (unsigned int c = 0; c < 4; ++c)
        {
          const auto &column = leaflet.columns[leaflet.quads[q][c]];
          corner[c]          = column[layer];
          corner[c + 4]      = column[layer + 1];
        }
      for (const auto &cut : cuts[second_cut])
        {
          std::array<unsigned int, 4> cell;
          for (unsigned int v = 0; v < 4; ++v)
            cell[v] = corner[cut[v]];
          leaflet.mesh.cells.push_back(cell);
          leaflet.cell_quad.push_back(q);
        }
    }

    /** Node numbers of the whole valve: around, along the height, through the
     * thickness. */
    using LatticePoint = std::array<unsigned int, 3>;

    /** The ten nodes of the tetrahedron that the way along the axes in their
     * @p order, each by two, spans in the block that begins at @p lower. The
     * block may be @p mirrored to its middle in the first direction. Ways of
     * the other sense of rotation change their last two vertices. */
    std::array<LatticePoint, 10>
    tetrahedron_in_block(const LatticePoint &lower,
                         const std::array<unsigned int, 3> &order,
                         const bool mirrored)
    {
      std::array<LatticePoint, 10> point;
      // Around, along the height and outwards are left-handed.
      const bool is_right_handed =
        ((order[1] + 3 - order[0]) % 3 != 1) != mirrored;
      point[0] = lower;
      point[0][0] += mirrored ? 2 : 0;
      for (unsigned int v = 1; v < 4; ++v)
        {
          const unsigned int axis = order[v - 1];
          point[v]                = point[v - 1];
          point[v][axis]          = 2 * lower[axis] + 2 - point[v][axis];
        }
      if (!is_right_handed)
        std::swap(point[2], point[3]);
      for (unsigned int e = 0; e < 6; ++e)
        for (unsigned int d = 0; d < 3; ++d)
          point[4 + e][d] = (point[tetrahedron_edges[e][0]][d] +
                             point[tetrahedron_edges[e][1]][d]) /
            2;
      return point;
    }

    /** The quadrilateral in which a linear part of an element at the lattice
     * points @p corners is. */
    unsigned int
    quad_of_part(const Grid &grid,
                 const std::array<LatticePoint, 10> &points,
                 const std::array<unsigned int, 10> &nodes,
                 const std::array<unsigned int, 4> &part)
    {
      LatticePoint lowest{{~0u, ~0u, ~0u}};
      for (const unsigned int node : part)
        {
          const unsigned int a =
            std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
          for (unsigned int d = 0; d < 3; ++d)
            lowest[d] = std::min(lowest[d], points[a][d]);
        }
      return lowest[0] * (grid.n_rows - 1) + lowest[1];
    }

    /** The six tetrahedra of ten nodes in the block that begins at @p lower. */
    void
    create_block(const Grid &grid, const LatticePoint &lower, Leaflet &leaflet)
    {
      const unsigned int n              = grid.valve.n_circumferential;
      const bool is_left                = (lower[0] + n / 4) % n >= n / 2;
      std::array<unsigned int, 3> order = {{0, 1, 2}};
      do
        {
          const auto points = tetrahedron_in_block(lower, order, is_left);
          std::array<unsigned int, 10> nodes;
          for (unsigned int a = 0; a < 10; ++a)
            nodes[a] =
              leaflet
                .columns[grid.column(points[a][0], points[a][1])][points[a][2]];
          const std::size_t first = leaflet.mesh.cells.size();
          add_quadratic_cell(nodes, leaflet.mesh);
          for (std::size_t i = first; i < leaflet.mesh.cells.size(); ++i)
            leaflet.cell_quad.push_back(
              quad_of_part(grid, points, nodes, leaflet.mesh.cells[i]));
      } while (std::next_permutation(order.begin(), order.end()));
    }

    void
    create_cells(const Grid &grid, Leaflet &leaflet)
    {
      const ValveParameters &valve = grid.valve;
      for (unsigned int i = 0; i < valve.n_circumferential; ++i)
        for (unsigned int j = 0; j + 1 < grid.n_rows; ++j)
          {
            const unsigned int q = leaflet.quads.size();
            leaflet.quads.push_back({{grid.column(i, j),
                                      grid.column(i, j + 1),
                                      grid.column(i + 1, j + 1),
                                      grid.column(i + 1, j)}});
            leaflet.quad_region.push_back(region(grid, i, j));
            for (unsigned int k = 0; k < valve.n_layers; ++k)
              if (!valve.quadratic)
                create_brick(q, k, (i + j + k) % 2 == 1, leaflet);
              else if (i % 2 == 0 && j % 2 == 0 && k % 2 == 0)
                create_block(grid, {{i, j, k}}, leaflet);
          }
      for (const auto &cell : leaflet.mesh.cells)
        if (!(volume(leaflet.mesh, cell) > 0))
          throw InputError(
            "Valve: the leaflet folds over itself near angle " +
            std::to_string(
              leaflet
                .column_coordinates[cell[0] / (grid.valve.n_layers + 1)][0] /
              ValveParameters::degree) +
            " degrees; heights, cone angles, root length and "
            "thickness must fit the annulus.");
    }

    /** Middle of a column. */
    Point<3>
    middle(const Leaflet &leaflet, const unsigned int column)
    {
      const auto &nodes = leaflet.columns[column];
      return Point<3>((leaflet.mesh.points[nodes.front()] +
                       Tensor<1, 3>(leaflet.mesh.points[nodes.back()])) *
                      0.5);
    }

    void
    create_fibres(const ValveParameters &valve, Leaflet &leaflet)
    {
      for (const unsigned int q : leaflet.cell_quad)
        {
          const auto &quad    = leaflet.quads[q];
          const Point<3> p[4] = {middle(leaflet, quad[0]),
                                 middle(leaflet, quad[1]),
                                 middle(leaflet, quad[2]),
                                 middle(leaflet, quad[3])};
          Tensor<1, 3> around = (p[3] - p[0]) + (p[2] - p[1]);
          around /= around.norm();
          Tensor<1, 3> radial = (p[1] - p[0]) + (p[2] - p[3]);
          radial -= (radial * around) * around;
          radial /= radial.norm();
          const Tensor<1, 3> normal = cross_product_3d(radial, around);

          Tensor<1, 3> fibre = around;
          if (valve.fibre_rule == FibreRule::parallel)
            {
              // horizontal and tangential; e_z x n has the sense of around
              fibre = Tensor<1, 3>({-normal[1], normal[0], 0});
              fibre /= fibre.norm();
            }
          leaflet.fibre.push_back(fibre);

          Tensor<2, 3> prestretch;
          for (unsigned int d = 0; d < 3; ++d)
            prestretch[d][d] = 1;
          if (leaflet.quad_region[q] != Region::root)
            prestretch = sheet_prestretch(around,
                                          radial,
                                          valve.circumferential_prestretch,
                                          valve.radial_prestretch);
          leaflet.prestretch.push_back(prestretch);
        }
    }

    void
    pin_nodes(const Grid &grid, Leaflet &leaflet)
    {
      const ValveParameters &valve = grid.valve;
      leaflet.pinned.assign(leaflet.mesh.points.size(), false);
      for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
        {
          const unsigned int row = c % grid.n_rows;
          const auto &nodes      = leaflet.columns[c];
          const bool annulus     = row == valve.n_root_rows;
          const bool held_mid    = annulus || row == 0;
          if (valve.annulus_hold == AnnulusHold::clamped &&
              row <= valve.n_root_rows)
            for (const unsigned int node : nodes)
              leaflet.pinned[node] = true;
          else if (valve.annulus_hold == AnnulusHold::straps ? held_mid
                                                             : annulus)
            {
              leaflet.pinned[nodes[valve.n_layers / 2]]       = true;
              leaflet.pinned[nodes[(valve.n_layers + 1) / 2]] = true;
            }
        }
      for (unsigned int node = 0; node < leaflet.pinned.size(); ++node)
        if (leaflet.pinned[node])
          leaflet.held_sets["annulus"].push_back(node);
    }
  } // namespace



  Leaflet
  generate_leaflet(const ValveParameters &valve)
  {
    valve.check();
    const Grid grid(valve);
    Leaflet leaflet;
    leaflet.thickness = valve.thickness;
    create_columns(grid, leaflet);
    create_cells(grid, leaflet);
    create_fibres(valve, leaflet);
    pin_nodes(grid, leaflet);
    return leaflet;
  }
} // namespace coapt
