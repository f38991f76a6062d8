#include <deal.II/base/mpi.h>

#include <coapt/base/exceptions.h>
#include <coapt/coupled/valve_model.h>
#include <coapt/geometry/coupling_lattice.h>
#include <coapt/geometry/facing_parts.h>
#include <coapt/solid/stability.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace coapt
{
  using dealii::Point;

  ValveModel::ValveModel(const ModelParameters &parameters,
                         Timing &timing,
                         MPI_Comm communicator)
    : ValveStructure(parameters, communicator)
    , band(parameters.mesh, distance_to_wall())
    , flow_indicator(parameters.mesh)
  {
    build_fluid();
    build_coupling(timing);
  }



  std::function<double(const Point<3> &)>
  ValveModel::distance_to_wall() const
  {
    return [this](const Point<3> &x) { return lumen.signed_distance(x); };
  }



  namespace
  {
    /** Cells of edge @p h that fill @p length; throws if they do not. */
    unsigned int
    cells_along(const double length, const double h)
    {
      const double n = std::round(length / h);
      if (std::abs(n * h - length) > 1e-6 * h)
        throw InputError("Lumen: Ventricular length plus Atrial length is " +
                         std::to_string(1e3 * length) +
                         " mm, but must be a multiple of Mesh: Coarse cell, " +
                         std::to_string(1e3 * h) + " mm");
      return n;
    }
  } // namespace



  void
  ValveModel::build_fluid()
  {
    const double h = parameters.mesh.coarse_cell;
    Point<3> lower = lumen.lower(), upper = lumen.upper();
    std::array<unsigned int, 3> cells;
    for (unsigned int d = 0; d < 2; ++d)
      {
        cells[d] = 2 * std::ceil(upper[d] / h);
        upper[d] = 0.5 * cells[d] * h;
        lower[d] = -upper[d];
      }
    cells[2] = cells_along(upper[2] - lower[2], h);
    grid = std::make_unique<FluidGrid<3>>(communicator, lower, upper, cells);

    work = std::make_unique<CellWork<3>>(lower,
                                         parameters.mesh.finest_cell(),
                                         distance_to_wall());
    grid->divide_by([this](const Point<3> &center, const double size) {
      return (*work)(center, size);
    });

    FluidBoundaries<3> boundaries;
    boundaries.type.fill(FluidBoundary::no_slip);
    boundaries.type[ventricular_end]     = FluidBoundary::pressure_end;
    boundaries.type[atrial_end]          = FluidBoundary::pressure_end;
    boundaries.pressure[ventricular_end] = ventricular_pressure;
    boundaries.pressure[atrial_end]      = [](const double) { return 0.; };
    boundaries.impedance[ventricular_end] =
      parameters.ends.ventricular_impedance;
    boundaries.impedance[atrial_end] = parameters.ends.atrial_impedance;

    fluid = std::make_unique<FluidOperator<3>>(parameters.fluid,
                                               boundaries,
                                               distance_to_wall());
  }



  void
  ValveModel::check_number_of_points() const
  {
    const double h = parameters.mesh.finest_cell();
    const double n =
      leaflet_volume() / std::pow(parameters.coupling.spacing * h, 3);
    if (n < std::ldexp(1., 31))
      return;
    std::ostringstream text;
    text << "Mesh: Coarse cell and Leaflet level make cells of " << 1e3 * h
         << " mm, which ask for about " << n
         << " coupling points; allowed are less than 2^31";
    throw InputError(text.str());
  }



  namespace
  {
    std::vector<unsigned int>
    nearest_columns(const Leaflet &leaflet,
                    const std::vector<SamplePoint<3>> &lattice)
    {
      std::vector<unsigned int> column_of_node(leaflet.mesh.points.size());
      for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
        for (const unsigned int node : leaflet.columns[c])
          column_of_node[node] = c;
      std::vector<unsigned int> result;
      for (const SamplePoint<3> &point : lattice)
        {
          const auto largest = std::max_element(point.barycentric.begin(),
                                                point.barycentric.end());
          result.push_back(
            column_of_node[leaflet.mesh
                             .cells[point.cell]
                                   [largest - point.barycentric.begin()]]);
        }
      return result;
    }
  } // namespace



  NestedLattice<3>
  ValveModel::coupling_lattice() const
  {
    const auto lattice = [this](const auto &make) {
      return make(leaflet,
                  parameters.coupling.spacing * parameters.mesh.finest_cell(),
                  parameters.coupling.expected_stretch,
                  parameters.coupling.min_layers);
    };
    if (parameters.mesh.levels_coarser_apart > 0 &&
        parameters.mesh.sparser_points_apart)
      return lattice(nested_leaflet_lattice);
    return {lattice(leaflet_lattice), {}};
  }



  void
  ValveModel::build_coupling(Timing &timing)
  {
    check_number_of_points();
    const NestedLattice<3> lattice = coupling_lattice();
    points          = std::make_unique<CouplingPoints<3>>(leaflet.mesh,
                                                 lattice,
                                                 parameters.mesh.finest_cell(),
                                                 communicator);
    column_of_point = nearest_columns(leaflet, lattice.points);

    const std::vector<double> X = reference_positions();
    follow(X, {});
    grid->refine_to([this](const Point<3> &center, const double size) {
      return wanted_level(center, size);
    });
    fluid->reinit(*grid);

    system = std::make_unique<CoupledSystem<3>>(*fluid,
                                                *solid,
                                                *points,
                                                leaflet.pinned,
                                                parameters.coupling,
                                                parameters.solid.density,
                                                parameters.fluid.density,
                                                timing,
                                                communicator);
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    system->add_load([this, rank, n_ranks](const double t,
                                           const double *X,
                                           const double *V,
                                           double *F) {
      chordae->add_forces(t, X, V, F, rank, n_ranks);
    });
    if (!motion.nodes().empty())
      system->set_motion([this](const double t, double *X, double *V) {
        motion.apply(t, X, V);
      });
    system->set_impulse([this](const double *X, double *V, const double dt) {
      last_contact = contact->apply_impulse(X, V, dt);
      act_on_film(X, dt);
    });
    build_film();
  }



  void
  ValveModel::build_film()
  {
    if (!parameters.film.drains)
      return;
    film = std::make_unique<SubGridFilm>(leaflet,
                                         parameters.film,
                                         parameters.mesh.finest_cell(),
                                         parameters.fluid.density *
                                           parameters.fluid.sound_speed *
                                           parameters.fluid.sound_speed,
                                         *points,
                                         *fluid,
                                         communicator);
    system->set_sink(film.get());
  }



  void
  ValveModel::act_on_film(const double *X, const double dt)
  {
    time_since_film += dt;
    if (film && ++steps_since_film >= parameters.contact.search_interval)
      update_film(X);
  }



  void
  ValveModel::update_film(const double *X)
  {
    time_of_film += time_since_film;
    film->update(X,
                 contact->state(),
                 time_since_film,
                 ventricular_pressure(time_of_film));
    steps_since_film = 0;
    time_since_film  = 0;
  }



  std::vector<double>
  ValveModel::state_at_rest()
  {
    return system->state_at_rest(leaflet.mesh.points);
  }



  std::vector<Point<3>>
  ValveModel::dense_positions(const std::vector<double> &X) const
  {
    std::vector<Point<3>> result = points->positions(X.data());
    result.resize(points->n_points());
    return result;
  }



  void
  ValveModel::follow(const std::vector<double> &X, const std::vector<double> &V)
  {
    followed_positions  = X;
    followed_velocities = V;
    band.place(dense_positions(X),
               V.empty() ? std::vector<Point<3>>() : dense_positions(V),
               facing_points(X));

    std::vector<Point<3>> dense = points->positions(X.data()), active;
    for (unsigned int id = 0; id < dense.size(); ++id)
      if (points->is_active(id))
        active.push_back(dense[id]);
    dense.resize(points->n_points());
    work->place(dense, active);
  }



  bool
  ValveModel::band_is_used_up(const std::vector<double> &y) const
  {
    return band.is_used_up(dense_positions(system->solid_positions(y.data())));
  }



  unsigned int
  ValveModel::wanted_level(const Point<3> &center, const double size) const
  {
    const unsigned int level = band.wanted_level(center, size);
    // Below the lumen's level there is no flow.
    return level < parameters.mesh.lumen_level
      ? level
      : std::max(level, flow_indicator.wanted_level(center, size));
  }



  std::vector<bool>
  ValveModel::facing_points(const std::vector<double> &X) const
  {
    if (parameters.mesh.levels_coarser_apart == 0)
      return {};
    const auto node = [&X](const unsigned int n) {
      return Point<3>(X[3 * n], X[3 * n + 1], X[3 * n + 2]);
    };
    std::vector<dealii::Tensor<1, 3>> across;
    for (const auto &column : leaflet.columns)
      across.push_back(node(column.front()) - node(column.back()));
    const std::vector<bool> facing =
      facing_parts(mid_surface(X), across, parameters.mesh.facing_distance);
    std::vector<bool> result;
    for (unsigned int id = 0; id < points->n_points(); ++id)
      result.push_back(facing[column_of_point[id]]);
    return result;
  }



  bool
  ValveModel::adapt(std::vector<double> &y, Log &log)
  {
    const std::vector<double> X = system->solid_positions(y.data());
    follow(X, system->solid_velocities(y.data()));
    if (parameters.mesh.follows_flow() &&
        flow_indicator.update(*grid,
                              *fluid,
                              system->local_velocity(y.data()).data(),
                              [this](const Point<3> &x) {
                                return band.is_near(x);
                              }))
      log.warn("many cells",
               "Mesh: Largest number of cells is exceeded; the velocity jump "
               "is raised to " +
                 std::to_string(flow_indicator.tolerated_jump()) + " m/s");
    if (!system->adapt(
          *grid,
          [this](const Point<3> &center, const double size) {
            return wanted_level(center, size);
          },
          y))
      return false;
    if (film)
      update_film(system->solid_positions(y.data()).data());
    return true;
  }



  double
  ValveModel::point_spacing(const std::vector<double> &X) const
  {
    const std::vector<Point<3>> now  = mid_surface(X),
                                then = mid_surface(reference_positions());

    // The lattice was laid with the spacing over the expected stretch.
    double stretch = 0;
    for (const auto &quad : leaflet.quads)
      for (unsigned int i = 0; i < 2; ++i)
        {
          // Mean of two opposite edges.
          const auto edge = [&](const std::vector<Point<3>> &x) {
            return i == 0
              ? (x[quad[1]] - x[quad[0]]) + (x[quad[2]] - x[quad[3]])
              : (x[quad[3]] - x[quad[0]]) + (x[quad[2]] - x[quad[1]]);
          };
          stretch = std::max(stretch, edge(now).norm() / edge(then).norm());
        }
    return parameters.coupling.spacing * stretch /
      parameters.coupling.expected_stretch;
  }



  double
  ValveModel::points_per_fluid_node() const
  {
    return points->n_points() * std::pow(parameters.mesh.finest_cell(), 3) /
      leaflet_volume();
  }



  void
  ValveModel::check_resolution(Log &log) const
  {
    const double h          = parameters.mesh.finest_cell();
    const double spacing    = parameters.coupling.spacing;
    const std::string found = "Coupling: Point spacing is " +
      std::to_string(spacing) + " cells in the deformed leaflet";
    if (spacing >= 1.4)
      throw InputError(found + ", but must be below 1.4");
    if (spacing > 0.9)
      log.warn("sparse points",
               found + ": the leaflet will leak (at most 0.9 is tight)");
    const double per_node = points_per_fluid_node();
    if (per_node < 1.5)
      log.warn("few points",
               "Coupling: the leaflet has " + std::to_string(per_node) +
                 " coupling points for each fluid node within it and will "
                 "leak (1.8 are tight)");
    if (parameters.coupling.min_layers < 2)
      log.warn("one layer",
               "Coupling: a single layer of points leaks 1-5 mm/s");
    if (parameters.lumen.inset < h)
      log.warn("root",
               "Lumen: Inset is below one fluid cell, " +
                 std::to_string(1e3 * h) + " mm: the hinge may leak");
    parameters.coupling.warn_of_mass(
      points->largest_mass_ratio(*fluid, parameters.solid.density),
      parameters.solid.density / parameters.fluid.density,
      log);
    warn_if_unstable(parameters.solid, log);
  }



  unsigned int
  ValveModel::n_active_cells() const
  {
    return fluid->n_active_cells();
  }



  std::string
  ValveModel::division() const
  {
    double n_fluid = 0;
    for (unsigned int c = 0; c < fluid->n_owned_cells(); ++c)
      n_fluid += fluid->is_active_cell(c);
    std::ostringstream line;
    line << "a rank:";
    const auto add = [&](const double number, const std::string &what) {
      const auto range =
        dealii::Utilities::MPI::min_max_avg(number, communicator);
      line << " " << range.min << " to " << range.max << " " << what;
    };
    add(fluid->n_owned_cells(), "cells,");
    add(n_fluid, "of them with fluid,");
    add(points->n_owned(), "coupling points,");
    add(solid->owned_cells().size(), "tetrahedra,");
    add(fluid->n_local_nodes() - fluid->n_owned_nodes(), "ghost nodes");
    return line.str();
  }



  double
  ValveModel::largest_relaxation_time(const double time) const
  {
    const double peak = ventricular_pressure.largest_magnitude();
    // no more than ten times as long, at the beginning
    const double now =
      std::max(std::abs(ventricular_pressure(time)), 0.01 * peak);
    return parameters.coupling.max_relaxation_time *
      (peak > 0 ? std::sqrt(peak / now) : 1.);
  }
} // namespace coapt
