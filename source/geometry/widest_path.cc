#include <coapt/base/exceptions.h>
#include <coapt/geometry/triangle.h>
#include <coapt/geometry/widest_path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    struct Sheet
    {
      const std::vector<Point<3>> &points;
      const std::vector<std::array<unsigned int, 3>> &triangles;

      /** Vector from the nearest point of triangle @p k to @p p. */
      Tensor<1, 3>
      from_triangle(const unsigned int k, const Point<3> &p) const
      {
        double weights[3];
        const auto &t = triangles[k];
        return p -
          closest_point_on_triangle(
                 p, points[t[0]], points[t[1]], points[t[2]], weights);
      }
    };

    /** A regular grid of points and the distances of each from the sheet. */
    class DistanceGrid
    {
    public:
      DistanceGrid(const Sheet &sheet,
                   const Point<3> &lower,
                   const Point<3> &upper,
                   const double spacing,
                   const double band)
        : sheet(sheet), lower(lower), spacing(spacing), band(band)
      {
        for (unsigned int d = 0; d < 3; ++d)
          size[d] = 1 +
            static_cast<int>(std::ceil((upper[d] - lower[d]) / spacing - 1e-9));
        nearest.resize(std::size_t(size[0]) * size[1] * size[2], band);
        triangle.resize(nearest.size(), none);
        opposite = nearest;
        find_nearest();
        find_opposite();
      }

      Point<3>
      point(const std::size_t n) const
      {
        const std::size_t column = n / size[2];
        return lower +
          spacing *
          Tensor<1, 3>({double(column / size[1]),
                        double(column % size[1]),
                        double(n % size[2])});
      }

      /**
       * Largest distance from the sheet near a grid point. Halfway between
       * two sheets it is the mean of the distances from both; one moves there
       * at most half a grid spacing from the point.
       */
      double
      clearance(const std::size_t n) const
      {
        return std::min<double>(nearest[n] + spacing / 2,
                                (nearest[n] + opposite[n]) / 2);
      }

      bool
      far(const std::size_t n) const
      {
        return triangle[n] == none;
      }

      int size[3];

    private:
      /** Calls @p action(n, k, vector from triangle k to point n) for all
       * points in the band around each triangle. */
      template <typename Action>
      void
      for_each_near_pair(const Action &action)
      {
        for (unsigned int k = 0; k < sheet.triangles.size(); ++k)
          {
            int first[3], last[3];
            for (unsigned int d = 0; d < 3; ++d)
              {
                double least = std::numeric_limits<double>::max();
                double most  = -least;
                for (const unsigned int v : sheet.triangles[k])
                  {
                    least = std::min(least, sheet.points[v][d]);
                    most  = std::max(most, sheet.points[v][d]);
                  }
                first[d] =
                  std::max<int>(0,
                                std::ceil((least - band - lower[d]) / spacing));
                last[d] =
                  std::min<int>(size[d] - 1,
                                std::floor((most + band - lower[d]) / spacing));
              }
            for (int i = first[0]; i <= last[0]; ++i)
              for (int j = first[1]; j <= last[1]; ++j)
                for (int l = first[2]; l <= last[2]; ++l)
                  action((std::size_t(i) * size[1] + j) * size[2] + l, k);
          }
      }

      void
      find_nearest()
      {
        for_each_near_pair([&](const std::size_t n, const unsigned int k) {
          const float distance = sheet.from_triangle(k, point(n)).norm();
          if (distance < nearest[n])
            {
              nearest[n]  = distance;
              triangle[n] = k;
            }
        });
      }

      /** Distances from what is on the other side. */
      void
      find_opposite()
      {
        for_each_near_pair([&](const std::size_t n, const unsigned int k) {
          if (triangle[n] == none)
            return;
          const Point<3> p           = point(n);
          const Tensor<1, 3> towards = sheet.from_triangle(triangle[n], p);
          const Tensor<1, 3> other   = sheet.from_triangle(k, p);
          const float distance       = other.norm();
          if (distance < opposite[n] && towards * other < 0)
            opposite[n] = distance;
        });
      }

      const Sheet sheet;
      const Point<3> lower;
      const double spacing;
      const float band;
      std::vector<float> nearest, opposite;
      std::vector<unsigned int> triangle;
    };

    /** The flood: what is far from the sheet comes first, without order. */
    class Front
    {
    public:
      explicit Front(const DistanceGrid &grid) : grid(grid)
      {
      }

      void
      push(const std::size_t n)
      {
        if (grid.far(n))
          open.push_back(n);
        else
          narrow.push({grid.clearance(n), n});
      }

      bool
      empty() const
      {
        return open.empty() && narrow.empty();
      }

      std::size_t
      pop()
      {
        std::size_t n;
        if (!open.empty())
          {
            n = open.back();
            open.pop_back();
          }
        else
          {
            n = narrow.top().second;
            narrow.pop();
          }
        return n;
      }

    private:
      const DistanceGrid &grid;
      std::vector<std::size_t> open;
      std::priority_queue<std::pair<double, std::size_t>> narrow;
    };
  } // namespace



  WidestPath
  widest_path(const std::vector<Point<3>> &points,
              const std::vector<std::array<unsigned int, 3>> &triangles,
              const double thickness,
              const std::function<bool(const dealii::Point<3> &)> &inside,
              const Point<3> &lower,
              const Point<3> &upper,
              const double spacing,
              const double largest_width)
  {
    for (unsigned int d = 0; d < 3; ++d)
      if (!(upper[d] > lower[d]) || !(spacing > 0) || !(thickness > 0))
        throw InputError("The widest path needs a box, a thickness and a grid "
                         "spacing of positive size.");
    const double step = std::min(spacing, 0.3 * thickness);
    const double band = (thickness + largest_width) / 2;
    const DistanceGrid grid(Sheet{points, triangles}, lower, upper, step, band);
    const std::size_t strides[3] = {std::size_t(grid.size[1]) * grid.size[2],
                                    std::size_t(grid.size[2]),
                                    1};

    std::vector<char> seen(strides[0] * grid.size[0], false);
    Front front(grid);
    const auto visit = [&](const std::size_t n) {
      if (!seen[n])
        {
          seen[n] = true;
          if (inside(grid.point(n)))
            front.push(n);
        }
    };
    for (std::size_t n = 0; n < seen.size(); n += strides[1])
      visit(n);
    if (front.empty())
      throw InputError("The widest path starts at the lower end of its box, "
                       "but no point of it is in the lumen.");

    double tightest   = band;
    std::size_t place = none;
    while (!front.empty())
      {
        const std::size_t n = front.pop();
        if (grid.far(n) == false && grid.clearance(n) < tightest)
          {
            tightest = grid.clearance(n);
            place    = n;
          }
        const int k = n % grid.size[2], j = n / strides[1] % grid.size[1],
                  i = n / strides[0];
        if (k + 1 == grid.size[2])
          return {std::max(0., 2 * tightest - thickness),
                  grid.point(place == none ? n : place)};
        const int index[3] = {i, j, k};
        for (unsigned int d = 0; d < 3; ++d)
          {
            if (index[d] > 0)
              visit(n - strides[d]);
            if (index[d] + 1 < grid.size[d])
              visit(n + strides[d]);
          }
      }
    // the lumen itself does not connect both ends
    return {0, lower};
  }



  std::vector<std::array<unsigned int, 3>>
  triangulate(const std::vector<std::array<unsigned int, 4>> &quads)
  {
    std::vector<std::array<unsigned int, 3>> triangles;
    for (const auto &quad : quads)
      {
        triangles.push_back({{quad[0], quad[1], quad[2]}});
        triangles.push_back({{quad[0], quad[2], quad[3]}});
      }
    return triangles;
  }
} // namespace coapt
