#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/base/serialization.h>
#include <coapt/io/checkpoint_file.h>
#include <coapt/simulation.h>

#include <sstream>

// How a simulation writes checkpoints and goes on from them: the octree with
// the fluid in files that all ranks share, and the rest, which is small, in one
// of the first rank.
namespace coapt
{
  namespace
  {
    const std::string kind = "valve";

    std::string
    octree_in(const std::string &folder)
    {
      return folder + "/octree";
    }
  } // namespace



  template <class Archive>
  void
  Simulation::serialize(Archive &archive, ValveRecorder &recorder)
  {
    double wall = earlier_wall + timing.wall_time();
    archive &wall &integrator &last_adaptation &step_control;
    archive &solid_frequency &model &monitor &log;
    if (Archive::is_loading::value)
      earlier_wall = wall - timing.wall_time();
    archive &recorder;
  }



  void
  Simulation::check_checkpoint(const OutputFolder &folder)
  {
    if (!folder.continues())
      return;
    std::istringstream in(
      read_checkpoint_file(folder.checkpoint(), kind, communicator));
    boost::archive::binary_iarchive archive(in);
    ValveSnapshot snapshot;
    double time          = 0;
    std::size_t n_planes = 0;
    archive >> snapshot >> time >> n_planes;
    parameters.run.check_end_time(time);
    model.check_snapshot(snapshot);
    if (n_planes != parameters.run.flow_planes.size())
      throw InputError("Output/Flow planes has " +
                       std::to_string(parameters.run.flow_planes.size()) +
                       " planes, but must have as many as the checkpoint, " +
                       std::to_string(n_planes));
  }



  void
  Simulation::save(CheckpointFolder &checkpoints, ValveRecorder &recorder)
  {
    const auto scope = timing.scope(sections.output);
    // Per cell 25 numbers of eight bytes and its place, per node and point of
    // the solid a few; twice that.
    const std::string folder = checkpoints.begin(
      500. * model.grid->triangulation().n_global_active_cells() +
        500. * model.leaflet.mesh.points.size() +
        200. * model.points->n_points() + 1e6,
      log);
    if (folder.empty())
      return;
    model.save_octree(octree_in(folder), state.data());
    const ValveSnapshot snapshot = model.snapshot(state.data());
    if (is_first_rank(communicator))
      {
        std::ostringstream out;
        boost::archive::binary_oarchive archive(out);
        const double time          = integrator.time();
        const std::size_t n_planes = parameters.run.flow_planes.size();
        archive << snapshot << time << n_planes;
        serialize(archive, recorder);
        write_checkpoint_file(folder, kind, out.str());
      }
    checkpoints.finish(log);
  }



  void
  Simulation::load(const std::string &folder, ValveRecorder &recorder)
  {
    std::istringstream in(read_checkpoint_file(folder, kind, communicator));
    boost::archive::binary_iarchive archive(in);
    ValveSnapshot snapshot;
    std::size_t n_planes = 0;
    archive >> snapshot >> last_finite_time >> n_planes;
    serialize(archive, recorder);
    state = model.restore(snapshot, octree_in(folder));
    integrator.start(last_finite_time, state);
    last_finite_state = state;
    log.line("goes on from " + folder + " at " +
             std::to_string(1e3 * integrator.time()) + " ms");
  }
} // namespace coapt
