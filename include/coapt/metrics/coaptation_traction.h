#ifndef coapt_metrics_coaptation_traction_h
#define coapt_metrics_coaptation_traction_h

#include <deal.II/base/tensor.h>

namespace coapt
{
  /**
   * Traction (Pa) with which what lies on the other side presses on a piece of
   * a leaflet: contact and film together, t_co = p_c + p_v - t_f . N, where N
   * is the unit @p normal of the surface on the side of that film, whatever its
   * own sign, for @p to_partner leads to what the piece faces.
   *
   * @p contact_pressure is p_c (Pa), @p ventricular_pressure p_v behind the
   * piece (Pa), and t_f the @p force of the blood on both of its sides (N) over
   * its @p area (m^2). With the pressure p_f in the film, t_f . N = p_v - p_f,
   * so that p_c + p_f remains, without p_f being looked up in a film thinner
   * than a cell.
   */
  double
  coaptation_traction(const double contact_pressure,
                      const double ventricular_pressure,
                      const dealii::Tensor<1, 3> &force,
                      const dealii::Tensor<1, 3> &normal,
                      const dealii::Tensor<1, 3> &to_partner,
                      const double area);
} // namespace coapt

#endif
