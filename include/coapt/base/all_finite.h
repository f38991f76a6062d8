#ifndef coapt_base_all_finite_h
#define coapt_base_all_finite_h

#include <deal.II/base/mpi.h>

#include <cmath>
#include <vector>

namespace coapt
{
  /** Whether all @p values of all ranks are finite, and their sums as well.
   * Collective. */
  inline bool
  all_finite(const std::vector<double> &values, const MPI_Comm communicator)
  {
    // a sum is not finite if one of its terms is not
    double sum = 0;
    for (const double value : values)
      sum += value;
    return dealii::Utilities::MPI::min(std::isfinite(sum) ? 1 : 0,
                                       communicator) == 1;
  }
} // namespace coapt

#endif
