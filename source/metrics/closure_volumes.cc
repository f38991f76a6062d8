#include <coapt/metrics/closure_volumes.h>

#include <algorithm>
#include <limits>

namespace coapt
{
  namespace
  {
    using Samples = std::vector<ValveSample>;

    /** The first sample of the window, or that before it if none lies on its
     * beginning, so that the window is not shorter than it is called. */
    Samples::const_iterator
    begin_of_window(const Samples &samples, const double window)
    {
      const double begin = samples.back().time - window * (1 - 1e-6);
      auto first         = samples.begin();
      for (auto sample = samples.begin(); sample != samples.end(); ++sample)
        if (sample->time <= begin)
          first = sample;
      return first;
    }
  } // namespace



  double
  volume_out(const ValveSample &sample)
  {
    return sample.outflow_volume + sample.drained_volume;
  }



  double
  volume_past_leaflets(const ValveSample &sample)
  {
    return volume_out(sample) - sample.swept_volume;
  }



  double
  plane_flow_less_swept(const ValveSample &sample, const unsigned int plane)
  {
    return sample.plane_flow[plane] - sample.swept_flow;
  }



  Closing
  closing(const Samples &samples, const double shut_width)
  {
    Closing result;
    for (const ValveSample &sample : samples)
      if (sample.path_width >= shut_width)
        result.closed = false;
      else if (!result.closed)
        {
          result.closed = true;
          result.time   = sample.time;
          result.volume = volume_out(sample);
        }
    return result;
  }



  double
  window_mean(const Samples &samples,
              const double window,
              const std::function<double(const ValveSample &)> &figure)
  {
    const auto first    = begin_of_window(samples, window);
    const double length = samples.back().time - first->time;
    if (!(length > 0))
      return std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    for (auto now = first + 1; now != samples.end(); ++now)
      {
        const ValveSample &before = *(now - 1);
        sum +=
          0.5 * (now->time - before.time) * (figure(before) + figure(*now));
      }
    return sum / length;
  }



  Leak
  mean_leak(const Samples &samples, const double window)
  {
    const ValveSample &first  = *begin_of_window(samples, window);
    const ValveSample &last   = samples.back();
    const double length       = last.time - first.time;
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    if (!(length > 0))
      return {not_a_number, not_a_number, not_a_number};
    Leak leak;
    leak.tissue  = window_mean(samples, window, [](const ValveSample &sample) {
      return sample.tissue_flow;
    });
    leak.drained = (last.drained_volume - first.drained_volume) / length;
    leak.gaps =
      (volume_past_leaflets(last) - volume_past_leaflets(first)) / length -
      leak.tissue - leak.drained;
    return leak;
  }



  double
  regurgitant_volume(const Samples &samples, const Closing &closing)
  {
    const auto closed = [&](const ValveSample &sample) {
      return sample.time >= closing.time;
    };
    const auto peak    = std::max_element(samples.begin(),
                                       samples.end(),
                                       [](const auto &a, const auto &b) {
                                         return a.outflow < b.outflow;
                                       });
    const auto settled = [&](const ValveSample &sample) {
      return sample.outflow <= 0.1 * peak->outflow;
    };
    const auto start = closing.closed
      ? std::find_if(samples.begin(), samples.end(), closed)
      : std::find_if(peak, samples.end(), settled);
    if (start == samples.end())
      return std::numeric_limits<double>::quiet_NaN();
    return volume_past_leaflets(samples.back()) - volume_past_leaflets(*start);
  }
} // namespace coapt
