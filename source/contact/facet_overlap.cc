#include <coapt/contact/facet_overlap.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** A corner of the overlap in the coordinates of both facets. */
    template <int dim>
    struct Corner
    {
      std::array<double, dim> own, partner;
    };

    template <int dim>
    Corner<dim>
    between(const Corner<dim> &a, const Corner<dim> &b, const double share)
    {
      Corner<dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        {
          result.own[i] = a.own[i] + share * (b.own[i] - a.own[i]);
          result.partner[i] =
            a.partner[i] + share * (b.partner[i] - a.partner[i]);
        }
      return result;
    }

    /** Cuts off what has a negative i-th coordinate in the facet. A polyline in
     * 2D, a polygon in 3D. */
    template <int dim>
    void
    cut(std::vector<Corner<dim>> &polygon, const unsigned int i)
    {
      static thread_local std::vector<Corner<dim>> kept;
      kept.clear();
      const unsigned int n = polygon.size();
      for (unsigned int c = 0; c < n; ++c)
        {
          const Corner<dim> &corner = polygon[c];
          if (corner.own[i] >= 0)
            kept.push_back(corner);
          if (dim == 2 && c + 1 == n)
            continue; // not closed
          const Corner<dim> &next = polygon[(c + 1) % n];
          if ((corner.own[i] >= 0) != (next.own[i] >= 0))
            kept.push_back(between(
              corner, next, corner.own[i] / (corner.own[i] - next.own[i])));
        }
      polygon.swap(kept);
    }

    template <int dim>
    Point<dim>
    place(const std::array<Point<dim>, dim> &facet,
          const std::array<double, dim> &weights)
    {
      Point<dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        result += weights[i] * facet[i];
      return result;
    }

    std::array<double, 2>
    coordinates(const std::array<Point<2>, 2> &facet, const Point<2> &x)
    {
      const Tensor<1, 2> along = facet[1] - facet[0];
      const double share       = (x - facet[0]) * along / along.norm_square();
      return {{1 - share, share}};
    }

    /** Coordinates of the projection of a point along the normal. */
    std::array<double, 3>
    coordinates(const std::array<Point<3>, 3> &facet, const Point<3> &x)
    {
      const Tensor<1, 3> u = facet[1] - facet[0], v = facet[2] - facet[0];
      const Tensor<1, 3> n = cross_product_3d(u, v), w = x - facet[0];
      const double square = n.norm_square();
      const double second = (cross_product_3d(w, v) * n) / square;
      const double third  = (cross_product_3d(u, w) * n) / square;
      return {{1 - second - third, second, third}};
    }

    /** Area of a simplex over that of the facet that it lies in. */
    template <int dim>
    double
    relative_area(const std::array<Corner<dim>, dim> &part)
    {
      if constexpr (dim == 2)
        return std::abs(part[1].own[1] - part[0].own[1]);
      else
        return std::abs((part[1].own[1] - part[0].own[1]) *
                          (part[2].own[2] - part[0].own[2]) -
                        (part[1].own[2] - part[0].own[2]) *
                          (part[2].own[1] - part[0].own[1]));
    }

    /** A rule of @p dim points, exact for quadratic polynomials on a simplex of
     * dimension dim - 1: Gauss' one, and that of Hammer and Stroud (1956). */
    template <int dim>
    constexpr double near_weight = dim == 2 ? 0.78867513459481288 : 2. / 3.;

    template <int dim>
    void
    add_points(const std::array<Corner<dim>, dim> &part,
               const std::array<Point<dim>, dim> &facet,
               const std::array<Point<dim>, dim> &partner,
               const Tensor<1, dim> &area_normal,
               std::vector<OverlapPoint<dim>> &points)
    {
      const double area = area_normal.norm();
      const double far  = (1 - near_weight<dim>) / (dim - 1);
      for (unsigned int q = 0; q < dim; ++q)
        {
          OverlapPoint<dim> point;
          for (unsigned int i = 0; i < dim; ++i)
            {
              point.own[i] = point.partner[i] = 0;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const double weight = c == q ? near_weight<dim> : far;
                  point.own[i] += weight * part[c].own[i];
                  point.partner[i] += weight * part[c].partner[i];
                }
            }
          point.gap = (place<dim>(partner, point.partner) -
                       place<dim>(facet, point.own)) *
            area_normal / area;
          point.area = area * relative_area<dim>(part) / dim;
          points.push_back(point);
        }
    }
  } // namespace



  template <int dim>
  Tensor<1, dim>
  area_normal(const std::array<Point<dim>, dim> &facet)
  {
    if constexpr (dim == 2)
      return cross_product_2d(facet[1] - facet[0]);
    else
      return 0.5 * cross_product_3d(facet[1] - facet[0], facet[2] - facet[0]);
  }



  template <int dim>
  void
  add_overlap(const std::array<Point<dim>, dim> &facet,
              const std::array<Point<dim>, dim> &partner,
              std::vector<OverlapPoint<dim>> &points)
  {
    static thread_local std::vector<Corner<dim>> polygon;
    polygon.resize(dim);
    for (unsigned int i = 0; i < dim; ++i)
      {
        polygon[i].own = coordinates(facet, partner[i]);
        polygon[i].partner.fill(0.);
        polygon[i].partner[i] = 1;
      }
    for (unsigned int i = 0; i < dim; ++i)
      cut<dim>(polygon, i);
    if (polygon.size() < dim)
      return;

    const Tensor<1, dim> normal = area_normal<dim>(facet);
    std::array<Corner<dim>, dim> part;
    part[0] = polygon[0];
    for (unsigned int c = 1; c + dim - 2 < polygon.size(); ++c)
      {
        for (unsigned int i = 1; i < dim; ++i)
          part[i] = polygon[c + i - 1];
        if (relative_area<dim>(part) > 0)
          add_points<dim>(part, facet, partner, normal, points);
      }
  }



  template Tensor<1, 2>
  area_normal<2>(const std::array<Point<2>, 2> &);
  template Tensor<1, 3>
  area_normal<3>(const std::array<Point<3>, 3> &);
  template void
  add_overlap<2>(const std::array<Point<2>, 2> &,
                 const std::array<Point<2>, 2> &,
                 std::vector<OverlapPoint<2>> &);
  template void
  add_overlap<3>(const std::array<Point<3>, 3> &,
                 const std::array<Point<3>, 3> &,
                 std::vector<OverlapPoint<3>> &);
} // namespace coapt
