#include <coapt/coupled/displacement_history.h>

#include <algorithm>

namespace coapt
{
  using dealii::Tensor;

  DisplacementHistory::DisplacementHistory(
    const std::vector<double> &times,
    const std::vector<Tensor<1, 3>> &displacements)
    : first(times.front()), last(times.back())
  {
    // Equal values beyond the ends make the slopes vanish there.
    for (unsigned int d = 0; d < 3; ++d)
      {
        std::vector<double> x = {first - 2, first - 1};
        std::vector<double> y(2, displacements.front()[d]);
        x.insert(x.end(), times.begin(), times.end());
        for (const Tensor<1, 3> &u : displacements)
          y.push_back(u[d]);
        x.insert(x.end(), {last + 1, last + 2});
        y.insert(y.end(), 2, displacements.back()[d]);
        components.emplace_back(std::move(x), std::move(y));
      }
  }



  Tensor<1, 3>
  DisplacementHistory::displacement(const double t) const
  {
    Tensor<1, 3> u;
    for (unsigned int d = 0; d < 3; ++d)
      u[d] = components[d](std::clamp(t, first, last));
    return u;
  }



  Tensor<1, 3>
  DisplacementHistory::velocity(const double t) const
  {
    Tensor<1, 3> v;
    for (unsigned int d = 0; d < 3; ++d)
      v[d] = components[d].prime(std::clamp(t, first, last));
    return v;
  }
} // namespace coapt
