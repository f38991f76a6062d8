#ifndef coapt_io_checkpoint_file_h
#define coapt_io_checkpoint_file_h

#include <mpi.h>

#include <string>

namespace coapt
{
  /**
   * Writes @p content to the file "state" of a checkpoint's folder, with what
   * tells later whether it is of this @p kind (one word) and all is there: a
   * checksum, and the sizes of the other files in the folder, which must be
   * complete.
   *
   * @throws std::runtime_error if it cannot be written.
   */
  void
  write_checkpoint_file(const std::string &folder,
                        const std::string &kind,
                        const std::string &content);

  /** Reads that content on the first rank, for all. Collective. @throws
   * InputError if there is no such file, or it is damaged, or other files of
   * the folder are missing or have other sizes. */
  std::string
  read_checkpoint_file(const std::string &folder,
                       const std::string &kind,
                       MPI_Comm communicator);
} // namespace coapt

#endif
