#ifndef coapt_io_statistics_h
#define coapt_io_statistics_h

#include <coapt/base/growing_file.h>

#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  /**
   * A table over time: one header line, then one row an output interval, with
   * comma-separated numbers of twelve digits. The first rank writes each row
   * to the disk at once, so that an interrupted run keeps what it has.
   */
  class Statistics
  {
  public:
    /** A name with its unit, such as `flow_mL_per_s`, and the value. */
    using Entry = std::pair<std::string, double>;

    /**
     * Starts the table in @p file, or goes on with it if it @p continues that
     * of an earlier run.
     *
     * @throws std::runtime_error on the first rank alone if it cannot be
     * written; all ranks must then be ended.
     */
    Statistics(const std::string &file,
               const MPI_Comm communicator,
               const bool continues = false);

    /** Writes a row; the first one gives the header. All rows must have the
     * same names in the same order (std::logic_error otherwise). */
    void
    write_row(const std::vector<Entry> &row);

    /** Saves or restores how far the table has come. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &table &names;
    }

  private:
    const std::string file;
    const bool is_first_rank;
    GrowingFile table;
    std::vector<std::string> names;
  };
} // namespace coapt

#endif
