#ifndef coapt_geometry_prestretch_h
#define coapt_geometry_prestretch_h

#include <deal.II/base/tensor.h>

namespace coapt
{
  /** The prestretch F0 of a sheet without change of volume: @p along in the
   * direction @p fibre, @p across in the direction @p other; the two are
   * orthogonal unit vectors in the sheet. */
  inline dealii::Tensor<2, 3>
  sheet_prestretch(const dealii::Tensor<1, 3> &fibre,
                   const dealii::Tensor<1, 3> &other,
                   const double along,
                   const double across)
  {
    const dealii::Tensor<1, 3> normal = cross_product_3d(other, fibre);
    return along * outer_product(fibre, fibre) +
      across * outer_product(other, other) +
      1 / (along * across) * outer_product(normal, normal);
  }
} // namespace coapt

#endif
