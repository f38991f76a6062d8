// Output folder, statistics, summary, terminal, command line.
#include <coapt/base/run_parameters.h>
#include <coapt/io/command_line.h>
#include <coapt/io/console.h>
#include <coapt/io/output_folder.h>
#include <coapt/io/statistics.h>
#include <coapt/io/summary.h>

#include <deal.II/base/parameter_handler.h>

#include "tests.h"

#include <filesystem>
#include <fstream>
#include <limits>

using namespace coapt;
namespace fs = std::filesystem;

const MPI_Comm comm = MPI_COMM_WORLD;

bool
first_rank()
{
  return dealii::Utilities::MPI::this_mpi_process(comm) == 0;
}

std::string
content(const std::string &file)
{
  std::ifstream stream(file);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

void
check_folder()
{
  if (first_rank())
    {
      fs::remove_all("results");
      std::ofstream("in.prm") << "subsection Time\n set End time = 0.2\nend\n";
    }
  MPI_Barrier(comm);
  const OutputFolder folder("results/run", false, comm);
  check("looking changes nothing", !fs::exists("results"));
  MPI_Barrier(comm);
  folder.create();
  check("created", fs::is_directory("results/run/fields"));

  dealii::ParameterHandler prm;
  RunParameters::declare_parameters(prm);
  folder.write_parameters(prm, "in.prm");
  check("parameters as read",
        content(folder.file("parameters-as-read.prm")) == content("in.prm"));
  check("parameters with defaults",
        content(folder.file("parameters.prm")).find("set Overwrite") !=
          std::string::npos);

  const std::string error =
    error_of([] { OutputFolder("results/run", false, comm); });
  check("all ranks refuse another run",
        error.find("holds another run") != std::string::npos);
  if (first_rank())
    {
      std::cout << error << std::endl;
      std::ofstream("results/run/fields/old.vtu") << "old";
      std::ofstream("results/run/notes.txt") << "mine";
    }
  MPI_Barrier(comm);
  OutputFolder("results/run", true, comm).create();
  check("overwriting removes results only",
        !fs::exists("results/run/fields/old.vtu") &&
          !fs::exists("results/run/parameters.prm") &&
          fs::exists("results/run/notes.txt"));
  check("a file is no folder", error_of([] {
                                 OutputFolder("in.prm", true, comm);
                               }) == "output folder 'in.prm' is not a folder");
}

void
check_tables()
{
  {
    Statistics statistics("statistics.csv", comm);
    statistics.write_row({{"time_s", 0}, {"flow_mL_per_s", 1. / 3}});
    statistics.write_row({{"time_s", 1e-3}, {"flow_mL_per_s", -1e5}});
    if (first_rank())
      {
        bool refused = false;
        try
          {
            statistics.write_row({{"time_s", 2e-3}, {"flow", 1}});
          }
        catch (const std::logic_error &)
          {
            refused = true;
          }
        std::cout << "other columns are refused: " << refused << std::endl;
      }
  }

  Summary peaks;
  peaks.set("anterior_primary", 0.25);
  Summary summary;
  summary.set("sealed", true);
  summary.set("leak_mL_per_s", std::numeric_limits<double>::quiet_NaN());
  summary.set("steps", 12345678901ul);
  summary.set("chordae_peak_N", peaks);
  summary.set("empty", Summary());
  summary.set("warnings", std::vector<std::string>({"a \"b\"", "c\n\\"}));
  summary.set("leak_mL_per_s", 0.1);
  summary.set("note", "text");
  if (first_rank())
    std::cout << content("statistics.csv") << summary.json() << std::endl;
}

void
check_terminal()
{
  Console console(0.1);
  const std::string line =
    console.line({0.05, 4e-6, "solid", 1.5e-6, 0.25, 40000, 100});
  check("progress",
        line.find("  50.00 / 100.00 ms  dt   4.00 us (solid)  flow    1.50 "
                  "mL/s  contact  0.250 N  40000 cells") == 0);
  check("banner",
        Console::banner(comm).find("deal.II 9.") != std::string::npos);

  const auto parse = [](const std::vector<const char *> &arguments) {
    return CommandLine::parse(arguments.size(), arguments.data());
  };
  check("run", parse({"coapt", "a.prm"}).file == "a.prm");
  check("check",
        parse({"coapt", "--check", "a.prm"}).action ==
          CommandLine::Action::check);
  check("version",
        parse({"coapt", "--version"}).action == CommandLine::Action::version);
  if (first_rank())
    {
      for (const double seconds : {42.4, 200., 3900.})
        std::cout << Console::duration(seconds) << std::endl;
      std::cout << error_of([&] { parse({"coapt"}); }) << std::endl
                << error_of([&] {
                     parse({"coapt", "--chek", "a.prm"});
                   })
                << std::endl
                << error_of([&] {
                     parse({"coapt", "--version", "a.prm"});
                   })
                << std::endl;
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_folder();
  check_tables();
  check_terminal();
}
