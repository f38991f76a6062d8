#ifndef coapt_geometry_cell_normals_h
#define coapt_geometry_cell_normals_h

#include <coapt/geometry/leaflet.h>

namespace coapt
{
  /** Unit normal of the leaflet in each cell of its mesh, towards the
   * ventricular side. */
  std::vector<dealii::Tensor<1, 3>>
  cell_normals(const Leaflet &leaflet);
} // namespace coapt

#endif
