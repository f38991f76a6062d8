#ifndef coapt_flow_task_h
#define coapt_flow_task_h

#include <coapt/flow/refinement_study.h>
#include <coapt/task.h>

#include <memory>
#include <string>

namespace coapt
{
  /** The flow of a fluid in a box, alone or with elastic bodies in it, at
   * several levels of refinement. */
  class FlowTask : public Task
  {
  public:
    explicit FlowTask(const FlowContents contents);

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

  private:
    FlowContents contents;
    FlowParameters parameters;
    std::string file;
    dealii::ParameterHandler *prm = nullptr; // of read()
    // the one of Flow/Dimension
    std::unique_ptr<RefinementStudy<2>> plane_study;
    std::unique_ptr<RefinementStudy<3>> space_study;
  };
} // namespace coapt

#endif
