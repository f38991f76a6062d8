#ifndef coapt_metrics_bulging_volume_h
#define coapt_metrics_bulging_volume_h

#include <coapt/geometry/leaflet.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * A smooth surface z(x, y) through the annulus: the least-squares fit of
   *
   *   z = a + b xi + c eta + d (xi^2 - eta^2) + e xi eta
   *
   * to its points, in coordinates from their centre divided by sqrt(2) times
   * their root mean square (for an ellipse, its semi-axes). A full quadratic
   * would not be unique: on an ellipse xi^2 + eta^2 is constant, so the
   * annulus says nothing about a dome over it. This one has none.
   */
  class SpanningSurface
  {
  public:
    /** @p annulus in m, the z axis normal to its plane. Throws InputError if
     * there are fewer than five points or if they lie on a line. */
    SpanningSurface(const std::vector<dealii::Point<3>> &annulus);

    /** Height of @p point above the surface along z (m). */
    double
    height_above(const dealii::Point<3> &point) const;

    /** Shortest distance of @p point from the surface (m), positive above
     * it. */
    double
    distance_above(const dealii::Point<3> &point) const;

  private:
    std::array<double, 5>
    basis(const dealii::Point<3> &point) const;

    dealii::Point<3> center;
    std::array<double, 2> scale;
    std::array<double, 5> coefficients{};
  };

  /**
   * Bulging volume (m^3): the volume between the leaflet and a surface that
   * spans the annulus, where the leaflet is on the atrial side (+z) of it.
   * Facet area projected along z times height, exact for linear facets that
   * cross the surface, with the sign of their orientation, so that folds count
   * once. Facets whose centroid is outside the annulus do not count.
   *
   * @p annulus is an ordered loop of points, @p points are those of the
   * mid-surface (m), and the @p triangles have their area vectors to the
   * ventricular side. Throws InputError like SpanningSurface.
   */
  double
  bulging_volume(const std::vector<dealii::Point<3>> &annulus,
                 const std::vector<dealii::Point<3>> &points,
                 const std::vector<std::array<unsigned int, 3>> &triangles);

  /**
   * Bulging as the thesis of Khaledian (2023) measures it (m^3): the sum over
   * the facets of the shortest distance from the surface times the facet's own
   * area, where the distance is positive. It exceeds the volume where leaflets
   * are steep, and counts each layer of a fold. Arguments, and what counts, as
   * for bulging_volume().
   */
  double
  bulging_by_distance(
    const std::vector<dealii::Point<3>> &annulus,
    const std::vector<dealii::Point<3>> &points,
    const std::vector<std::array<unsigned int, 3>> &triangles);

  /** bulging_volume() of each Region alone; @p regions are those of the
   * triangles. */
  std::array<double, n_regions>
  bulging_by_region(const std::vector<dealii::Point<3>> &annulus,
                    const std::vector<dealii::Point<3>> &points,
                    const std::vector<std::array<unsigned int, 3>> &triangles,
                    const std::vector<Region> &regions);
} // namespace coapt

#endif
