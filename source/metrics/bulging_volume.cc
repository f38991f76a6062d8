#include <coapt/base/exceptions.h>
#include <coapt/metrics/bulging_volume.h>

#include <deal.II/lac/householder.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** Mean over a triangle of the positive part of a function that is linear
     * with the given values at the corners. */
    double
    mean_positive_part(std::array<double, 3> h)
    {
      std::sort(h.begin(), h.end());
      const double mean = (h[0] + h[1] + h[2]) / 3;
      if (h[0] >= 0)
        return mean;
      if (h[2] <= 0)
        return 0;
      if (h[1] <= 0)
        return h[2] / 3 * h[2] * h[2] / ((h[2] - h[0]) * (h[2] - h[1]));
      return mean - h[0] / 3 * h[0] * h[0] / ((h[0] - h[1]) * (h[0] - h[2]));
    }

    /** Whether the projection of @p p along z is inside the polygon (even-odd
     * rule). */
    bool
    is_inside(const std::vector<Point<3>> &polygon, const Point<3> &p)
    {
      bool inside = false;
      for (unsigned int i = 0, j = polygon.size() - 1; i < polygon.size();
           j = i++)
        {
          const Point<3> &a = polygon[i], &b = polygon[j];
          if ((a[1] > p[1]) != (b[1] > p[1]) &&
              p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
            inside = !inside;
        }
      return inside;
    }

    /** Sum over the facets inside the annulus of the mean of the positive part
     * of a @p height above the surface that spans it times a @p size of their
     * area vectors. */
    double
    sum_over_bulging_facets(
      const std::vector<Point<3>> &annulus,
      const std::vector<Point<3>> &points,
      const std::vector<std::array<unsigned int, 3>> &triangles,
      double (SpanningSurface::*height)(const Point<3> &) const,
      const std::function<double(const dealii::Tensor<1, 3> &)> &size)
    {
      const SpanningSurface surface(annulus);
      double sum = 0;
      for (const auto &[a, b, c] : triangles)
        {
          const double mean =
            mean_positive_part({{(surface.*height)(points[a]),
                                 (surface.*height)(points[b]),
                                 (surface.*height)(points[c])}});
          if (mean == 0)
            continue;
          const auto ab = points[b] - points[a], ac = points[c] - points[a];
          if (is_inside(annulus, points[a] + (ab + ac) / 3.))
            sum += mean * size(0.5 * cross_product_3d(ab, ac));
        }
      return sum;
    }
  } // namespace



  SpanningSurface::SpanningSurface(const std::vector<Point<3>> &annulus)
  {
    const unsigned int n = annulus.size();
    if (n < 5)
      throw InputError("Bulging volume: the annulus has " + std::to_string(n) +
                       " points; at least 5 are needed.");
    for (const auto &p : annulus)
      center += (p - Point<3>()) / n;
    for (unsigned int d = 0; d < 2; ++d)
      {
        double square = 0;
        for (const auto &p : annulus)
          square += (p[d] - center[d]) * (p[d] - center[d]) / n;
        scale[d] = std::sqrt(2 * square);
        if (!(scale[d] > 0))
          throw InputError("Bulging volume: the annulus has no extent along " +
                           std::string(d == 0 ? "x" : "y") + ".");
      }

    dealii::FullMatrix<double> matrix(n, 5);
    dealii::Vector<double> z(n), solution(5);
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto row = basis(annulus[i]);
        for (unsigned int k = 0; k < 5; ++k)
          matrix(i, k) = row[k];
        z[i] = annulus[i][2];
      }
    dealii::Householder<double>(matrix).least_squares(solution, z);
    for (unsigned int k = 0; k < 5; ++k)
      {
        coefficients[k] = solution[k];
        if (!std::isfinite(coefficients[k]))
          throw InputError("Bulging volume: the points of the annulus do not "
                           "determine a surface; do they lie on a line?");
      }
  }



  std::array<double, 5>
  SpanningSurface::basis(const Point<3> &point) const
  {
    const double xi  = (point[0] - center[0]) / scale[0];
    const double eta = (point[1] - center[1]) / scale[1];
    return {{1., xi, eta, xi * xi - eta * eta, xi * eta}};
  }



  double
  SpanningSurface::height_above(const Point<3> &point) const
  {
    const auto functions = basis(point);
    double height        = point[2];
    for (unsigned int k = 0; k < 5; ++k)
      height -= coefficients[k] * functions[k];
    return height;
  }



  double
  SpanningSurface::distance_above(const Point<3> &point) const
  {
    // The foot of the perpendicular, by Newton's method from the point below.
    const double height = height_above(point);
    Point<3> foot       = point;
    dealii::Tensor<2, 2> hessian;
    hessian[0][0] = 2 * coefficients[3] / (scale[0] * scale[0]);
    hessian[1][1] = -2 * coefficients[3] / (scale[1] * scale[1]);
    hessian[0][1] = hessian[1][0] = coefficients[4] / (scale[0] * scale[1]);
    for (unsigned int iteration = 0; iteration < 8; ++iteration)
      {
        foot[2] -= height_above(foot);
        const double xi  = (foot[0] - center[0]) / scale[0];
        const double eta = (foot[1] - center[1]) / scale[1];
        dealii::Tensor<1, 2> slope, residual;
        slope[0] =
          (coefficients[1] + 2 * coefficients[3] * xi + coefficients[4] * eta) /
          scale[0];
        slope[1] =
          (coefficients[2] - 2 * coefficients[3] * eta + coefficients[4] * xi) /
          scale[1];
        dealii::Tensor<2, 2> jacobian = (foot[2] - point[2]) * hessian;
        for (unsigned int d = 0; d < 2; ++d)
          {
            residual[d] = foot[d] - point[d] + (foot[2] - point[2]) * slope[d];
            jacobian[d][d] += 1;
          }
        jacobian += outer_product(slope, slope);
        const dealii::Tensor<1, 2> step = invert(jacobian) * residual;
        foot[0] -= step[0];
        foot[1] -= step[1];
      }
    foot[2] -= height_above(foot);
    return std::copysign(point.distance(foot), height);
  }



  double
  bulging_volume(const std::vector<Point<3>> &annulus,
                 const std::vector<Point<3>> &points,
                 const std::vector<std::array<unsigned int, 3>> &triangles)
  {
    return sum_over_bulging_facets(annulus,
                                   points,
                                   triangles,
                                   &SpanningSurface::height_above,
                                   [](const dealii::Tensor<1, 3> &area) {
                                     return -area[2];
                                   });
  }



  double
  bulging_by_distance(const std::vector<Point<3>> &annulus,
                      const std::vector<Point<3>> &points,
                      const std::vector<std::array<unsigned int, 3>> &triangles)
  {
    return sum_over_bulging_facets(annulus,
                                   points,
                                   triangles,
                                   &SpanningSurface::distance_above,
                                   [](const dealii::Tensor<1, 3> &area) {
                                     return area.norm();
                                   });
  }



  std::array<double, n_regions>
  bulging_by_region(const std::vector<Point<3>> &annulus,
                    const std::vector<Point<3>> &points,
                    const std::vector<std::array<unsigned int, 3>> &triangles,
                    const std::vector<Region> &regions)
  {
    std::array<std::vector<std::array<unsigned int, 3>>, n_regions> parts;
    for (unsigned int i = 0; i < triangles.size(); ++i)
      parts[static_cast<unsigned int>(regions[i])].push_back(triangles[i]);
    std::array<double, n_regions> result;
    for (unsigned int i = 0; i < n_regions; ++i)
      result[i] = bulging_volume(annulus, points, parts[i]);
    return result;
  }
} // namespace coapt
