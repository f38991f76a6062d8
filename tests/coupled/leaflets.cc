// Two leaflets with chordae shut a plane channel: alike and not, with leak,
// contact and reopening; and with two sound speeds, which change neither the
// time of closing nor the ringing after it.
#include "leaflets.h"

using namespace coapt;

namespace
{
  /** What one sees of closed leaflets between two times. */
  struct ClosedLeaflets
  {
    double leak          = 0;                                     // m/s
    double least_force   = std::numeric_limits<double>::max();    // N
    double largest_force = std::numeric_limits<double>::lowest(); // N
    double smallest_gap  = std::numeric_limits<double>::max();    // m
  };

  /** Runs until @p end and looks from @p begin on; forces are means over 2 ms.
   */
  ClosedLeaflets
  run_closed(LeafletsCase &c,
             const double dt,
             const double begin,
             const double end)
  {
    while (c.time() < begin)
      c.step(dt);
    ClosedLeaflets result;
    const double start = c.time(), passed = c.passed_volume();
    while (c.time() < end)
      {
        const double time = c.time(), impulse = c.impulse;
        while (c.time() < time + 2e-3)
          c.step(dt);
        const double force   = (c.impulse - impulse) / (c.time() - time);
        result.least_force   = std::min(result.least_force, force);
        result.largest_force = std::max(result.largest_force, force);
        result.smallest_gap  = std::min(result.smallest_gap, c.smallest_gap());
      }
    result.leak =
      (c.passed_volume() - passed) / (c.time() - start) / c.leaflets.height;
    return result;
  }

  /** Asserts that leaflets are shut. @p force in N. */
  void
  check_closed(const std::string &name,
               const ClosedLeaflets &result,
               const double force)
  {
    check(name + ", leak below 0.5 mm/s",
          std::abs(result.leak) < 0.5e-3,
          result.leak);
    check(name + ", contact force",
          result.least_force > 0.85 * force &&
            result.largest_force < 1.15 * force,
          0.5 * (result.least_force + result.largest_force));
    check(name + ", contact force is steady",
          result.largest_force < 1.2 * result.least_force,
          result.largest_force / result.least_force);
    // Blood holds them a cell apart, within the clearance of contact.
    check(name + ", smallest gap",
          result.smallest_gap > 0.7e-3 && result.smallest_gap < 1.25e-3,
          result.smallest_gap);
  }

  /** Leaflets that damp their own vibration, as tissue does. */
  Leaflets
  damped()
  {
    Leaflets leaflets;
    leaflets.viscosity = 2;
    return leaflets;
  }

  void
  alike()
  {
    LeafletsCase c(damped());
    const double dt = 0.5 * c.coupled.smaller_limit();
    check_closed("alike", run_closed(c, dt, 40e-3, 50e-3), 19);
    const double middle = 0.5 * (c.tip(0)[1] + c.tip(1)[1]);
    check("alike, they meet in the middle",
          std::abs(middle - 10e-3) < 0.1e-3,
          middle);
  }

  /** The upper leaflet is longer, more oblique and not in line with the cells
   * as the lower one is; later it is pulled open. */
  void
  asymmetric()
  {
    Leaflets leaflets = damped();
    leaflets.extent[1] += 1e-3;
    leaflets.root[1] += 0.37e-3;
    leaflets.angle[1] += 6;
    leaflets.reversal = 50e-3;
    leaflets.reversed = -3e3;
    LeafletsCase c(leaflets);
    const double dt = 0.5 * c.coupled.smaller_limit();
    check_closed("asymmetric", run_closed(c, dt, 40e-3, 50e-3), 68);

    while (c.time() < 75e-3)
      c.step(dt);
    const double impulse = c.impulse;
    while (c.time() < 80e-3)
      c.step(dt);
    check("asymmetric, reopened",
          c.smallest_gap() > 1.4e-3 && c.impulse == impulse,
          c.smallest_gap());
  }

  /** Where the flow out of the atrial end changes its sign. */
  struct Ringing
  {
    std::vector<double> crossings; // s
    std::vector<double> peaks;     // m/s, the largest flow before each of them
  };

  /** Follows the flow until @p end. Changes of sign count if the flow exceeds 1
   * cm/s after them. */
  Ringing
  ringing(const double sound_speed, const double end)
  {
    Leaflets leaflets;
    leaflets.sound_speed = sound_speed;
    leaflets.impedance   = 5300;
    LeafletsCase c(leaflets);
    const double dt = 0.5 * c.coupled.smaller_limit(), least = 10e-3;
    Ringing result;
    double sign = 1, peak = 0, crossing = 0;
    while (c.time() < end)
      {
        const double before = c.outflow;
        c.step(dt);
        const double flow =
          sign * (c.outflow - before) / dt / c.leaflets.height;
        if (flow > 0)
          {
            peak     = std::max(peak, flow);
            crossing = c.time();
          }
        else if (flow < -least && peak > least)
          {
            result.crossings.push_back(crossing);
            result.peaks.push_back(peak);
            peak = -flow;
            sign = -sign;
          }
      }
    return result;
  }

  void
  sound_speed()
  {
    const double end     = 37e-3;
    const Ringing slow   = ringing(50, end);
    const Ringing fast   = ringing(100, end);
    const unsigned int n = 5;
    check("sound speeds, waves",
          slow.crossings.size() >= n && fast.crossings.size() >= n,
          slow.crossings.size());
    if (slow.crossings.size() < n || fast.crossings.size() < n)
      return;
    check_relative("sound speeds, time of closing",
                   slow.crossings[0],
                   fast.crossings[0],
                   0.01);
    const auto period = [](const Ringing &ringing) {
      return 0.5 * (ringing.crossings[n - 1] - ringing.crossings[0]);
    };
    check_relative("sound speeds, period of the ringing",
                   period(slow),
                   period(fast),
                   0.03);
    // The first wave back is the impact itself.
    for (const unsigned int i : {0, 2, 3})
      check_relative("sound speeds, height of a wave",
                     slow.peaks[i],
                     fast.peaks[i],
                     0.06);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  alike();
  asymmetric();
  sound_speed();
}
