#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/base/version.h>
#include <coapt/geometry/valve_generator.h>
#include <coapt/io/command_line.h>
#include <coapt/io/console.h>
#include <coapt/io/output_folder.h>
#include <coapt/simulation.h>

#include <iostream>

namespace
{
  using namespace coapt;

  /** Writes the valve as it is generated, beside where results would go. */
  void
  preview(const SimulationParameters &parameters,
          Log &log,
          MPI_Comm communicator)
  {
    Timing timing;
    ValveModel model(parameters.model, timing, communicator);
    model.state_at_rest(); // distributes the points that are checked
    model.check_resolution(log);
    const std::string folder = parameters.run.output_folder + "/geometry";
    on_first_rank(communicator, [&]() -> std::string {
      try
        {
          write_valve_preview(folder, model.leaflet, model.chordae->chordae());
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    });
    log.line("The valve is in " + folder);
  }



  /** Reads the parameters and builds the valve, and with Action::run, runs. */
  void
  treat_file(const CommandLine &command, MPI_Comm communicator)
  {
    Log log(communicator);
    dealii::ParameterHandler prm;
    SimulationParameters parameters;
    SimulationParameters::declare_parameters(prm);
    parameters.read(command.file, prm);
    if (command.action == CommandLine::Action::preview)
      return preview(parameters, log, communicator);

    const OutputFolder folder(parameters.run.output_folder,
                              parameters.run.overwrite,
                              communicator);
    Simulation simulation(parameters, log, communicator);
    if (command.action == CommandLine::Action::check)
      {
        log.line(command.file + ": ok");
        return;
      }
    folder.create();
    folder.write_parameters(prm, command.file);
    log.open(folder.file("coapt.log"));
    log.line(Console::banner(communicator));
    simulation.run(folder);
  }



  void
  write_defaults()
  {
    dealii::ParameterHandler prm;
    SimulationParameters::declare_parameters(prm);
    prm.print_parameters(std::cout, dealii::ParameterHandler::PRM);
  }



  void
  act(const CommandLine &command, MPI_Comm communicator)
  {
    const bool is_first =
      dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    switch (command.action)
      {
        case CommandLine::Action::run:
        case CommandLine::Action::check:
        case CommandLine::Action::preview:
          treat_file(command, communicator);
          break;
        case CommandLine::Action::write_defaults:
          if (is_first)
            write_defaults();
          break;
        case CommandLine::Action::version:
          if (is_first)
            std::cout << "coapt " << version() << std::endl;
          break;
        case CommandLine::Action::help:
          if (is_first)
            std::cout << CommandLine::usage() << std::endl;
          break;
      }
  }



  /** Says what is wrong, once if all ranks know it, and ends all ranks. */
  int
  fail(const std::string &what, const int code, MPI_Comm communicator)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      std::cerr << "coapt: " << what << std::endl;
    return code;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm communicator = MPI_COMM_WORLD;
  try
    {
      act(CommandLine::parse(argc, argv), communicator);
    }
  catch (const InputError &error)
    {
      return fail(error.what(), ExitCode::bad_input, communicator);
    }
  catch (const NumericalError &error)
    {
      return fail(error.what(), ExitCode::numerical_failure, communicator);
    }
  catch (const std::exception &error)
    {
      // Not an error that all ranks are known to share: end the others, too.
      std::cerr << "coapt: " << error.what() << std::endl;
      MPI_Abort(communicator, ExitCode::numerical_failure);
    }
  return ExitCode::success;
}
