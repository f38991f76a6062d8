#include <coapt/metrics/coaptation_traction.h>

namespace coapt
{
  double
  coaptation_traction(const double contact_pressure,
                      const double ventricular_pressure,
                      const dealii::Tensor<1, 3> &force,
                      const dealii::Tensor<1, 3> &normal,
                      const dealii::Tensor<1, 3> &to_partner,
                      const double area)
  {
    const double side = normal * to_partner < 0 ? -1 : 1;
    return contact_pressure + ventricular_pressure -
      side * (force * normal) / area;
  }
} // namespace coapt
