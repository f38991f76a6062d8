#ifndef coapt_metrics_orifice_h
#define coapt_metrics_orifice_h

#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <vector>

namespace coapt
{
  /** What of the lumen the leaflets leave open, as seen along z. */
  struct Orifice
  {
    double area = 0; // m^2

    /** Diameter (m) of the largest disc that passes, and its centre (m). @{ */
    double disc = 0;
    dealii::Point<2> center;
    /** @} */

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &area &disc &center;
    }
  };

  /**
   * The orifice that is seen along z: on a grid of the given @p spacing (m),
   * the points that are @p inside the lumen and not hidden by a triangle. The
   * largest disc is that around the grid point which is furthest from all
   * others. Oblique gaps are hidden; the widest path sees them.
   *
   * @param points,triangles the surface of the leaflets (m, deformed).
   * @param inside whether a point (z = 0) is in the lumen.
   */
  Orifice
  seen_orifice(const std::vector<dealii::Point<3>> &points,
               const std::vector<std::array<unsigned int, 3>> &triangles,
               const std::function<bool(const dealii::Point<3> &)> &inside,
               const double spacing = 0.1e-3);

  /**
   * Orifice area (m^2) that a @p leak (m^3/s) under a difference of pressure
   * (Pa) belongs to, by Bernoulli's law without contraction: that of the jet.
   */
  double
  effective_orifice_area(const double leak,
                         const double pressure,
                         const double density);

  /** Whether two areas (m^2) of one orifice, that which is seen and that of its
   * jet, are within @p factor of each other. A jet is narrower than its
   * orifice, by 0.6 for a sharp edge and hardly for a round one; an orifice
   * that is oblique is seen too narrow or not at all. */
  bool
  orifices_agree(const double seen,
                 const double effective,
                 const double factor);
} // namespace coapt

#endif
