#ifndef coapt_valve_study_h
#define coapt_valve_study_h

#include <coapt/base/varied_parameters.h>
#include <coapt/io/study.h>
#include <coapt/valve_run.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * Closures of a valve that differ in some parameters, such as those of its
   * meshes, with a table of what they cost and gave: each figure with its
   * relative change from the run before.
   */
  class ValveStudy
  {
  public:
    /** The @p parameters have been read from @p prm. All valves are built
     * once, so that what does not fit shows before hours of computation.
     * Throws InputError. Collective. */
    ValveStudy(const SimulationParameters &parameters,
               const VariedParameters &varied,
               dealii::ParameterHandler &prm,
               Log &log,
               MPI_Comm communicator);

    /** Finds out whether the table in @p folder is one of this study, where it
     * is to go on; throws InputError. Writes nothing. Collective. */
    void
    check_checkpoint(const OutputFolder &folder) const;

    /** Runs all, each into a folder of its own below @p folder, with a table of
     * them there. Throws NumericalError. Collective. */
    void
    run(const OutputFolder &folder);

  private:
    /** What the runs are, in words. */
    std::vector<std::string>
    plan() const;

    /** Runs one; returns its columns of the table, of which those @p before are
     * known. */
    Study::Row
    run_one(const unsigned int i,
            const OutputFolder &folder,
            const std::vector<Study::Row> &before);

    VariedParameters varied;
    Log &log;
    MPI_Comm communicator;
    std::vector<SimulationParameters> cases;
  };
} // namespace coapt

#endif
