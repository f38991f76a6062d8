#ifndef coapt_biaxial_task_h
#define coapt_biaxial_task_h

#include <coapt/laboratory/biaxial_test.h>
#include <coapt/task.h>

#include <memory>
#include <string>

namespace coapt
{
  /** The biaxial test of a sheet of finite elements. The first rank computes,
   * for it takes seconds. */
  class BiaxialTask : public Task
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
    /** Passes through all states by Newton's method or by explicit dynamics;
     * returns the table of them. */
    std::string
    pass_through(const bool dynamic);

    BiaxialParameters parameters;
    RunParameters run_parameters;
    std::string file;
    Log *log = nullptr; // of build()
    MPI_Comm communicator;
    BiaxialProtocol protocol;
    std::unique_ptr<BiaxialTest> test;
  };
} // namespace coapt

#endif
