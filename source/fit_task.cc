#include <deal.II/base/mpi.h>

#include <coapt/base/parameter_file.h>
#include <coapt/base/time_table.h>
#include <coapt/fit_task.h>
#include <coapt/laboratory/fit_report.h>
#include <coapt/laboratory/output_parameters.h>
#include <coapt/solid/stability.h>

#include <algorithm>
#include <filesystem>

namespace coapt
{
  void
  FitTask::declare_parameters(dealii::ParameterHandler &prm) const
  {
    FitParameters::declare_parameters(prm);
    declare_output(prm);
  }



  const RunParameters &
  FitTask::read(const std::string &file, dealii::ParameterHandler &prm)
  {
    this->file = file;
    read_parameter_file(prm, file);
    with_file_name(file, [&]() {
      parameters.parse_parameters(prm);
      parse_output(prm, run_parameters);
    });
    return run_parameters;
  }



  void
  FitTask::build(Log &log, MPI_Comm communicator)
  {
    this->log          = &log;
    this->communicator = communicator;
    const std::string folder =
      std::filesystem::path(file).parent_path().string();
    data = BiaxialData::from_file(find_input_file(parameters.data_file, folder),
                                  parameters.measure,
                                  parameters.unit);
    for (const std::string &material : parameters.materials)
      {
        models.push_back(parameters.model(material));
        TissueFit(*models.back(), data, parameters.options); // enough data?
      }
  }



  void
  FitTask::run(const OutputFolder &folder)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    for (const auto &model : models)
      fit(*model, folder);
    log->line("tools/plot_fit " + folder.file("") + " draws the results");
  }



  void
  FitTask::fit(const TissueModel &model, const OutputFolder &folder)
  {
    const FitResult result = TissueFit(model, data, parameters.options).fit();
    log->line(fit_text(model, result));
    const std::string block = material_block(model, data, result);
    write_text(folder.file("material_" + model.name() + ".prm"), block);
    write_text(folder.file("fit_" + model.name() + ".csv"),
               comparison_table(data, result));
    write_text(folder.file("profile_" + model.name() + ".csv"),
               profile_table(result));
    log->line(block);

    double lowest = 1, highest = 1;
    for (const auto &point : data.points)
      for (const double stretch : point.stretch)
        {
          lowest  = std::min(lowest, stretch);
          highest = std::max(highest, stretch);
        }
    dealii::ParameterHandler prm;
    SolidParameters solid;
    SolidParameters::declare_parameters(prm);
    prm.parse_input_from_string(block);
    solid.parse_parameters(prm);
    solid.lowest_stretch  = lowest;
    solid.highest_stretch = highest;
    warn_if_unstable(solid, *log);
  }
} // namespace coapt
