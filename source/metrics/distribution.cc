#include <coapt/metrics/distribution.h>

#include <algorithm>
#include <numeric>

namespace coapt
{
  std::vector<double>
  exceedance(const std::vector<double> &values,
             const std::vector<double> &weights,
             const std::vector<double> &thresholds)
  {
    const double total = std::accumulate(weights.begin(), weights.end(), 0.);
    std::vector<double> result;
    for (const double threshold : thresholds)
      {
        double above = 0;
        for (unsigned int i = 0; i < values.size(); ++i)
          above += values[i] > threshold ? weights[i] : 0.;
        result.push_back(total > 0 ? above / total : 0.);
      }
    return result;
  }



  double
  weighted_quantile(const std::vector<double> &values,
                    const std::vector<double> &weights,
                    const double share)
  {
    std::vector<unsigned int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return values[a] < values[b];
    });
    const double total = std::accumulate(weights.begin(), weights.end(), 0.);
    double sum         = 0;
    for (const unsigned int i : order)
      {
        sum += weights[i];
        if (total > 0 && sum >= share * total)
          return values[i];
      }
    return 0;
  }



  double
  weighted_mean(const std::vector<double> &values,
                const std::vector<double> &weights)
  {
    const double total = std::accumulate(weights.begin(), weights.end(), 0.);
    return total > 0
      ? std::inner_product(values.begin(), values.end(), weights.begin(), 0.) /
        total
      : 0.;
  }
} // namespace coapt
