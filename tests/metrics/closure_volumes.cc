// Closing, leak and regurgitant volume of made-up series with known answers.

#include <coapt/base/units.h>
#include <coapt/metrics/closure_volumes.h>

#include "tests.h"

using namespace coapt;
using namespace coapt::units;

namespace
{
  const double shut_width = 0.3e-3, touch = 50e-3;

  /** Every millisecond to 100 ms: until 50 ms the leaflets sweep 30 mL/s, and
   * 10 mL/s pass between them. From then on they sweep 5 mL/s, while 3 mL/s
   * pass through gaps and 2 mL/s through the tissue. Films are drained of 1
   * mL/s all the time. The valve is shut from 40 ms, opens at 45 ms, and is
   * shut for good from 50 ms on. */
  std::vector<ValveSample>
  leaking_valve()
  {
    std::vector<ValveSample> samples;
    for (unsigned int i = 0; i <= 100; ++i)
      {
        ValveSample sample;
        const double t      = 1e-3 * i;
        const double before = std::min(t, touch), after = t - before;
        sample.time           = t;
        sample.path_width     = i < 40 || (i >= 45 && i < 50) ? 1e-3 : 0.1e-3;
        sample.outflow        = (i < 50 ? 40 : 10) * millilitre;
        sample.tissue_flow    = (i < 50 ? 0 : 2) * millilitre;
        sample.outflow_volume = (40 * before + 10 * after) * millilitre;
        sample.swept_volume   = (30 * before + 5 * after) * millilitre;
        sample.drained_volume = t * millilitre;
        samples.push_back(sample);
      }
    return samples;
  }

  void
  check_closing(const std::vector<ValveSample> &samples)
  {
    const Closing shut = closing(samples, shut_width);
    check("it closes when it does not open again",
          shut.closed && std::abs(shut.time - touch) < 1e-12,
          shut.time);
    check_relative("closing volume, with what is drained",
                   shut.volume,
                   (2 + 0.05) * millilitre,
                   1e-12);
    auto opened              = samples;
    opened.back().path_width = shut_width;
    check("a valve that opens at the end is not closed",
          !closing(opened, shut_width).closed);
  }

  void
  check_leak(const std::vector<ValveSample> &samples)
  {
    const Leak leak = mean_leak(samples, 20e-3);
    check_relative("leak through gaps", leak.gaps, 3 * millilitre, 1e-9);
    check_relative("leak through tissue", leak.tissue, 2 * millilitre, 1e-9);
    check_relative("leak by drainage", leak.drained, 1 * millilitre, 1e-9);
    check_relative("leak in all", leak.total(), 6 * millilitre, 1e-9);

    const std::vector<ValveSample> start(1, samples.front());
    const Leak none = mean_leak(start, 20e-3);
    check("a single sample has no leak",
          std::isnan(none.gaps) && std::isnan(none.tissue) &&
            std::isnan(none.drained));
  }

  void
  check_window(const std::vector<ValveSample> &samples)
  {
    const auto time = [](const ValveSample &sample) { return sample.time; };
    check_relative("mean over the last 20 ms",
                   window_mean(samples, 20e-3, time),
                   90e-3,
                   1e-12);
    const std::vector<ValveSample> uneven = {samples[0],
                                             samples[15],
                                             samples[20],
                                             samples[30]};
    check_relative("a window that begins between samples is longer",
                   window_mean(uneven, 20e-3, time),
                   15e-3,
                   1e-12);
  }

  /** A plane through which 40 mL/s flow beside one with the opposite normal,
   * while the leaflets sweep 30 mL/s. */
  void
  check_planes()
  {
    ValveSample sample;
    sample.plane_flow = {40 * millilitre, -40 * millilitre};
    sample.swept_flow = 30 * millilitre;
    check_relative("what passes the leaflets through a plane",
                   plane_flow_less_swept(sample, 0),
                   10 * millilitre,
                   1e-12);
    check_relative("through a plane with the opposite normal",
                   plane_flow_less_swept(sample, 1),
                   -70 * millilitre,
                   1e-12);
  }

  void
  check_regurgitation(std::vector<ValveSample> samples)
  {
    check_relative("regurgitant volume since closing",
                   regurgitant_volume(samples, closing(samples, shut_width)),
                   (3 + 2 + 1) * 0.05 * millilitre,
                   1e-9);
    const Closing open;
    check("a flow that never settles regurgitates for ever",
          std::isnan(regurgitant_volume(samples, open)));
    for (unsigned int i = 70; i <= 100; ++i)
      samples[i].outflow = 3.9 * millilitre;
    check_relative("regurgitant volume of an open valve, since it settled",
                   regurgitant_volume(samples, open),
                   (3 + 2 + 1) * 0.03 * millilitre,
                   1e-9);
    // the largest outflow may come after closing, by a rebound
    samples[60].outflow = 50 * millilitre;
    check_relative("a rebound does not put closing off",
                   regurgitant_volume(samples, closing(samples, shut_width)),
                   (3 + 2 + 1) * 0.05 * millilitre,
                   1e-9);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::vector<ValveSample> samples = leaking_valve();
  check_closing(samples);
  check_leak(samples);
  check_window(samples);
  check_planes();
  check_regurgitation(samples);
}
