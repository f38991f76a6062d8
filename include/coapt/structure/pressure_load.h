#ifndef coapt_structure_pressure_load_h
#define coapt_structure_pressure_load_h

#include <coapt/geometry/leaflet.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * A uniform pressure on the ventricular face of a leaflet, apart from the
   * root, which is buried in the wall. It follows the face: the force is the
   * derivative of the volume under its triangles, -p A n/3 on each corner, so
   * that a constant pressure does as much work as it displaces volume.
   */
  class PressureLoad
  {
  public:
    explicit PressureLoad(const Leaflet &leaflet);

    /** Adds to @p F (N) the forces of the @p pressure (Pa) at the positions
     * @p X (m), every @p n_ranks -th triangle from @p rank on. */
    void
    add_forces(const double pressure,
               const double *X,
               double *F,
               const unsigned int rank,
               const unsigned int n_ranks) const;

  private:
    /** Nodes of the face, with the area vectors towards the ventricle. */
    std::vector<std::array<unsigned int, 3>> triangles;
  };
} // namespace coapt

#endif
