#ifndef coapt_metrics_loads_h
#define coapt_metrics_loads_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace coapt
{
  /** Sum of @p force (N, node triples) over the pinned nodes: force on what
   * holds the tissue (N), if @p force is that of the tissue and of all that
   * loads it. The load counts, since a pinned node carries that of half an
   * element: without it the result would depend on the elements' size (as
   * reactions of finite elements do). */
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
