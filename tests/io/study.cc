// A study that goes on with other columns than those that it has begun with.
#include <coapt/io/study.h>

#include "tests.h"

#include <filesystem>
#include <fstream>

using namespace coapt;
namespace fs = std::filesystem;

namespace
{
  const MPI_Comm comm = MPI_COMM_WORLD;

  std::string
  content(const std::string &file)
  {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }

  /** Goes on in the folder if it is there, with this many runs of the plan, of
   * which the last has a column more if @p is_wider. */
  void
  run_study(const unsigned int n_runs, const bool is_wider)
  {
    const OutputFolder folder("study", true, comm, Resume::if_possible);
    folder.create();
    Log log(comm, std::cout);
    std::vector<std::string> plan;
    for (unsigned int i = 0; i < n_runs; ++i)
      plan.push_back("run " + std::to_string(i + 1));
    Study::check_plan(folder, plan, comm);
    Study(log, comm).run(
      plan,
      [&](const unsigned int i,
          const OutputFolder &,
          const std::vector<Study::Row> &) {
        Study::Row row = {{"run", i + 1.}, {"leak", 0.5 * i}};
        if (is_wider)
          row.insert(row.begin() + 1, {"flow", 10. + i});
        return row;
      },
      Summary(),
      folder);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  fs::remove_all("study");
  run_study(1, false);
  run_study(2, true);
  check("each value is in the column of its name",
        content("study/study.csv") == "run,leak,flow\n1,0,\n2,0.5,11\n");
  run_study(3, false);
  check("and stays there",
        content("study/study.csv") == "run,leak,flow\n1,0,\n2,0.5,11\n3,1,\n");
}
