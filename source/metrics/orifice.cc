#include <coapt/metrics/orifice.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** A rectangular grid of points in the plane, with a mark for each. */
    struct Grid
    {
      Grid(const std::vector<Point<3>> &points, const double spacing)
        : spacing(spacing)
      {
        Point<2> upper;
        for (unsigned int d = 0; d < 2; ++d)
          {
            const auto less = [d](const auto &a, const auto &b) {
              return a[d] < b[d];
            };
            const auto ends =
              std::minmax_element(points.begin(), points.end(), less);
            lower[d] = (*ends.first)[d];
            n[d]     = 1 + unsigned(((*ends.second)[d] - lower[d]) / spacing);
          }
        open.assign(std::size_t(n[0]) * n[1], true);
      }

      Point<2>
      point(const unsigned int i, const unsigned int j) const
      {
        return {lower[0] + spacing * i, lower[1] + spacing * j};
      }

      /** First number of a line of the grid at or beyond x, and the one behind
       * the last at or before it, within the grid. @{ */
      unsigned int
      begin(const double x, const unsigned int d) const
      {
        return std::clamp(std::ceil((x - lower[d]) / spacing), 0., n[d] * 1.);
      }
      unsigned int
      end(const double x, const unsigned int d) const
      {
        return std::clamp(std::floor((x - lower[d]) / spacing) + 1,
                          0.,
                          n[d] * 1.);
      }
      /** @} */

      /** Hides what is behind a triangle. */
      void
      hide(const Point<3> &a, const Point<3> &b, const Point<3> &c)
      {
        const auto side = [](const Point<3> &p,
                             const Point<3> &q,
                             const Point<2> &x) {
          return (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
        };
        const unsigned int i_end = end(std::max({a[0], b[0], c[0]}), 0),
                           j_end = end(std::max({a[1], b[1], c[1]}), 1);
        for (unsigned int j = begin(std::min({a[1], b[1], c[1]}), 1); j < j_end;
             ++j)
          for (unsigned int i = begin(std::min({a[0], b[0], c[0]}), 0);
               i < i_end;
               ++i)
            {
              const Point<2> x = point(i, j);
              const double s = side(a, b, x), t = side(b, c, x),
                           u = side(c, a, x);
              if ((s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0))
                open[i + std::size_t(n[0]) * j] = false;
            }
      }

      double spacing;
      Point<2> lower;
      std::array<unsigned int, 2> n;
      std::vector<bool> open;
    };

    /** Squares of distances on a line: min over k of f[k] + (i - k)^2, the
     * lower envelope of parabolas (Felzenszwalb and Huttenlocher, 2012). */
    void
    transform(std::vector<double> &f)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      std::vector<unsigned int> vertex;
      std::vector<double> from; // where each parabola becomes the lowest
      for (unsigned int i = 0; i < f.size(); ++i)
        {
          if (f[i] == infinity)
            continue;
          double start = -infinity;
          while (!vertex.empty())
            {
              const double k = vertex.back();
              start =
                (f[i] + i * 1. * i - f[vertex.back()] - k * k) / (2 * (i - k));
              if (start > from.back())
                break;
              vertex.pop_back();
              from.pop_back();
              start = -infinity;
            }
          vertex.push_back(i);
          from.push_back(start);
        }
      if (vertex.empty())
        return;
      std::vector<double> result(f.size());
      for (unsigned int i = 0, k = 0; i < f.size(); ++i)
        {
          while (k + 1 < vertex.size() && from[k + 1] < i)
            ++k;
          const double distance = i - 1. * vertex[k];
          result[i]             = f[vertex[k]] + distance * distance;
        }
      f = result;
    }

    /** Square of the distance of each point to the nearest one that is not
     * open, in grid spacings. */
    std::vector<double>
    squared_distances(const Grid &grid)
    {
      const unsigned int nx = grid.n[0], ny = grid.n[1];
      std::vector<double> squares(grid.open.size());
      for (std::size_t k = 0; k < squares.size(); ++k)
        squares[k] =
          grid.open[k] ? std::numeric_limits<double>::infinity() : 0.;
      std::vector<double> line;
      const auto along = [&](const std::size_t first,
                             const std::size_t stride,
                             const unsigned int n) {
        line.resize(n);
        for (unsigned int i = 0; i < n; ++i)
          line[i] = squares[first + stride * i];
        transform(line);
        for (unsigned int i = 0; i < n; ++i)
          squares[first + stride * i] = line[i];
      };
      for (unsigned int j = 0; j < ny; ++j)
        along(std::size_t(nx) * j, 1, nx);
      for (unsigned int i = 0; i < nx; ++i)
        along(i, nx, ny);
      return squares;
    }
  } // namespace



  Orifice
  seen_orifice(const std::vector<Point<3>> &points,
               const std::vector<std::array<unsigned int, 3>> &triangles,
               const std::function<bool(const Point<3> &)> &inside,
               const double spacing)
  {
    Grid grid(points, spacing);
    const unsigned int nx = grid.n[0];
    for (std::size_t k = 0; k < grid.open.size(); ++k)
      {
        const Point<2> x = grid.point(k % nx, k / nx);
        grid.open[k]     = inside(Point<3>(x[0], x[1], 0));
      }
    for (const auto &[a, b, c] : triangles)
      grid.hide(points[a], points[b], points[c]);

    const std::vector<double> squares = squared_distances(grid);
    Orifice result;
    double largest = 0;
    for (std::size_t k = 0; k < squares.size(); ++k)
      {
        result.area += grid.open[k] ? spacing * spacing : 0.;
        if (grid.open[k] && squares[k] > largest)
          {
            largest       = squares[k];
            result.center = grid.point(k % nx, k / nx);
          }
      }
    // The edge is on average half a spacing before the first hidden point.
    if (largest > 0)
      result.disc = 2 * spacing * (std::sqrt(largest) - 0.5);
    return result;
  }



  double
  effective_orifice_area(const double leak,
                         const double pressure,
                         const double density)
  {
    return leak > 0 && pressure > 0 ? leak / std::sqrt(2 * pressure / density)
                                    : 0.;
  }



  bool
  orifices_agree(const double seen, const double effective, const double factor)
  {
    return seen <= factor * effective && effective <= factor * seen;
  }
} // namespace coapt
