#ifndef coapt_valve_task_h
#define coapt_valve_task_h

#include <coapt/coupled/valve_structure.h>
#include <coapt/task.h>
#include <coapt/valve_run.h>
#include <coapt/valve_study.h>

#include <memory>
#include <string>

namespace coapt
{
  /** The closure of a valve, or a study of several. */
  class ValveTask : public Task
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) const override;

    const RunParameters &
    read(const std::string &file, dealii::ParameterHandler &prm) override;

    void
    build(Log &log, MPI_Comm communicator) override;

    void
    check_checkpoint(const OutputFolder &folder) override;

    void
    run(const OutputFolder &folder) override;

    void
    preview(Log &log, MPI_Comm communicator) override;

  private:
    void
    write_preview(const ValveStructure &valve, Log &log) const;

    SimulationParameters parameters;
    VariedParameters varied;
    dealii::ParameterHandler *prm = nullptr; // of read()
    // one of them
    std::unique_ptr<ValveRun> simulation;
    std::unique_ptr<ValveStudy> study;
  };
} // namespace coapt

#endif
