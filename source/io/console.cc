#include <coapt/base/units.h>
#include <coapt/base/version.h>
#include <coapt/io/console.h>

#include <cmath>
#include <cstdio>
#include <ctime>

namespace coapt
{
  Console::Console(const double end_time)
    : end_time(end_time), last_wall(Clock::now())
  {
  }



  std::string
  Console::line(const Progress &progress)
  {
    const Clock::time_point now = Clock::now();
    const double wall = std::chrono::duration<double>(now - last_wall).count();
    const double advanced = progress.time - last_time;
    const double pace     = wall / advanced;

    char text[256];
    std::snprintf(text,
                  sizeof(text),
                  "%7.2f / %.2f ms  dt %6.2f us (%s)  flow %7.2f mL/s  "
                  "contact %6.3f N  %u cells  %.0f steps/s  ETA %s",
                  1e3 * progress.time,
                  1e3 * end_time,
                  1e6 * progress.step,
                  progress.limiter.c_str(),
                  progress.flow / units::millilitre,
                  progress.contact_force,
                  progress.cells,
                  wall > 0 ? (progress.steps - last_steps) / wall : 0.,
                  advanced > 0
                    ? duration(pace * (end_time - progress.time)).c_str()
                    : "-");
    last_wall  = now;
    last_time  = progress.time;
    last_steps = progress.steps;
    return text;
  }



  std::string
  Console::banner(const MPI_Comm communicator)
  {
    int n_ranks, length;
    MPI_Comm_size(communicator, &n_ranks);
    char host[MPI_MAX_PROCESSOR_NAME];
    MPI_Get_processor_name(host, &length);
    const std::time_t now = std::time(nullptr);
    char date[32];
    std::strftime(date,
                  sizeof(date),
                  "%Y-%m-%d %H:%M:%S",
                  std::localtime(&now));
    return "Coapt " + version() + ", revision " + revision() + "\n" +
      library_versions() + "\n" + std::to_string(n_ranks) +
      (n_ranks == 1 ? " rank" : " ranks") + " on " + std::string(host, length) +
      ", " + date;
  }



  std::string
  Console::duration(const double seconds)
  {
    const long total = std::lround(seconds);
    char text[48];
    if (total >= 3600)
      std::snprintf(
        text, sizeof(text), "%ld h %02ld min", total / 3600, total / 60 % 60);
    else if (total >= 60)
      std::snprintf(
        text, sizeof(text), "%ld min %02ld s", total / 60, total % 60);
    else
      std::snprintf(text, sizeof(text), "%ld s", total);
    return text;
  }
} // namespace coapt
