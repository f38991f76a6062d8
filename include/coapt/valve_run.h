#ifndef coapt_valve_run_h
#define coapt_valve_run_h

#include <coapt/base/log.h>
#include <coapt/base/run_parameters.h>
#include <coapt/coupled/model_parameters.h>
#include <coapt/io/output_folder.h>
#include <coapt/io/summary.h>
#include <coapt/structure/structure_parameters.h>
#include <coapt/time/step_control.h>

#include <memory>

namespace coapt
{
  /** All parameters of a valve's closure. */
  struct SimulationParameters
  {
    RunParameters run;
    StepParameters step;
    StructureParameters structure;
    ModelParameters model;

    /** Declares all parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. Throws InputError with the parameter and what is
     * allowed. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

  /** The closure of a valve, in blood or without fluid. */
  class ValveRun
  {
  public:
    virtual ~ValveRun() = default;

    /** Finds out whether the checkpoint in @p folder fits; throws InputError.
     * Writes nothing. Collective. */
    virtual void
    check_checkpoint(const OutputFolder &)
    {
    }

    /** Runs to the end time and writes into @p folder; throws
     * NumericalError. Returns the figures of the run, on the first rank.
     * Collective. */
    virtual Summary
    run(const OutputFolder &folder) = 0;
  };

  /** Builds the valve that the parameters describe and warns of what may go
   * wrong; throws InputError. Writes nothing. Collective. */
  std::unique_ptr<ValveRun>
  make_valve_run(const SimulationParameters &parameters,
                 Log &log,
                 MPI_Comm communicator);
} // namespace coapt

#endif
