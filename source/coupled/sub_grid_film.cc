#include <deal.II/base/mpi.h>

#include <coapt/coupled/sub_grid_film.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** One below @p a, zero above @p b, smooth between. */
    double
    falling_step(const double x, const double a, const double b)
    {
      const double s = std::min(1., std::max(0., (b - x) / (b - a)));
      return s * s * (3 - 2 * s);
    }

    /** Zero below @p a, one above @p b, linear between. */
    double
    ramp(const double x, const double a, const double b)
    {
      return std::min(1., std::max(0., (x - a) / (b - a)));
    }

    /** Which part of a film may still hold trapped fluid, given how many
     * volumes have drained of it. Trapped fluid is gone after one. */
    double
    part_trapped(const double turnover)
    {
      return 1 - ramp(turnover, 2, 4);
    }

    /** Least ventricular pressure (Pa) that films are compared with: below it,
     * in a valve that opens again, they drain whoever feeds them. */
    const double least_ventricular_pressure = 1e3;

    Point<3>
    node_at(const double *X, const unsigned int node)
    {
      return Point<3>(X[3 * node], X[3 * node + 1], X[3 * node + 2]);
    }

    double
    distance_from_segment(const Point<3> &x,
                          const Point<3> &a,
                          const Point<3> &b)
    {
      const Tensor<1, 3> edge = b - a;
      const double s =
        std::min(1., std::max(0., (x - a) * edge / edge.norm_square()));
      return x.distance(a + s * edge);
    }

    Point<3>
    middle(const Leaflet &leaflet, const unsigned int column)
    {
      const auto &nodes = leaflet.columns[column];
      return leaflet.mesh.points[nodes.front()] +
        0.5 *
        (leaflet.mesh.points[nodes.back()] -
         leaflet.mesh.points[nodes.front()]);
    }
  } // namespace



  SubGridFilm::SubGridFilm(const Leaflet &leaflet,
                           const FilmParameters &parameters,
                           const double cell_size,
                           const double bulk_modulus,
                           CouplingPoints<3> &points,
                           const FluidOperator<3> &fluid,
                           MPI_Comm communicator)
    : leaflet(leaflet)
    , parameters(parameters)
    , cell_size(cell_size)
    , bulk_modulus(bulk_modulus)
    , points(points)
    , fluid(fluid)
    , communicator(communicator)
    , triangles(triangulate(leaflet.quads))
    , column_of_node(leaflet.mesh.points.size())
    , stations(leaflet.columns.size())
    , turnover(leaflet.columns.size(), 0.)
  {
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      for (const unsigned int node : leaflet.columns[c])
        column_of_node[node] = c;
    measure_edge_distances(leaflet);
  }



  void
  SubGridFilm::measure_edge_distances(const Leaflet &leaflet)
  {
    const auto &edge = leaflet.free_edge_columns;
    edge_distance.assign(leaflet.columns.size(), 1e300);
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      for (unsigned int i = 0; i < edge.size(); ++i)
        edge_distance[c] =
          std::min(edge_distance[c],
                   distance_from_segment(middle(leaflet, c),
                                         middle(leaflet, edge[i]),
                                         middle(leaflet,
                                                edge[(i + 1) % edge.size()])));
  }



  void
  SubGridFilm::update(const double *X,
                      const MidSurfaceContact::ColumnState &contact,
                      const double duration,
                      const double ventricular_pressure)
  {
    book(duration);
    comparison = std::max(ventricular_pressure, least_ventricular_pressure);
    find_stations(X, contact);

    const std::vector<Point<3>> positions = points.positions(X);
    std::vector<Tensor<1, 3>> directions(positions.size());
    for (unsigned int id = 0; id < positions.size(); ++id)
      {
        if (!points.is_active(id))
          continue;
        const SamplePoint<3> &point = points.samples()[id];
        const Station station       = station_at(point);
        if (station.weight > 0 &&
            (station.atrial ? point.depth < 0.499 : point.depth > 0.501))
          directions[id] = std::sqrt(station.weight) * station.normal;
      }
    points.set_release(directions);
    find_draining_cells(positions);
  }



  // Integrals over time are means over the evaluations.
  void
  SubGridFilm::book(const double duration)
  {
    if (evaluations == 0)
      return;
    const double scale = parameters.drainage * duration / evaluations;
    evaluations        = 0;

    // of each column: volume of its coupling points, and of what would have
    // drained there; last, what has drained
    std::vector<double> sums(2 * turnover.size() + 1, 0.);
    for (const Source &source : sources)
      {
        const SamplePoint<3> &point = points.samples()[source.point];
        const auto &nodes           = leaflet.mesh.cells[point.cell];
        for (unsigned int a = 0; a < 4; ++a)
          {
            const unsigned int c = column_of_node[nodes[a]];
            const double share   = point.barycentric[a] * point.volume;
            sums[2 * c] += share;
            sums[2 * c + 1] += share * scale * cells[source.entry].pressures;
          }
      }
    for (const Cell &cell : cells)
      sums.back() += scale * cell.volume * cell.drained;
    dealii::Utilities::MPI::sum(sums, communicator, sums);

    volume += sums.back();
    for (unsigned int c = 0; c < turnover.size(); ++c)
      if (sums[2 * c] > 0)
        turnover[c] += std::max(0., sums[2 * c + 1] / sums[2 * c]);
  }



  void
  SubGridFilm::find_stations(const double *X,
                             const MidSurfaceContact::ColumnState &contact)
  {
    const double largest = parameters.largest_width * cell_size;
    const double treated = parameters.treated_width * cell_size;
    for (unsigned int c = 0; c < stations.size(); ++c)
      {
        Station &station = stations[c];
        station          = Station();
        if (contact.gap[c] >= largest ||
            contact.partner[c] == MidSurfaceContact::no_partner)
          {
            turnover[c] = 0;
            continue;
          }
        const auto &nodes = leaflet.columns[c];
        Tensor<1, 3> across =
          node_at(X, nodes.front()) - node_at(X, nodes.back());
        across /= across.norm();
        station.gap    = contact.gap[c];
        station.normal = contact.normals[c];
        station.atrial = station.normal * across > 0;
        // Surfaces that meet edge-on do not enclose a film.
        station.weight = falling_step(station.gap, treated, largest) *
          ramp(std::abs(station.normal * across), 0.25, 0.75);

        station.drainage = station.weight *
          ramp(edge_distance_with_partner(c, contact.partner[c]),
               0.,
               0.5 * cell_size);
        station.turnover = turnover[c];
      }
  }



  double
  SubGridFilm::edge_distance_with_partner(const unsigned int column,
                                          const unsigned int partner) const
  {
    double distance = 0;
    for (const unsigned int corner : triangles[partner])
      distance += edge_distance[corner] / 3;
    return std::min(distance, edge_distance[column]);
  }



  SubGridFilm::Station
  SubGridFilm::station_at(const SamplePoint<3> &point) const
  {
    Station result;
    double largest        = -1;
    double total_in_films = 0;
    const auto &nodes     = leaflet.mesh.cells[point.cell];
    for (unsigned int a = 0; a < 4; ++a)
      {
        const double share     = point.barycentric[a];
        const unsigned int c   = column_of_node[nodes[a]];
        const Station &station = stations[c];
        result.weight += share * station.weight;
        result.drainage += share * station.drainage;
        result.turnover += share * station.turnover;
        result.normal += share * station.weight * station.normal;
        if (station.weight > 0)
          {
            total_in_films += share;
            result.gap += share * station.gap;
          }
        if (share > largest)
          {
            largest       = share;
            result.atrial = station.atrial;
          }
      }
    const double length = result.normal.norm();
    if (!(length > 0))
      return Station();
    result.normal /= length;
    result.gap /= total_in_films;
    return result;
  }



  // The facing half of the leaflet and half of the film are swept by stretching
  // the coupling points of that half from the mid-surface to the film's middle.
  void
  SubGridFilm::find_draining_cells(const std::vector<Point<3>> &positions)
  {
    cells.clear();
    sources.clear();
    std::vector<unsigned int> entry_of_cell(
      fluid.n_owned_cells(), dealii::numbers::invalid_unsigned_int);
    int hint = -1;
    for (unsigned int id = 0; id < positions.size(); ++id)
      {
        if (!points.is_active(id))
          continue;
        const SamplePoint<3> &point = points.samples()[id];
        const Station station       = station_at(point);
        const double height =
          station.atrial ? 1 - 2 * point.depth : 2 * point.depth - 1;
        if (!(station.drainage > 0) || height < -1e-3)
          continue;
        const int found = fluid.locate(
          positions[id] + 0.5 * height * station.gap * station.normal, hint);
        hint = found;
        if (found < 0 || found >= static_cast<int>(fluid.n_owned_cells()))
          continue;
        unsigned int &entry = entry_of_cell[found];
        if (entry == dealii::numbers::invalid_unsigned_int)
          {
            entry = cells.size();
            cells.push_back({static_cast<unsigned int>(found),
                             std::pow(fluid.cell(found).size, 3)});
          }
        sources.push_back({id, entry});
        const double half = height < 1e-3 ? 0.5 : 1; // shared with the other
        const double part = station.drainage * half * point.volume *
          (1 + station.gap / leaflet.thickness);
        cells[entry].in_film += part / cells[entry].volume;
        cells[entry].turnover += station.turnover * part / cells[entry].volume;
      }
    for (Cell &cell : cells)
      {
        cell.trapped = part_trapped(cell.turnover / cell.in_film);
        // A cell that reaches into a film with a corner only draws from the
        // ventricle.
        cell.draining = ramp(cell.in_film, 0.25, 0.75);
      }
  }



  // Near the pressure of the ventricle is what it feeds, even if most of the
  // film around has drained.
  double
  SubGridFilm::open_part(const Cell &cell, const double pressure) const
  {
    return cell.draining *
      std::max(cell.trapped, falling_step(pressure / comparison, 0.35, 0.7));
  }



  void
  SubGridFilm::add_rate(const double *pressure, double *pressure_rate)
  {
    ++evaluations;
    const double rate = parameters.drainage * bulk_modulus;
    for (Cell &cell : cells)
      {
        const double p        = pressure[cell.number];
        const double draining = open_part(cell, p) * p;
        cell.pressures += p;
        cell.drained += draining;
        pressure_rate[cell.number] -= rate * draining;
      }
  }



  double
  SubGridFilm::power(const double *pressure) const
  {
    double sum = 0;
    for (const Cell &cell : cells)
      {
        const double p = pressure[cell.number];
        sum += parameters.drainage * cell.volume * open_part(cell, p) * p * p;
      }
    return sum;
  }
} // namespace coapt
