#ifndef coapt_task_h
#define coapt_task_h

#include <coapt/base/log.h>
#include <coapt/base/run_parameters.h>
#include <coapt/io/output_folder.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>

namespace coapt
{
  /**
   * What the program can compute. The parameter file chooses it by its entry
   * "Task", and only the parameters of that task are known then. Calls come in
   * the order of the functions; all are collective.
   */
  class Task
  {
  public:
    virtual ~Task() = default;

    /** Declares its parameters. */
    virtual void
    declare_parameters(dealii::ParameterHandler &prm) const = 0;

    /** Reads @p file into @p prm and from there; throws InputError. */
    virtual const RunParameters &
    read(const std::string &file, dealii::ParameterHandler &prm) = 0;

    /** Builds what runs and finds out whether all fits together; throws
     * InputError. Writes nothing. */
    virtual void
    build(Log &log, MPI_Comm communicator) = 0;

    /** Finds out whether the checkpoint fits that the run is to go on from;
     * throws InputError. Writes nothing. */
    virtual void
    check_checkpoint(const OutputFolder &folder);

    /** Runs and writes into @p folder; throws NumericalError. */
    virtual void
    run(const OutputFolder &folder) = 0;

    /** Writes the geometry for a look at it, instead of build() and run();
     * throws InputError if there is nothing to see. */
    virtual void
    preview(Log &log, MPI_Comm communicator);
  };

  /** The task of this name. Throws InputError if there is none. */
  std::unique_ptr<Task>
  make_task(const std::string &name);

  /** Declares the entry "Task" with @p name as default. */
  void
  declare_task(dealii::ParameterHandler &prm, const std::string &name);

  /** The name of the task of a parameter file; throws InputError. */
  std::string
  task_of_file(const std::string &file);
} // namespace coapt

#endif
