#ifndef coapt_io_energy_table_h
#define coapt_io_energy_table_h

#include <coapt/io/statistics.h>
#include <coapt/io/summary.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * The books of energy at the end of a run for people. A line for each of the
   * @p books, which are columns of statistics.csv, such as work_of_ends_J, that
   * is not zero; the last one, what is left over, also as @p relative_error.
   */
  std::string
  energy_table(const std::vector<Statistics::Entry> &books,
               const double relative_error);

  /** The same as an object for summary.json, all of it; keys are without the
   * unit. */
  Summary
  energy_summary(const std::vector<Statistics::Entry> &books);
} // namespace coapt

#endif
