#ifndef coapt_valve_task_h
#define coapt_valve_task_h

#include <coapt/simulation.h>
#include <coapt/task.h>

#include <memory>

namespace coapt
{
  /** The closure of a valve. */
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
    run(const OutputFolder &folder) override;

    void
    preview(Log &log, MPI_Comm communicator) override;

  private:
    SimulationParameters parameters;
    std::unique_ptr<Simulation> simulation;
  };
} // namespace coapt

#endif
