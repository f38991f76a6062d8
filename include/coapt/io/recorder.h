#ifndef coapt_io_recorder_h
#define coapt_io_recorder_h

#include <coapt/base/log.h>
#include <coapt/base/run_parameters.h>
#include <coapt/io/console.h>
#include <coapt/io/fields.h>
#include <coapt/io/output_folder.h>
#include <coapt/io/statistics.h>
#include <coapt/io/valve_report.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * Everything that a run leaves behind: a line on the terminal and a row of
   * statistics at each output interval, fields at theirs, the summary at the
   * end; and warnings of states that are not to be trusted.
   */
  class Recorder
  {
  public:
    Recorder(const RunParameters &parameters,
             const OutputFolder &folder,
             const ValveModel &model,
             ValveMonitor &monitor,
             Log &log);

    /** Samples and writes what is due at time @p t. Collective. */
    void
    record(const double t,
           const double *y,
           const RunCost &cost,
           const std::string &limiter);

    /** Writes all fields at time @p t, due or not. Collective. */
    void
    write_fields(const double t, const double *y);

    /** Writes the fields at the end of the run, unless that has been done or
     * none are wanted. Collective. */
    void
    finish(const double t, const double *y);

    /** Writes summary.json and the maps of the closed valve, and returns the
     * former; on other ranks than the first, it is empty. */
    Summary
    write_summary(const RunCost &cost) const;

  private:
    void
    warn(const ValveSample &sample) const;

    /** Warns of noise that does not belong into a valve that is shut; before,
     * the flow itself alternates on coarse cells. */
    void
    warn_of_unrest(const ValveSample &sample) const;

    const OutputFolder &folder;
    const ValveModel &model;
    ValveMonitor &monitor;
    Log &log;
    Console console;
    Statistics statistics, chordae_table;
    FieldsWriter fields;
    ValveReport report;
    double fields_interval;
    double next_fields = 0;
    double last_fields = -1;
  };
} // namespace coapt

#endif
