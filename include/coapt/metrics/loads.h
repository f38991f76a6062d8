#ifndef coapt_metrics_loads_h
#define coapt_metrics_loads_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace coapt
{
  /** Force of the tissue on what holds it (N): the sum of the internal forces
   * @p force (N, node triples) over the pinned nodes. */
  dealii::Tensor<1, 3>
  force_on_supports(const std::vector<bool> &pinned,
                    const std::vector<double> &force);

  /** Reynolds number of a flow rate (m^3/s) through an opening of this area
   * (m^2), with the diameter of the circle of that area as its length:
   * rho (Q/A) D/mu. */
  double
  reynolds_number(const double flow,
                  const double area,
                  const double density,
                  const double viscosity);
} // namespace coapt

#endif
