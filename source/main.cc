#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <coapt/base/exceptions.h>
#include <coapt/base/parameter_file.h>
#include <coapt/base/version.h>
#include <coapt/io/command_line.h>
#include <coapt/io/console.h>
#include <coapt/io/output_folder.h>
#include <coapt/task.h>

#include <iostream>

namespace
{
  using namespace coapt;

  /** Reads the parameters and builds what they ask for, and with Action::run,
   * runs it. */
  void
  treat_file(const CommandLine &command, MPI_Comm communicator)
  {
    Log log(communicator);
    dealii::ParameterHandler prm;
    const std::string name = task_of_file(command.file);
    const auto task        = make_task(name);
    declare_task(prm, name);
    task->declare_parameters(prm);
    const RunParameters &run = task->read(command.file, prm);
    if (command.action == CommandLine::Action::preview)
      return with_file_name(command.file,
                            [&]() { task->preview(log, communicator); });

    const OutputFolder folder(run.output_folder,
                              run.overwrite,
                              communicator,
                              run.resume);
    with_file_name(command.file, [&]() { task->build(log, communicator); });
    if (command.action == CommandLine::Action::check)
      {
        log.line(command.file + ": ok");
        return;
      }
    with_file_name(command.file, [&]() { task->check_checkpoint(folder); });
    folder.create();
    folder.write_parameters(prm, command.file);
    log.open(folder.file("coapt.log"), folder.continues());
    log.line(Console::banner(communicator));
    task->run(folder);
  }



  /** Prints all parameters of the task of this name. */
  void
  write_defaults(const std::string &task,
                 const dealii::ParameterHandler::OutputStyle style)
  {
    dealii::ParameterHandler prm;
    const auto chosen = make_task(task); // refuses unknown names
    declare_task(prm, task);
    chosen->declare_parameters(prm);
    prm.print_parameters(std::cout, style);
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
            write_defaults(command.task, dealii::ParameterHandler::PRM);
          break;
        case CommandLine::Action::write_json:
          if (is_first)
            write_defaults(command.task, dealii::ParameterHandler::JSON);
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
  catch (const std::bad_alloc &)
    {
      std::cerr << "coapt: there is not enough memory for this mesh\n"
                << std::flush;
      MPI_Abort(communicator, ExitCode::numerical_failure);
    }
  catch (const std::exception &error)
    {
      // Not an error that all ranks are known to share: end the others, too.
      // In one piece, for several ranks may speak at once.
      const std::string message = std::string("coapt: ") + error.what() + '\n';
      std::cerr << message << std::flush;
      MPI_Abort(communicator, ExitCode::numerical_failure);
    }
  return ExitCode::success;
}
