#include <coapt/base/exceptions.h>
#include <coapt/coupled/valve_model.h>
#include <coapt/fluid/octree_file.h>

// What of ValveModel a run needs that goes on from a checkpoint.
namespace coapt
{
  ValveSnapshot
  ValveModel::snapshot(const double *y) const
  {
    return {grid->triangulation().n_cells(0),
            parameters.mesh.coarse_cell,
            static_cast<unsigned int>(chordae->chordae().size()),
            system->snapshot(y),
            contact->snapshot(),
            film ? film->history() : SubGridFilm::History(),
            time_of_film + time_since_film,
            followed_positions,
            followed_velocities};
  }



  void
  ValveModel::save_octree(const std::string &name, const double *y)
  {
    const auto &at = system->layout();
    coapt::save_octree(
      name,
      *grid,
      *fluid,
      std::vector<double>(y + at.velocity(), y + at.pressure()),
      std::vector<double>(y + at.pressure(), y + at.position()));
  }



  void
  ValveModel::check_snapshot(const ValveSnapshot &snapshot) const
  {
    const auto check =
      [](const auto found, const auto expected, const std::string &what) {
        if (found != expected)
          throw InputError("the checkpoint has " + std::to_string(found) + " " +
                           what + ", but these parameters ask for " +
                           std::to_string(expected) +
                           ": a run can only go on with the same meshes");
      };
    check(snapshot.coarse_cells,
          grid->triangulation().n_cells(0),
          "coarse cells");
    check(snapshot.coarse_size,
          parameters.mesh.coarse_cell,
          "m as size of a coarse cell");
    check(snapshot.n_chordae, chordae->chordae().size(), "chordae");
    check(snapshot.system.positions.size() / 3,
          leaflet.mesh.points.size(),
          "nodes of the leaflets");
    check(snapshot.system.active.size(),
          points->active_points().size(),
          "coupling points");
  }



  std::vector<double>
  ValveModel::restore(const ValveSnapshot &snapshot, const std::string &octree)
  {
    points->set_active(snapshot.system.active);
    follow(snapshot.adapted_positions, snapshot.adapted_velocities);
    std::vector<double> velocity, pressure;
    load_octree(octree, *grid, *fluid, velocity, pressure);
    contact->restore(snapshot.contact);
    const std::vector<double> y =
      system->restore(snapshot.system, velocity, pressure);
    time_of_film = snapshot.time_of_film;
    if (!film)
      return y;
    if (!snapshot.film.turnover.empty())
      film->restore(snapshot.film);
    update_film(snapshot.system.positions.data());
    return y;
  }
} // namespace coapt
