#ifndef coapt_flow_refinement_study_h
#define coapt_flow_refinement_study_h

#include <coapt/flow/flow_run.h>
#include <coapt/io/study.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * A series of runs of the same flow, over levels of refinement or over the
   * values of parameters, with a table of cost, errors and their orders: the
   * power of the cell size with which an error falls from the run before, or
   * the inverse power of the first of the varied parameters.
   */
  template <int dim>
  class RefinementStudy
  {
  public:
    /** The @p parameters have been read from @p prm. All runs are built once,
     * so that input errors show. Throws InputError. Collective. */
    RefinementStudy(const FlowParameters &parameters,
                    dealii::ParameterHandler &prm,
                    const std::string &folder_of_file,
                    Log &log,
                    MPI_Comm communicator);

    /** Finds out whether the table in @p folder is one of this study, where it
     * is to go on; throws InputError. Writes nothing. Collective. */
    void
    check_checkpoint(const OutputFolder &folder) const;

    /** Runs all, each into a folder of its own below @p folder, in which
     * study.csv and summary.json are kept up to date. Collective. */
    void
    run(const OutputFolder &folder);

    /** What the runs gave; of those that were there already, sizes and errors.
     */
    const std::vector<FlowResult> &
    results() const
    {
      return all_results;
    }

    /** The order of the L2 error of the velocity in the last run. */
    double
    last_velocity_order() const;

  private:
    /** One run to do. */
    struct Case
    {
      std::string label;
      Study::Row columns; // what is special of it
      unsigned int level;
      FlowParameters parameters;
    };

    /** What the runs are, in words. */
    std::vector<std::string>
    plan() const;

    /** Columns of study.csv of a run. */
    Study::Row
    row(const unsigned int i) const;

    /** Exponent of the change of an error since the run before. */
    double
    order(const unsigned int i, double FlowErrors::*error) const;

    FlowParameters parameters;
    std::vector<ReferenceValue<dim>> reference;
    Log &log;
    MPI_Comm communicator;
    std::vector<Case> cases;
    std::vector<FlowResult> all_results;
  };
} // namespace coapt

#endif
