#ifndef coapt_contact_facet_overlap_h
#define coapt_contact_facet_overlap_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /** A point of a facet and what lies on its normal there. */
  template <int dim>
  struct OverlapPoint
  {
    /** Barycentric coordinates in the facet and in its partner. */
    std::array<double, dim> own, partner;

    /** Distance along the facet's normal to the partner (m); negative behind
     * the facet. */
    double gap;

    /** Area of the facet for which the point stands (m^2; in 2D m). */
    double area;
  };

  /** Normal of a facet (an edge in 2D, a triangle in 3D) with its area (m^2; in
   * 2D m) as its length. In 2D it points to the right on the way from the first
   * corner to the second; in 3D corners are counterclockwise seen from where it
   * points. */
  template <int dim>
  dealii::Tensor<1, dim>
  area_normal(const std::array<dealii::Point<dim>, dim> &facet);

  /**
   * Adds to @p points a quadrature of the part of @p facet that has @p partner
   * on its normal. The partner is projected along the normal and cut off at
   * the edges of the facet (Sutherland and Hodgman 1974, in barycentric
   * coordinates); the rule integrates polynomials of second degree, as the
   * product of a pressure linear in the gap and a shape function, exactly on
   * both facets. So a uniform pressure gives the nodes of both sides what
   * belongs to them, whatever the meshes (compare Puso and Laursen 2004).
   */
  template <int dim>
  void
  add_overlap(const std::array<dealii::Point<dim>, dim> &facet,
              const std::array<dealii::Point<dim>, dim> &partner,
              std::vector<OverlapPoint<dim>> &points);
} // namespace coapt

#endif
