#ifndef coapt_base_first_rank_h
#define coapt_base_first_rank_h

#include <coapt/base/exceptions.h>

#include <mpi.h>

#include <string>

namespace coapt
{
  /** Whether this is the rank that talks and writes. */
  inline bool
  is_first_rank(const MPI_Comm communicator)
  {
    int rank;
    MPI_Comm_rank(communicator, &rank);
    return rank == 0;
  }

  /**
   * Lets the first rank do @p action, which returns what went wrong as a text,
   * empty if nothing did, or throws an InputError. Collective.
   *
   * @throws InputError of this text on all ranks.
   */
  template <typename Action>
  void
  on_first_rank(const MPI_Comm communicator, const Action &action)
  {
    std::string error;
    try
      {
        if (is_first_rank(communicator))
          error = action();
      }
    catch (const InputError &what)
      {
        error = what.what();
      }
    int size = error.size();
    MPI_Bcast(&size, 1, MPI_INT, 0, communicator);
    error.resize(size);
    MPI_Bcast(&error[0], size, MPI_CHAR, 0, communicator);
    if (size > 0)
      throw InputError(error);
  }
} // namespace coapt

#endif
