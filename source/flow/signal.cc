#include <coapt/flow/signal.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  namespace
  {
    /** Times at which the signal rises through @p threshold. */
    std::vector<double>
    rising_crossings(const std::vector<double> &times,
                     const std::vector<double> &values,
                     const std::size_t first,
                     const double threshold)
    {
      std::vector<double> result;
      for (std::size_t i = first; i + 1 < values.size(); ++i)
        if (values[i] < threshold && values[i + 1] >= threshold)
          result.push_back(times[i] +
                           (times[i + 1] - times[i]) * (threshold - values[i]) /
                             (values[i + 1] - values[i]));
      return result;
    }
  } // namespace



  SignalFigures
  signal_figures(const std::vector<double> &times,
                 const std::vector<double> &values,
                 const double from)
  {
    const std::size_t last  = values.size() - 1;
    const std::size_t first = std::min<std::size_t>(
      last,
      std::lower_bound(times.begin(), times.end(), from * (1 - 1e-9)) -
        times.begin());
    double integral = 0;
    for (std::size_t i = first; i < last; ++i)
      integral += (times[i + 1] - times[i]) * (values[i] + values[i + 1]) / 2;

    SignalFigures figures;
    figures.mean =
      last > first ? integral / (times[last] - times[first]) : values[last];
    const auto range =
      std::minmax_element(values.begin() + first, values.end());
    figures.least   = *range.first;
    figures.largest = *range.second;
    const std::vector<double> crossings =
      rising_crossings(times, values, first, figures.mean);
    const double magnitude =
      std::max(std::abs(figures.least), std::abs(figures.largest));
    const bool is_steady = figures.largest - figures.least < 0.01 * magnitude;
    figures.frequency    = crossings.size() < 2 || is_steady
         ? std::numeric_limits<double>::quiet_NaN()
         : (crossings.size() - 1) / (crossings.back() - crossings.front());
    return figures;
  }
} // namespace coapt
