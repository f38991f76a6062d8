#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/base/serialization.h>
#include <coapt/simulation.h>

#include <fstream>
#include <sstream>

// How a simulation writes checkpoints and goes on from them: the octree with
// the fluid in files that all ranks share, and the rest, which is small, in one
// of the first rank.
namespace coapt
{
  namespace
  {
    // What a file of the state begins with; the number grows with its format.
    const std::string title = "coapt checkpoint 1\n";

    std::string
    octree_in(const std::string &folder)
    {
      return folder + "/octree";
    }

    std::string
    state_in(const std::string &folder)
    {
      return folder + "/state";
    }

    /** The content of a file, read by the first rank, on all. Throws
     * InputError.
     */
    std::string
    read_on_all(const std::string &file, MPI_Comm communicator)
    {
      std::ostringstream content;
      on_first_rank(communicator, [&]() -> std::string {
        std::ifstream in(file, std::ios::binary);
        return in && content << in.rdbuf() ? "" : file + ": cannot be read";
      });
      return dealii::Utilities::MPI::broadcast(communicator, content.str());
    }

    /** Reads the file of the first rank: the snapshot of the valve, and with @p
     * read_rest what follows it. Throws InputError. Collective. */
    template <typename ReadRest>
    ValveSnapshot
    read_state(const std::string &folder,
               MPI_Comm communicator,
               const ReadRest &read_rest)
    {
      const std::string file = state_in(folder);
      std::istringstream in(read_on_all(file, communicator));
      std::string found(title.size(), ' ');
      in.read(&found[0], found.size());
      if (found != title)
        throw InputError(file + " is no checkpoint, or one of another version");
      ValveSnapshot snapshot;
      try
        {
          boost::archive::binary_iarchive archive(in);
          archive >> snapshot;
          read_rest(archive);
        }
      catch (const boost::archive::archive_exception &error)
        {
          throw InputError(file + " is damaged (" + error.what() + ")");
        }
      return snapshot;
    }
  } // namespace



  template <class Archive>
  void
  Simulation::serialize(Archive &archive, ValveRecorder &recorder)
  {
    double time               = integrator.time();
    double wall               = earlier_wall + timing.wall_time();
    unsigned long steps       = integrator.n_steps();
    unsigned long evaluations = integrator.n_evaluations();
    archive &time &wall &steps &evaluations &last_adaptation &step_control;
    archive &solid_frequency &model &monitor &log;
    if (Archive::is_loading::value)
      {
        last_finite_time = time;
        earlier_wall     = wall - timing.wall_time();
        integrator.count_from(steps, evaluations);
      }
    archive &recorder;
  }



  void
  Simulation::check_checkpoint(const OutputFolder &folder)
  {
    if (folder.continues())
      model.check_snapshot(
        read_state(folder.checkpoint(), communicator, [](auto &) {}));
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
        200. * model.points->n_points() + 1e7,
      log);
    if (folder.empty())
      return;
    model.save_octree(octree_in(folder), state.data());
    const ValveSnapshot snapshot = model.snapshot(state.data());
    if (is_first_rank(communicator))
      {
        std::ofstream out(state_in(folder), std::ios::binary);
        out << title;
        boost::archive::binary_oarchive archive(out);
        archive << snapshot;
        serialize(archive, recorder);
        if (!out.flush())
          throw std::runtime_error(state_in(folder) +
                                   ": writing failed; is the disk full?");
      }
    checkpoints.finish();
  }



  void
  Simulation::load(const std::string &folder, ValveRecorder &recorder)
  {
    const ValveSnapshot snapshot =
      read_state(folder, communicator, [&](auto &archive) {
        serialize(archive, recorder);
      });
    state = model.restore(snapshot, octree_in(folder));
    integrator.start(last_finite_time, state);
    last_finite_state = state;
    log.line("goes on from " + folder + " at " +
             std::to_string(1e3 * integrator.time()) + " ms");
  }
} // namespace coapt
