#include <deal.II/base/mpi.h>

#include <coapt/base/parameter_file.h>
#include <coapt/base/time_table.h>
#include <coapt/biaxial_task.h>
#include <coapt/laboratory/output_parameters.h>
#include <coapt/solid/stability.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace coapt
{
  void
  BiaxialTask::declare_parameters(dealii::ParameterHandler &prm) const
  {
    BiaxialParameters::declare_parameters(prm);
    declare_output(prm);
  }



  const RunParameters &
  BiaxialTask::read(const std::string &file, dealii::ParameterHandler &prm)
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
  BiaxialTask::build(Log &log, MPI_Comm communicator)
  {
    this->log          = &log;
    this->communicator = communicator;
    const std::string folder =
      std::filesystem::path(file).parent_path().string();
    protocol = BiaxialProtocol::from_file(
      find_input_file(parameters.protocol_file, folder));
    test = std::make_unique<BiaxialTest>(parameters, protocol);
    warn_if_unstable(parameters.solid, log);
  }



  void
  BiaxialTask::run(const OutputFolder &folder)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    if (parameters.quasi_static)
      write_text(folder.file("quasi_static.csv"), pass_through(false));
    if (parameters.dynamic)
      write_text(folder.file("dynamic.csv"), pass_through(true));
  }



  std::string
  BiaxialTask::pass_through(const bool dynamic)
  {
    std::ostringstream table;
    table.precision(10);
    table << "protocol,stretch1,stretch2,stress1_kPa,stress2_kPa,"
             "homogeneous1_kPa,homogeneous2_kPa,steps\n";
    double difference = 0, largest = 0;
    for (std::size_t i = 0; i < protocol.states.size(); ++i)
      {
        const auto &state = protocol.states[i];
        if (i == 0 || state.protocol != protocol.states[i - 1].protocol)
          test->reset();
        const BiaxialResult result =
          dynamic ? test->settle(state) : test->equilibrium(state);
        const SheetState exact = test->homogeneous(result.stretch);
        table << state.protocol;
        for (const double stretch : result.stretch)
          table << ',' << stretch;
        for (const double stress : result.stress)
          table << ',' << stress / 1e3;
        for (int d = 0; d < 2; ++d)
          {
            table << ',' << exact.P[d][d] / 1e3;
            difference =
              std::max(difference, std::abs(result.stress[d] - exact.P[d][d]));
            largest = std::max(largest, std::abs(exact.P[d][d]));
          }
        table << ',' << result.n_steps << '\n';
      }
    std::ostringstream text;
    text.precision(3);
    text << (dynamic ? "explicit dynamics" : "Newton's method") << ": "
         << protocol.states.size() << " states, largest stress "
         << largest / 1e3 << " kPa, farthest from the homogeneous state "
         << (largest > 0 ? difference / largest : 0.) << " of it";
    log->line(text.str());
    return table.str();
  }
} // namespace coapt
