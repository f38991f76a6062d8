#include <coapt/metrics/loads.h>

#include <cmath>

namespace coapt
{
  dealii::Tensor<1, 3>
  force_on_supports(const std::vector<bool> &pinned,
                    const std::vector<double> &force)
  {
    dealii::Tensor<1, 3> sum;
    for (unsigned int node = 0; node < pinned.size(); ++node)
      for (unsigned int d = 0; d < 3 && pinned[node]; ++d)
        sum[d] += force[3 * node + d];
    return sum;
  }



  double
  reynolds_number(const double flow,
                  const double area,
                  const double density,
                  const double viscosity)
  {
    return density * std::abs(flow) / area * std::sqrt(4 * area / M_PI) /
      viscosity;
  }
} // namespace coapt
