#include <coapt/base/csv_table.h>
#include <coapt/base/exceptions.h>
#include <coapt/base/time_table.h>
#include <coapt/geometry/prestretch.h>
#include <coapt/import/fibres.h>
#include <coapt/import/imported_valve.h>
#include <coapt/import/surface_coordinates.h>
#include <coapt/import/thicken.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Angle of a point around the z axis. */
    double
    angle_of(const Point<3> &x)
    {
      return std::atan2(x[1], x[0]);
    }

    Point<3>
    centre(const std::vector<Point<3>> &points,
           const std::array<unsigned int, 4> &quad)
    {
      Point<3> result;
      for (const unsigned int corner : quad)
        result += 0.25 * points[corner];
      return result;
    }

    /** Twice the area vector of a quadrilateral. */
    Tensor<1, 3>
    area_vector(const std::vector<Point<3>> &points,
                const std::array<unsigned int, 4> &quad)
    {
      return cross_product_3d(points[quad[2]] - points[quad[0]],
                              points[quad[3]] - points[quad[1]]);
    }

    /** A number in a cell of a table that must be a whole one. */
    long
    whole_number(const CsvTable &table,
                 const unsigned int row,
                 const std::string &column,
                 const double value)
    {
      if (value != std::floor(value) || value < -1)
        throw InputError(table.place(row) + ", column " + column +
                         ": must be a whole number, or -1 for none");
      return std::lround(value);
    }
  } // namespace



  ImportedValve::ImportedValve(const ImportParameters &parameters,
                               const ValveParameters &valve,
                               const double density,
                               const std::string &folder)
    : parameters(parameters)
    , valve(valve)
    , surface(read_surface_mesh(find_input_file(parameters.mesh, folder),
                                parameters.unit))
  {
    read_held_nodes(find_input_file(parameters.held_nodes, folder));
    if (!parameters.chordae.empty())
      {
        std::set<long> ends;
        for (const auto &[name, nodes] : held)
          ends.insert(nodes.chordae_nodes.begin(), nodes.chordae_nodes.end());
        tree = ChordaeTree(find_input_file(parameters.chordae, folder),
                           parameters.unit,
                           ends,
                           surface.points);
      }
    hold_added_vertices();
    turn_to_ventricle();
    move_annulus_to_origin();
    whole =
      thicken(surface.points, surface.quads, valve.thickness, valve.n_layers);
    set_regions();
    set_coordinates();
    set_fibres(folder);
    whole.pinned.assign(whole.mesh.points.size(), false);
    tree.add_nodes(density, whole);
    hold_nodes();
  }



  void
  ImportedValve::read_held_nodes(const std::string &file)
  {
    const CsvTable table(file);
    const auto set     = table.texts("set");
    const auto vertex  = table.numbers("vertex");
    const auto chordae = table.numbers("chordae_node");
    for (unsigned int i = 0; i < table.n_rows(); ++i)
      {
        const long v = whole_number(table, i, "vertex", vertex[i]);
        const long c = whole_number(table, i, "chordae_node", chordae[i]);
        if ((v < 0) == (c < 0))
          throw InputError(table.place(i) +
                           ": one of vertex and chordae_node must be -1");
        if (v >= long(surface.n_vertices))
          throw InputError(table.place(i) + ": there is no vertex " +
                           std::to_string(v) + "; the mesh has " +
                           std::to_string(surface.n_vertices));
        if (c >= 0 && parameters.chordae.empty())
          throw InputError(table.place(i) +
                           ": Import/Chordae is empty, so that there is no "
                           "chordae_node");
        if (v >= 0)
          held[set[i]].vertices.insert(v);
        else
          held[set[i]].chordae_nodes.insert(c);
      }
    if (held["annulus"].vertices.empty())
      throw InputError(file + ": no vertex is in a set called annulus");
    std::set<unsigned int> boundary;
    for (const auto &edge : boundary_edges(surface.quads))
      boundary.insert(edge.begin(), edge.end());
    for (const unsigned int v : held["annulus"].vertices)
      if (boundary.count(v) == 0)
        throw InputError(file + ": vertex " + std::to_string(v) +
                         " of the annulus is not on the boundary of the mesh");
  }



  void
  ImportedValve::hold_added_vertices()
  {
    for (const auto &edge : boundary_edges(surface.quads))
      for (const unsigned int v : edge)
        if (v >= surface.n_vertices)
          {
            const auto &ends = surface.added_vertices[v - surface.n_vertices];
            for (auto &[name, nodes] : held)
              if (nodes.vertices.count(ends[0]) > 0 &&
                  nodes.vertices.count(ends[1]) > 0)
                nodes.vertices.insert(v);
          }
  }



  void
  ImportedValve::move_annulus_to_origin()
  {
    const auto &annulus = held["annulus"].vertices;
    Tensor<1, 3> mean;
    for (const unsigned int v : annulus)
      mean += Tensor<1, 3>(surface.points[v]);
    mean /= double(annulus.size());
    for (Point<3> &x : surface.points)
      x -= mean;
    tree.move(-mean);
  }



  void
  ImportedValve::turn_to_ventricle()
  {
    // Seen from a point in the atrium, both a valve that hangs open and one
    // that is closed show their atrial side.
    const auto &annulus = held["annulus"].vertices;
    Point<3> eye;
    for (const unsigned int v : annulus)
      eye += surface.points[v];
    eye /= double(annulus.size());
    double radius = 0;
    for (const unsigned int v : annulus)
      radius = std::max(radius, eye.distance(surface.points[v]));
    eye[2] += radius;
    double away = 0;
    for (const auto &quad : surface.quads)
      away += area_vector(surface.points, quad) *
        (centre(surface.points, quad) - eye);
    if (away < 0)
      for (auto &quad : surface.quads)
        std::swap(quad[1], quad[3]);
  }



  void
  ImportedValve::set_regions()
  {
    for (unsigned int q = 0; q < surface.quads.size(); ++q)
      {
        const auto region = parameters.regions.find(surface.labels[q]);
        if (region == parameters.regions.end())
          throw InputError("Import/Regions has no region for the label " +
                           std::to_string(surface.labels[q]) + " of element " +
                           std::to_string(surface.elements[q] + 1) + " of " +
                           parameters.mesh);
        whole.quad_region.push_back(region->second);
      }
  }



  void
  ImportedValve::set_coordinates()
  {
    const auto &annulus = held["annulus"].vertices;
    std::set<unsigned int> edge;
    for (const auto &ends : boundary_edges(surface.quads))
      for (const unsigned int v : ends)
        if (annulus.count(v) == 0)
          edge.insert(v);
    if (edge.empty())
      throw InputError(parameters.mesh +
                       ": there is no free edge: the whole "
                       "boundary is annulus");

    Tensor<1, 3> anterior;
    for (unsigned int q = 0; q < surface.quads.size(); ++q)
      if (whole.quad_region[q] == Region::anterior)
        anterior += area_vector(surface.points, surface.quads[q]).norm() *
          centre(surface.points, surface.quads[q]);
    const double turn =
      0.5 * dealii::numbers::PI - angle_of(Point<3>(anterior));

    whole.annulus_columns.assign(annulus.begin(), annulus.end());
    whole.free_edge_columns.assign(edge.begin(), edge.end());
    const auto above = distances_along_surface(surface.points,
                                               surface.quads,
                                               whole.annulus_columns);
    const auto below = distances_along_surface(surface.points,
                                               surface.quads,
                                               whole.free_edge_columns);
    for (unsigned int c = 0; c < surface.points.size(); ++c)
      whole.column_coordinates.push_back(
        {{std::remainder(angle_of(surface.points[c]) + turn,
                         2 * dealii::numbers::PI),
          above[c] / (above[c] + below[c])}});
    for (auto *line : {&whole.annulus_columns, &whole.free_edge_columns})
      std::sort(line->begin(), line->end(), [&](const auto a, const auto b) {
        return whole.column_coordinates[a][0] < whole.column_coordinates[b][0];
      });
  }



  void
  ImportedValve::set_fibres(const std::string &folder)
  {
    const std::vector<Tensor<1, 3>> given = parameters.fibres.empty()
      ? std::vector<Tensor<1, 3>>()
      : read_fibres(find_input_file(parameters.fibres, folder), surface);
    for (const unsigned int q : whole.cell_quad)
      {
        Tensor<1, 3> normal = area_vector(surface.points, surface.quads[q]);
        normal /= normal.norm();
        Tensor<1, 3> fibre;
        if (!given.empty())
          fibre = given[q];
        else if (valve.fibre_rule == FibreRule::parallel)
          fibre = Tensor<1, 3>({-normal[1], normal[0], 0});
        // Around the axis; also where the surface is horizontal.
        if (fibre.norm() < 1e-3)
          {
            const Point<3> x = centre(surface.points, surface.quads[q]);
            fibre            = Tensor<1, 3>({-x[1], x[0], 0});
          }
        fibre -= (fibre * normal) * normal;
        fibre /= fibre.norm();
        whole.fibre.push_back(fibre);
        whole.prestretch.push_back(
          sheet_prestretch(fibre,
                           cross_product_3d(normal, fibre),
                           valve.circumferential_prestretch,
                           valve.radial_prestretch));
      }
  }



  void
  ImportedValve::hold_nodes()
  {
    const bool clamped = valve.annulus_hold == AnnulusHold::clamped;
    for (const auto &[name, nodes] : held)
      {
        auto &set = whole.held_sets[name];
        for (const unsigned int v : nodes.vertices)
          {
            const auto &column   = whole.columns[v];
            const unsigned int n = column.size();
            for (unsigned int k = 0; k < n; ++k)
              if (clamped || k == (n - 1) / 2 || k == n / 2)
                set.push_back(column[k]);
          }
        for (const long number : nodes.chordae_nodes)
          set.push_back(tree.leaflet_node_of(number));
        for (const unsigned int node : set)
          whole.pinned[node] = true;
      }
  }



  std::vector<Chorda>
  ImportedValve::chordae(const std::vector<double> &nodal_mass) const
  {
    return tree.chordae(whole,
                        nodal_mass,
                        valve.chordae_modulus,
                        parameters.length_factor,
                        valve.influence_radius);
  }



  std::array<double, 2>
  ImportedValve::semi_axes() const
  {
    std::array<double, 2> result{};
    for (const unsigned int column : whole.annulus_columns)
      for (unsigned int d = 0; d < 2; ++d)
        result[d] = std::max(result[d], std::abs(surface.points[column][d]));
    return result;
  }
} // namespace coapt
