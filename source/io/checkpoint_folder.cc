#include <deal.II/base/mpi.h>

#include <coapt/base/first_rank.h>
#include <coapt/io/checkpoint_folder.h>

#include <cmath>
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

    std::string
    megabytes(const double bytes)
    {
      return std::to_string(std::lround(1e-6 * bytes)) + " MB";
    }

    /** Lets the first rank do @p action with files, which says what is wrong,
     * and warns of that. Returns whether all is well. Collective. */
    template <typename Action>
    bool
    with_files(MPI_Comm communicator, Log &log, const Action &action)
    {
      std::string error;
      if (is_first_rank(communicator))
        try
          {
            error = action();
          }
        catch (const fs::filesystem_error &exception)
          {
            error = exception.what();
          }
      if (!error.empty())
        log.warn("checkpoint", "No checkpoint is written: " + error);
      return dealii::Utilities::MPI::broadcast(communicator, error.empty());
    }
  } // namespace



  CheckpointFolder::CheckpointFolder(const std::string &path,
                                     const double interval,
                                     const bool has_one,
                                     MPI_Comm communicator)
    : path(path)
    , interval(interval)
    , communicator(communicator)
    , has_one(has_one)
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
    last                = Clock::now();
    const bool is_ready = with_files(communicator, log, [&]() -> std::string {
      fs::remove_all(path + next);
      const double room = fs::space(path).available;
      if (room < size)
        return "it needs " + megabytes(size) + ", and the disk has only " +
          megabytes(room);
      fs::create_directory(path + next);
      return "";
    });
    return is_ready ? path + next : "";
  }



  void
  CheckpointFolder::finish(Log &log)
  {
    // All ranks have written their parts.
    MPI_Barrier(communicator);
    const bool is_there = with_files(communicator, log, [&]() -> std::string {
      if (fs::exists(path + present))
        {
          fs::remove_all(path + previous);
          fs::rename(path + present, path + previous);
        }
      fs::rename(path + next, path + present);
      fs::remove_all(path + previous);
      return "";
    });
    has_one             = has_one || is_there;
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
  remove_unfinished_checkpoint(const std::string &path)
  {
    fs::remove_all(path + next);
  }



  void
  remove_checkpoints(const std::string &path)
  {
    for (const std::string name : {present, previous, next})
      fs::remove_all(path + name);
  }
} // namespace coapt
