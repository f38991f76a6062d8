#include <deal.II/base/mpi.h>

#include <coapt/base/first_rank.h>
#include <coapt/io/checkpoint_folder.h>

#include <filesystem>

namespace coapt
{
  namespace
  {
    namespace fs = std::filesystem;

    // The second is there for as long as the third becomes the first.
    const char *const present  = "/checkpoint";
    const char *const previous = "/checkpoint-old";
    const char *const next     = "/checkpoint-new";

    /** Lets the first rank do @p action with files. Collective; throws
     * InputError if that fails. */
    template <typename Action>
    void
    with_files(MPI_Comm communicator, const Action &action)
    {
      on_first_rank(communicator, [&]() -> std::string {
        try
          {
            action();
          }
        catch (const fs::filesystem_error &error)
          {
            return std::string("checkpoint: ") + error.what();
          }
        return "";
      });
    }
  } // namespace



  CheckpointFolder::CheckpointFolder(const std::string &path,
                                     const double interval,
                                     MPI_Comm communicator)
    : path(path), interval(interval), communicator(communicator)
  {
  }



  bool
  CheckpointFolder::is_due() const
  {
    if (interval <= 0)
      return false;
    const std::chrono::duration<double> passed = Clock::now() - last;
    return dealii::Utilities::MPI::broadcast(communicator, passed.count()) >=
      interval;
  }



  std::string
  CheckpointFolder::begin(const double size, Log &log)
  {
    last          = Clock::now();
    bool has_room = false;
    with_files(communicator, [&]() {
      fs::remove_all(path + next);
      const double room = fs::space(path).available;
      has_room          = room > size;
      if (has_room)
        fs::create_directory(path + next);
      else
        log.warn("checkpoint",
                 "No checkpoint is written: it needs " +
                   std::to_string(static_cast<int>(1e-6 * size) + 1) +
                   " MB, and the disk has only " +
                   std::to_string(static_cast<int>(1e-6 * room)));
    });
    has_room = dealii::Utilities::MPI::broadcast(communicator, has_room);
    return has_room ? path + next : "";
  }



  void
  CheckpointFolder::finish()
  {
    // All ranks have written their parts.
    MPI_Barrier(communicator);
    with_files(communicator, [&]() {
      fs::remove_all(path + previous);
      if (fs::exists(path + present))
        fs::rename(path + present, path + previous);
      fs::rename(path + next, path + present);
      fs::remove_all(path + previous);
    });
  }



  std::string
  last_checkpoint(const std::string &path)
  {
    std::error_code code;
    for (const std::string name : {present, previous})
      if (fs::is_directory(path + name, code))
        return path + name;
    return fs::is_directory(path + "/run_1", code) ? path : "";
  }



  void
  remove_checkpoints(const std::string &path)
  {
    for (const std::string name : {present, previous, next})
      fs::remove_all(path + name);
  }
} // namespace coapt
