#include <coapt/base/exceptions.h>
#include <coapt/base/parameter_file.h>
#include <coapt/flow_task.h>

#include <filesystem>

namespace coapt
{
  void
  FlowTask::declare_parameters(dealii::ParameterHandler &prm) const
  {
    FlowParameters::declare_parameters(prm);
  }



  const RunParameters &
  FlowTask::read(const std::string &file, dealii::ParameterHandler &prm)
  {
    this->file = file;
    this->prm  = &prm;
    read_parameter_file(prm, file);
    try
      {
        parameters.parse_parameters(prm);
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
    return parameters.run;
  }



  void
  FlowTask::build(Log &log, MPI_Comm communicator)
  {
    const std::string folder =
      std::filesystem::path(file).parent_path().string();
    try
      {
        if (parameters.dimension == 2)
          plane_study = std::make_unique<RefinementStudy<2>>(
            parameters, *prm, folder, log, communicator);
        else
          space_study = std::make_unique<RefinementStudy<3>>(
            parameters, *prm, folder, log, communicator);
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
  }



  void
  FlowTask::run(const OutputFolder &folder)
  {
    if (plane_study)
      plane_study->run(folder);
    else
      space_study->run(folder);
  }
} // namespace coapt
