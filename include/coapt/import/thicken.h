#ifndef coapt_import_thicken_h
#define coapt_import_thicken_h

#include <coapt/geometry/leaflet.h>

namespace coapt
{
  /**
   * Gives the surface with the @p points (m) and @p quads, whose normals
   * (c2 - c0) x (c3 - c1) point to the ventricular side, the @p thickness (m)
   * in @p n_layers layers: fills mesh, columns, quads, cell_quad and thickness
   * of a leaflet. The columns stand on the points, along the mean of the
   * normals around, weighted by area.
   *
   * A quadrilateral is cut along its first diagonal, as in triangulate(), and
   * the prisms on both triangles into three tetrahedra that climb from the
   * corner with the lowest number to that with the highest, which fits at
   * every side (Dompierre et al., How to subdivide pyramids, prisms and
   * hexahedra into tetrahedra, 1999).
   */
  Leaflet
  thicken(const std::vector<dealii::Point<3>> &points,
          const std::vector<std::array<unsigned int, 4>> &quads,
          const double thickness,
          const unsigned int n_layers);
} // namespace coapt

#endif
