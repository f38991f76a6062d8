#ifndef coapt_io_recorder_h
#define coapt_io_recorder_h

#include <coapt/base/log.h>
#include <coapt/base/run_parameters.h>
#include <coapt/io/console.h>
#include <coapt/io/fields.h>
#include <coapt/io/output_folder.h>
#include <coapt/io/statistics.h>
#include <coapt/io/valve_report.h>
#include <coapt/metrics/structure_monitor.h>
#include <coapt/metrics/valve_monitor.h>
#include <coapt/structure/surface_load.h>

#include <memory>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * Everything that a run leaves behind: a line on the terminal and a row of
   * statistics at each output interval, fields at theirs, the summary at the
   * end; and warnings of states that are not to be trusted. What a state holds
   * is for the derived classes to know.
   */
  class Recorder
  {
  public:
    Recorder(const RunParameters &parameters,
             const OutputFolder &folder,
             const ValveStructure &valve,
             const LeafletMonitor &monitor,
             const ReportSettings &settings,
             Log &log);

    virtual ~Recorder() = default;

    /** Samples and writes what is due at time @p t. Collective. */
    void
    record(const double t,
           const double *y,
           const RunCost &cost,
           const std::string &limiter);

    /** Writes all fields at time @p t, due or not. Collective. */
    virtual void
    write_fields(const double t, const double *y) = 0;

    /** Writes the fields at the end of the run, unless that has been done or
     * none are wanted. Collective. */
    void
    finish(const double t, const double *y);

    /** Writes summary.json and the maps of the closed valve, and returns the
     * former; on other ranks than the first, it is empty. */
    Summary
    write_summary(const RunCost &cost) const;

    /** Saves or restores what has been recorded. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &fields &statistics &chordae_table &report &next_fields;
      archive &last_fields;
    }

  protected:
    /** Measures the state @p y. Collective. */
    virtual ValveSample
    sample(const double t, const double *y) = 0;

    /** Writes leaflet and chordae with the nodal positions @p X and velocities
     * @p V. Collective. */
    void
    write_leaflet(const double t,
                  const std::vector<double> &X,
                  const std::vector<double> &V);

    const OutputFolder &folder;
    Log &log;
    FieldsWriter fields;

  private:
    /** Warns of what is wrong with a state. */
    void
    warn(const ValveSample &sample) const;

    const ValveStructure &valve;
    const LeafletMonitor &monitor;
    const bool in_blood;
    Console console;
    Statistics statistics, chordae_table;
    ValveReport report;
    double fields_interval;
    double next_fields = 0;
    double last_fields = -1;
  };



  /** Records a valve in blood. */
  class ValveRecorder : public Recorder
  {
  public:
    ValveRecorder(const RunParameters &parameters,
                  const OutputFolder &folder,
                  const ValveModel &model,
                  ValveMonitor &monitor,
                  Log &log);

    void
    write_fields(const double t, const double *y) override;

    /** Saves or restores what has been recorded. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int version)
    {
      Recorder::serialize(archive, version);
      GrowingFile none; // on other ranks, and if it is not wanted
      archive &(surface_load ? surface_load->file() : none);
    }

  protected:
    /** Writes the surface load, too, if that is wanted. */
    ValveSample
    sample(const double t, const double *y) override;

  private:
    const ValveModel &model;
    ValveMonitor &monitor;
    std::unique_ptr<SurfaceLoadFile> surface_load;
  };



  /** Records a valve without fluid. States hold positions, then velocities. */
  class StructureRecorder : public Recorder
  {
  public:
    StructureRecorder(const RunParameters &parameters,
                      const OutputFolder &folder,
                      const ValveStructure &valve,
                      StructureMonitor &monitor,
                      Log &log);

    void
    write_fields(const double t, const double *y) override;

  protected:
    ValveSample
    sample(const double t, const double *y) override;

  private:
    /** One half of a state. */
    std::vector<double>
    half(const double *y, const unsigned int i) const;

    const unsigned int n_entries; // of positions
    StructureMonitor &monitor;
  };
} // namespace coapt

#endif
