#ifndef coapt_io_study_h
#define coapt_io_study_h

#include <coapt/base/log.h>
#include <coapt/io/output_folder.h>
#include <coapt/io/summary.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  /**
   * A series of runs, each into a folder of its own, run_1, run_2 and so on,
   * with a table of what they gave: study.csv and summary.json, which are kept
   * up to date, and lines in the log at the end. A study that was interrupted
   * goes on with the first run that is not in the table.
   */
  class Study
  {
  public:
    /** Names and values of the columns; not-a-number if there is no value. */
    using Row = std::vector<std::pair<std::string, double>>;

    /** Does the run of this number (from 0) into the folder, given the rows of
     * those before. Collective; only the row of the first rank matters, and the
     * others need not know the figures. */
    using Run = std::function<
      Row(const unsigned int, const OutputFolder &, const std::vector<Row> &)>;

    Study(Log &log, MPI_Comm communicator);

    /** Does the runs of the @p plan, which says of each in words what it is.
     * The summary begins with @p header. Collective. */
    void
    run(const std::vector<std::string> &plan,
        const Run &run,
        const Summary &header,
        const OutputFolder &folder);

    /** Finds out whether the study in @p folder, if it is to go on there, had
     * this @p plan so far as it has come; throws InputError. Collective. */
    static void
    check_plan(const OutputFolder &folder,
               const std::vector<std::string> &plan,
               MPI_Comm communicator);

  private:
    /** Names of the columns of all rows, in the order in which they come. */
    std::vector<std::string>
    columns() const;

    void
    write_table(const std::string &file) const;

    void
    write_summary(Summary summary,
                  const unsigned int n_runs,
                  const std::string &file) const;

    /** Without the columns that are empty in the last row. */
    void
    print_table() const;

    Log &log;
    MPI_Comm communicator;
    std::vector<Row> rows;
  };
} // namespace coapt

#endif
