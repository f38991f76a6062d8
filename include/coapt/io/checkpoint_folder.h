#ifndef coapt_io_checkpoint_folder_h
#define coapt_io_checkpoint_folder_h

#include <coapt/base/log.h>

#include <mpi.h>

#include <chrono>
#include <string>

namespace coapt
{
  /**
   * Where a run keeps its last checkpoint: the folder "checkpoint" of its
   * output folder. The next one is written beside it and takes its place when
   * it is complete, so that there is always one to go on from.
   */
  class CheckpointFolder
  {
  public:
    /** In the output folder @p path, which @p has_one already or not, one each
     * @p interval (s of wall time), none if that is zero. */
    CheckpointFolder(const std::string &path,
                     const double interval,
                     const bool has_one,
                     MPI_Comm communicator);

    /** Whether it is time for the next one. Collective. */
    bool
    is_due() const;

    /**
     * Begins a checkpoint of about @p size bytes; returns the path of the
     * folder for its files, which exists. If the disk has no room for that or
     * the folder cannot be made, it warns and returns an empty path.
     * Collective.
     */
    std::string
    begin(const double size, Log &log);

    /** Puts the complete checkpoint in the place of the last one; warns if that
     * fails. Collective. */
    void
    finish(Log &log);

    /** Whether one is to be written at the end of the run, so that it is not
     * done again: if there is an earlier one. */
    bool
    is_due_at_end() const
    {
      return interval > 0 && has_one;
    }

  private:
    using Clock = std::chrono::steady_clock;

    const std::string path;
    const double interval;
    const MPI_Comm communicator;
    Clock::time_point last = Clock::now();
    bool has_one;
  };

  /** Path of the complete checkpoint in the output folder @p path, or if that
   * is the folder of a study, this path; empty if there is none. */
  std::string
  last_checkpoint(const std::string &path);

  /** Removes one that was being written when its run ended; throws
   * std::filesystem::filesystem_error. */
  void
  remove_unfinished_checkpoint(const std::string &path);

  /** Removes all checkpoints from the output folder @p path; throws
   * std::filesystem::filesystem_error. */
  void
  remove_checkpoints(const std::string &path);
} // namespace coapt

#endif
