#ifndef coapt_metrics_distribution_h
#define coapt_metrics_distribution_h

#include <vector>

namespace coapt
{
  /** Share of the @p weights whose @p values are above each threshold:
   * P(value > t). Zero everywhere if there is no weight. */
  std::vector<double>
  exceedance(const std::vector<double> &values,
             const std::vector<double> &weights,
             const std::vector<double> &thresholds);

  /** Least value that is not exceeded by more than 1 - @p share of the
   * weights; zero if there is no weight. */
  double
  weighted_quantile(const std::vector<double> &values,
                    const std::vector<double> &weights,
                    const double share);

  /** Mean of the values, zero if there is no weight. */
  double
  weighted_mean(const std::vector<double> &values,
                const std::vector<double> &weights);
} // namespace coapt

#endif
