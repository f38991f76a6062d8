#include <coapt/base/parameter_file.h>
#include <coapt/flow_task.h>

#include <filesystem>

namespace coapt
{
  FlowTask::FlowTask(const FlowContents contents) : contents(contents)
  {
    if (contents == FlowContents::bodies)
      parameters.immersed.emplace();
  }



  void
  FlowTask::declare_parameters(dealii::ParameterHandler &prm) const
  {
    FlowParameters::declare_parameters(prm, contents);
  }



  const RunParameters &
  FlowTask::read(const std::string &file, dealii::ParameterHandler &prm)
  {
    this->file = file;
    this->prm  = &prm;
    read_parameter_file(prm, file);
    with_file_name(file, [&]() { parameters.parse_parameters(prm); });
    return parameters.run;
  }



  void
  FlowTask::build(Log &log, MPI_Comm communicator)
  {
    const std::string folder =
      std::filesystem::path(file).parent_path().string();
    if (parameters.dimension == 2)
      plane_study = std::make_unique<RefinementStudy<2>>(
        parameters, *prm, folder, log, communicator);
    else
      space_study = std::make_unique<RefinementStudy<3>>(
        parameters, *prm, folder, log, communicator);
  }



  void
  FlowTask::check_checkpoint(const OutputFolder &folder)
  {
    if (plane_study)
      plane_study->check_checkpoint(folder);
    else
      space_study->check_checkpoint(folder);
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
