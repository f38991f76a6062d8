#ifndef coapt_fit_task_h
#define coapt_fit_task_h

#include <coapt/laboratory/fit_parameters.h>
#include <coapt/task.h>

#include <memory>
#include <string>
#include <vector>

namespace coapt
{
  /** Materials fitted to the data of a biaxial test. The first rank computes,
   * for it takes seconds. */
  class FitTask : public Task
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

  private:
    /** Fits one material and writes what was found. */
    void
    fit(const TissueModel &model, const OutputFolder &folder);

    FitParameters parameters;
    RunParameters run_parameters;
    std::string file;
    Log *log = nullptr; // of build()
    MPI_Comm communicator;
    BiaxialData data;
    std::vector<std::unique_ptr<TissueModel>> models;
  };
} // namespace coapt

#endif
