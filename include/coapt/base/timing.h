#ifndef coapt_base_timing_h
#define coapt_base_timing_h

#include <mpi.h>

#include <chrono>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * Wall time by named section. Scopes may be nested; the time of an inner
   * one is not counted for the outer one, so that the sections and the rest
   * add up to the total. Entering or leaving costs one look at the clock
   * (about 25 ns), no lock and no allocation.
   *
   * @code
   * const unsigned int fluid = timing.section("Fluid");   // once
   * ...
   * const auto scope = timing.scope(fluid);               // in the hot loop
   * @endcode
   */
  class Timing
  {
    using Clock = std::chrono::steady_clock;

  public:
    /** Counts the time of one section until it is destroyed. */
    class Scope
    {
    public:
      Scope(Timing &timing, const unsigned int id) : timing(timing)
      {
        timing.enter(id);
      }
      ~Scope()
      {
        timing.leave();
      }
      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      Timing &timing;
    };

    /** The total counts from here. */
    Timing();

    /**
     * Number of the section @p name, new or known. All ranks must name the
     * same sections in the same order.
     */
    unsigned int
    section(const std::string &name);

    /** Counts for the section with number @p id while the result lives. */
    Scope
    scope(const unsigned int id)
    {
      return Scope(*this, id);
    }

    /** Own time of a section on this rank (s), without the running scope. */
    double
    seconds(const unsigned int id) const
    {
      return sections[id].time;
    }

    /** Wall time since construction (s). */
    double
    wall_time() const;

    /**
     * A table with a line a section: calls, time as least, mean and largest
     * over the ranks (s), and the share of the total. The result is complete
     * on the first rank and empty elsewhere. Collective.
     */
    std::string
    summary(const MPI_Comm communicator) const;

  private:
    struct Section
    {
      std::string name;
      double time         = 0;
      unsigned long calls = 0;
    };

    void
    enter(const unsigned int id)
    {
      charge_running_section();
      ++sections[id].calls;
      running.push_back(id);
    }

    void
    leave()
    {
      charge_running_section();
      running.pop_back();
    }

    /** Gives the time since the last look at the clock to who was running. */
    void
    charge_running_section()
    {
      const Clock::time_point now = Clock::now();
      if (!running.empty())
        sections[running.back()].time +=
          std::chrono::duration<double>(now - last).count();
      last = now;
    }

    std::vector<Section> sections;
    std::vector<unsigned int> running;
    Clock::time_point start;
    Clock::time_point last;
  };
} // namespace coapt

#endif
