#ifndef coapt_geometry_triangle_h
#define coapt_geometry_triangle_h

#include <deal.II/base/point.h>

namespace coapt
{
  namespace internal
  {
    /** Fraction of the way from @p a to @p b at which the segment is nearest
     * to @p p; zero if the segment is a point. */
    inline double
    nearest_fraction(const dealii::Point<3> &p,
                     const dealii::Point<3> &a,
                     const dealii::Point<3> &b)
    {
      const dealii::Tensor<1, 3> edge = b - a;
      const double square             = edge * edge;
      if (square == 0)
        return 0;
      const double fraction = (edge * (p - a)) / square;
      return fraction < 0 ? 0 : (fraction > 1 ? 1 : fraction);
    }
  } // namespace internal

  /**
   * The point of the triangle @p a, @p b, @p c that is nearest to @p p. Its
   * barycentric coordinates (non-negative, of sum one) go to @p weights, in
   * the order of the corners. A degenerate triangle is a segment or a point.
   *
   * If the projection of p onto the plane falls outside, every segment from
   * it to the triangle enters through an edge that is opposite to a negative
   * coordinate: only these edges (one or two) are looked at.
   */
  inline dealii::Point<3>
  closest_point_on_triangle(const dealii::Point<3> &p,
                            const dealii::Point<3> &a,
                            const dealii::Point<3> &b,
                            const dealii::Point<3> &c,
                            double weights[3])
  {
    const dealii::Tensor<1, 3> e1 = b - a, e2 = c - a, d = p - a;
    const double e11 = e1 * e1, e12 = e1 * e2, e22 = e2 * e2;
    const double d1 = d * e1, d2 = d * e2;
    const double det      = e11 * e22 - e12 * e12;
    const bool degenerate = det <= 1e-14 * e11 * e22;

    if (!degenerate)
      {
        weights[1] = (e22 * d1 - e12 * d2) / det;
        weights[2] = (e11 * d2 - e12 * d1) / det;
        weights[0] = 1 - weights[1] - weights[2];
        if (weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0)
          return a + weights[1] * e1 + weights[2] * e2;
      }

    const dealii::Point<3> *corners[3] = {&a, &b, &c};
    const bool candidate[3]{degenerate || weights[0] < 0,
                            degenerate || weights[1] < 0,
                            degenerate || weights[2] < 0};
    dealii::Point<3> nearest;
    double least = -1;
    for (unsigned int i = 0; i < 3; ++i)
      if (candidate[i])
        {
          const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
          const double fraction =
            internal::nearest_fraction(p, *corners[j], *corners[k]);
          const dealii::Point<3> q =
            *corners[j] + fraction * (*corners[k] - *corners[j]);
          const double square = (p - q).norm_square();
          if (least < 0 || square < least)
            {
              least      = square;
              nearest    = q;
              weights[i] = 0;
              weights[j] = 1 - fraction;
              weights[k] = fraction;
            }
        }
    return nearest;
  }
} // namespace coapt

#endif
