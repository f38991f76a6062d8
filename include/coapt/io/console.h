#ifndef coapt_io_console_h
#define coapt_io_console_h

#include <mpi.h>

#include <chrono>
#include <string>

namespace coapt
{
  /** The lines that a person at the terminal sees. */
  class Console
  {
  public:
    /** What one line reports. */
    struct Progress
    {
      double time = 0;          // reached, s
      double step = 0;          // length of the time step, s
      std::string limiter;      // the part that sets the step
      double flow          = 0; // m^3/s, through the atrial end
      double contact_force = 0; // N
      unsigned int cells   = 0; // of the fluid
      unsigned long steps  = 0; // since the start
    };

    /** A run from now to @p end_time (s). */
    explicit Console(const double end_time);

    /**
     * One line: time reached / end, step and limiter, flow, contact force,
     * cells, steps a second since the last line, and the wall time that the
     * rest will take at the present pace.
     */
    std::string
    line(const Progress &progress);

    /** Program, revision, libraries, ranks, host and date: some lines. */
    static std::string
    banner(const MPI_Comm communicator);

    /** "1 h 05 min", "3 min 20 s" or "42 s" for @p seconds. */
    static std::string
    duration(const double seconds);

  private:
    using Clock = std::chrono::steady_clock;

    const double end_time;
    Clock::time_point last_wall;
    double last_time         = 0;
    unsigned long last_steps = 0;
  };
} // namespace coapt

#endif
