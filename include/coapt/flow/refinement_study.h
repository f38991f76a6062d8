#ifndef coapt_flow_refinement_study_h
#define coapt_flow_refinement_study_h

#include <coapt/flow/flow_run.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * A series of runs of the same flow, over levels of refinement or over the
   * values of one parameter, with a table of cost, errors and their orders:
   * the power of the cell size with which an error falls from the run before,
   * or the inverse power of the varied parameter.
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

    /** Runs all, each into a folder of its own below @p folder, in which
     * study.csv and summary.json are kept up to date. Collective. */
    void
    run(const OutputFolder &folder);

    /** What the runs gave. */
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
      double value; // level, or of the varied parameter
      unsigned int level;
      FlowParameters parameters;
    };

    using Row = std::vector<std::pair<std::string, double>>;

    /** The parameters with the varied one set to @p value. */
    FlowParameters
    with_value(dealii::ParameterHandler &prm, const double value) const;

    /** Columns of study.csv of a run. */
    Row
    row(const unsigned int i) const;

    /** Exponent of the change of an error since the run before. */
    double
    order(const unsigned int i, double FlowErrors::*error) const;

    void
    write_table(const std::string &file) const;

    void
    write_summary(const std::string &file) const;

    void
    print_table() const;

    FlowParameters parameters;
    std::vector<ReferenceValue<dim>> reference;
    Log &log;
    MPI_Comm communicator;
    std::vector<Case> cases;
    std::vector<FlowResult> all_results;
  };
} // namespace coapt

#endif
