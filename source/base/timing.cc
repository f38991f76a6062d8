#include <coapt/base/timing.h>

#include <cstdio>

namespace coapt
{
  Timing::Timing() : start(Clock::now()), last(start)
  {
    // so that no scope allocates
    running.reserve(64);
  }



  unsigned int
  Timing::section(const std::string &name)
  {
    for (unsigned int id = 0; id < sections.size(); ++id)
      if (sections[id].name == name)
        return id;
    sections.push_back({name, 0., 0});
    return sections.size() - 1;
  }



  double
  Timing::wall_time() const
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }



  std::string
  Timing::summary(const MPI_Comm communicator) const
  {
    int rank, n_ranks;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &n_ranks);

    // the sections, what is in none of them, and the total
    const std::size_t n = sections.size() + 2;
    std::vector<double> times(n), least(n), sum(n), largest(n);
    times[n - 1] = times[n - 2] = wall_time();
    for (std::size_t i = 0; i < sections.size(); ++i)
      {
        times[i] = sections[i].time;
        times[n - 2] -= sections[i].time;
      }
    const auto reduce = [&](std::vector<double> &result, const MPI_Op op) {
      MPI_Reduce(
        times.data(), result.data(), n, MPI_DOUBLE, op, 0, communicator);
    };
    reduce(least, MPI_MIN);
    reduce(sum, MPI_SUM);
    reduce(largest, MPI_MAX);
    if (rank != 0)
      return "";

    char text[160];
    std::string table;
    std::snprintf(text,
                  sizeof(text),
                  "%-28s %10s %9s %9s %9s %7s\n",
                  "part",
                  "calls",
                  "min [s]",
                  "mean [s]",
                  "max [s]",
                  "share");
    table += text;
    for (std::size_t i = 0; i < n; ++i)
      {
        const bool is_section = i < sections.size();
        const char *name      = is_section ? sections[i].name.c_str()
                                           : (i == n - 2 ? "rest" : "total");
        std::snprintf(text,
                      sizeof(text),
                      "%-28.28s %10s %9.3f %9.3f %9.3f %6.1f%%\n",
                      name,
                      is_section ? std::to_string(sections[i].calls).c_str()
                                 : "",
                      least[i],
                      sum[i] / n_ranks,
                      largest[i],
                      100. * sum[i] / sum[n - 1]);
        table += text;
      }
    return table;
  }
} // namespace coapt
