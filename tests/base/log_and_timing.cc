// The log keeps lines and counts warnings; timing counts own time; what is
// wrong in a parameter file is said in one line.
#include <coapt/base/exceptions.h>
#include <coapt/base/log.h>
#include <coapt/base/parameter_file.h>
#include <coapt/base/run_parameters.h>
#include <coapt/base/timing.h>

#include <deal.II/base/parameter_handler.h>

#include "tests.h"

#include <fstream>
#include <sstream>

using namespace coapt;

void
check_log()
{
  std::ostringstream terminal;
  {
    Log log(MPI_COMM_WORLD, terminal);
    log.line("before the file");
    log.open("test.log");
    log.warn("leak", "leaks 3 mL/s");
    log.warn("leak", "leaks 4 mL/s");
    log.warn("sparse", "points are sparse");
    log.file_line("file only");
    check("two kinds of warning", log.warnings().size() == 2);
    check("counted",
          log.warnings()[0].count == 2 && log.warnings()[1].count == 1);
  }
  std::ifstream file("test.log");
  std::ostringstream content;
  content << file.rdbuf();
  check("terminal",
        terminal.str() ==
          "before the file\nwarning: leaks 3 mL/s\nwarning: "
          "points are sparse\n");
  check("file", content.str() == terminal.str() + "file only\n");
}

void
wait(const double seconds)
{
  const Timing clock;
  while (clock.wall_time() < seconds)
    ;
}

void
check_timing()
{
  Timing timing;
  const unsigned int outer = timing.section("outer");
  const unsigned int inner = timing.section("inner");
  check("a known name keeps its number", timing.section("outer") == outer);
  {
    const auto scope = timing.scope(outer);
    wait(0.02);
    for (unsigned int i = 0; i < 3; ++i)
      {
        const auto scope = timing.scope(inner);
        wait(0.02);
      }
  }
  const double total = timing.seconds(outer) + timing.seconds(inner);
  check("inner time", timing.seconds(inner) >= 0.06, timing.seconds(inner));
  check("outer is without inner",
        timing.seconds(outer) >= 0.02 &&
          timing.seconds(outer) < timing.seconds(inner),
        timing.seconds(outer));
  check("sections fill the total",
        total <= timing.wall_time() && total > 0.99 * timing.wall_time(),
        total);
  const std::string summary = timing.summary(MPI_COMM_WORLD);
  check("five lines", std::count(summary.begin(), summary.end(), '\n') == 5);
}

void
read(const std::string &text)
{
  std::ofstream("test.prm") << text;
  dealii::ParameterHandler prm;
  RunParameters::declare_parameters(prm);
  RunParameters parameters;
  try
    {
      read_parameter_file(prm, "test.prm");
      parameters.parse_parameters(prm);
      std::cout << "end time " << parameters.end_time << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_log();
  check_timing();

  read("subsection Time\n set End time = 0.2\nend\n");
  read("subsection Time\n set End tme = 1\nend\n");
  read("subsection Tim\n set End time = 1\nend\n");
  read("subsection Time\n set End time = 0\nend\n");
  read("subsection Time\n set End time = soon\nend\n");
  read("subsection Time\n set End time = 1\n");
  read("subsection Output\n set Overwrite = maybe\nend\n");
  read("subsection Output\n set Interval = 1e-8\nend\n");
}
