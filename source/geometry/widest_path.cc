#include <deal.II/base/mpi.h>

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

    struct Triangle
    {
      Point<3> corners[3];
      Tensor<1, 3> normal; // of unit length; zero if degenerate
      Point<3> center;
      double radius; // of a ball around the center that holds the triangle

      /** Vector to @p p from the nearest point. */
      Tensor<1, 3>
      vector_to(const Point<3> &p) const
      {
        double weights[3];
        return p -
          closest_point_on_triangle(
                 p, corners[0], corners[1], corners[2], weights);
      }

      /** Whether all of it lies where @p towards comes from, seen from @p p:
       * then it is not opposite to what is there. */
      bool
      on_same_side(const Point<3> &p, const Tensor<1, 3> &towards) const
      {
        return towards * (p - corners[0]) >= 0 &&
          towards * (p - corners[1]) >= 0 && towards * (p - corners[2]) >= 0;
      }
    };

    std::vector<Triangle>
    make_triangles(const std::vector<Point<3>> &points,
                   const std::vector<std::array<unsigned int, 3>> &triangles)
    {
      std::vector<Triangle> result;
      for (const auto &t : triangles)
        {
          Triangle triangle;
          for (unsigned int i = 0; i < 3; ++i)
            triangle.corners[i] = points[t[i]];
          triangle.center = points[t[0]] +
            ((points[t[1]] - points[t[0]]) + (points[t[2]] - points[t[0]])) / 3;
          triangle.radius = 0;
          for (const Point<3> &corner : triangle.corners)
            triangle.radius =
              std::max(triangle.radius, triangle.center.distance(corner));
          triangle.normal   = cross_product_3d(points[t[1]] - points[t[0]],
                                             points[t[2]] - points[t[0]]);
          const double norm = triangle.normal.norm();
          if (norm > 0)
            triangle.normal /= norm;
          result.push_back(triangle);
        }
      return result;
    }

    /** A regular grid of points, numbered from x to z, z first. */
    struct RegularGrid
    {
      RegularGrid(const Point<3> &lower,
                  const Point<3> &upper,
                  const double spacing)
        : lower(lower), spacing(spacing)
      {
        for (unsigned int d = 0; d < 3; ++d)
          size[d] = 1 +
            static_cast<int>(std::ceil((upper[d] - lower[d]) / spacing - 1e-9));
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

      std::size_t
      plane_size() const
      {
        return std::size_t(size[1]) * size[2];
      }

      Point<3> lower;
      double spacing;
      int size[3];
    };

    /** The distances of grid points from the sheet, in the planes from
     * number @p first_plane to before @p last_plane. */
    class Distances
    {
    public:
      Distances(const std::vector<Triangle> &sheet,
                const RegularGrid &grid,
                const double band,
                const int first_plane,
                const int last_plane)
        : sheet(sheet)
        , grid(grid)
        , band(band)
        , first_plane(first_plane)
        , last_plane(last_plane)
      {
        nearest.resize((last_plane - first_plane) * grid.plane_size(), band);
        slot.resize(nearest.size(), none);
        opposite = nearest;
        find_nearest();
        find_opposite();
      }

      /**
       * Largest distance from the sheet near each grid point, infinite beyond
       * the band. Halfway between two sheets it is the mean of the distances
       * from both; one moves there at most half a grid spacing from the point.
       */
      std::vector<float>
      clearances() const
      {
        std::vector<float> result(nearest.size(),
                                  std::numeric_limits<float>::infinity());
        for (std::size_t n = 0; n < result.size(); ++n)
          if (slot[n] != none)
            result[n] = std::min<float>(nearest[n] + grid.spacing / 2,
                                        (nearest[n] + opposite[n]) / 2);
        return result;
      }

    private:
      /** Calls @p action(n, point, triangle) for all points which the
       * triangle may be nearer to than @p best; n counts from the first
       * plane. */
      template <typename Action>
      void
      for_each_near_pair(const std::vector<float> &best,
                         const Action &action) const
      {
        for (const Triangle &triangle : sheet)
          {
            int first[3], last[3];
            for (unsigned int d = 0; d < 3; ++d)
              {
                const auto bounds = std::minmax({triangle.corners[0][d],
                                                 triangle.corners[1][d],
                                                 triangle.corners[2][d]});
                first[d]          = std::max<int>(0,
                                         std::ceil((bounds.first - band -
                                                    grid.lower[d]) /
                                                   grid.spacing));
                last[d]           = std::min<int>(grid.size[d] - 1,
                                        std::floor((bounds.second + band -
                                                    grid.lower[d]) /
                                                   grid.spacing));
              }
            for (int i = std::max(first[0], first_plane);
                 i <= std::min(last[0], last_plane - 1);
                 ++i)
              for (int j = first[1]; j <= last[1]; ++j)
                treat_row(triangle, i, j, first[2], last[2], best, action);
          }
      }

      /** The same for a row of points. Distances from the triangle's plane
       * and from a ball around it are lower bounds that cost little. */
      template <typename Action>
      void
      treat_row(const Triangle &triangle,
                const int i,
                const int j,
                const int first,
                const int last,
                const std::vector<float> &best,
                const Action &action) const
      {
        const std::size_t row =
          (std::size_t(i - first_plane) * grid.size[1] + j) * grid.size[2];
        const Point<3> begin =
          grid.point((std::size_t(i) * grid.size[1] + j) * grid.size[2]);
        const double height = triangle.normal * (begin - triangle.corners[0]);
        const double slope  = grid.spacing * triangle.normal[2];
        const Tensor<1, 3> offset = begin - triangle.center;
        const double across = offset[0] * offset[0] + offset[1] * offset[1];
        for (int l = first; l <= last; ++l)
          {
            const double limit = best[row + l];
            if (std::abs(height + l * slope) >= limit)
              continue;
            const double along = offset[2] + l * grid.spacing;
            const double reach = limit + triangle.radius;
            if (across + along * along < reach * reach)
              action(row + l,
                     begin + Tensor<1, 3>({0., 0., l * grid.spacing}),
                     triangle);
          }
      }

      void
      find_nearest()
      {
        for_each_near_pair(nearest,
                           [&](const std::size_t n,
                               const Point<3> &p,
                               const Triangle &triangle) {
                             const Tensor<1, 3> vector = triangle.vector_to(p);
                             const float distance      = vector.norm();
                             if (distance >= nearest[n])
                               return;
                             nearest[n] = distance;
                             if (slot[n] == none)
                               {
                                 slot[n] = towards.size();
                                 towards.emplace_back();
                               }
                             towards[slot[n]] = vector;
                           });
      }

      /** Distances from what is on the other side. */
      void
      find_opposite()
      {
        for_each_near_pair(opposite,
                           [&](const std::size_t n,
                               const Point<3> &p,
                               const Triangle &triangle) {
                             if (slot[n] == none ||
                                 triangle.on_same_side(p, towards[slot[n]]))
                               return;
                             const Tensor<1, 3> vector = triangle.vector_to(p);
                             const float distance      = vector.norm();
                             if (distance < opposite[n] &&
                                 towards[slot[n]] * vector < 0)
                               opposite[n] = distance;
                           });
      }

      const std::vector<Triangle> &sheet;
      const RegularGrid &grid;
      const float band;
      const int first_plane, last_plane;
      std::vector<float> nearest, opposite;

      // of points in the band: vector from the nearest point of the sheet
      std::vector<unsigned int> slot;
      std::vector<Tensor<1, 3>> towards;
    };

    /** The clearances at all grid points; each rank computes some planes. */
    std::vector<float>
    all_clearances(const std::vector<Triangle> &sheet,
                   const RegularGrid &grid,
                   const double band,
                   MPI_Comm communicator)
    {
      const int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      std::vector<int> begin, counts;
      for (int rank = 0; rank <= n_ranks; ++rank)
        begin.push_back(rank * grid.size[0] / n_ranks);
      const int rank = Utilities::MPI::this_mpi_process(communicator);
      const std::vector<float> own =
        Distances(sheet, grid, band, begin[rank], begin[rank + 1]).clearances();

      std::vector<float> all(grid.size[0] * grid.plane_size());
      for (int &plane : begin)
        plane *= grid.plane_size();
      for (int i = 0; i < n_ranks; ++i)
        counts.push_back(begin[i + 1] - begin[i]);
      MPI_Allgatherv(own.data(),
                     own.size(),
                     MPI_FLOAT,
                     all.data(),
                     counts.data(),
                     begin.data(),
                     MPI_FLOAT,
                     communicator);
      return all;
    }

    /** The flood: what is far from the sheet comes first, without order. */
    class Front
    {
    public:
      explicit Front(const std::vector<float> &clearance) : clearance(clearance)
      {
      }

      void
      push(const std::size_t n)
      {
        if (std::isinf(clearance[n]))
          open.push_back(n);
        else
          narrow.push({clearance[n], n});
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
      const std::vector<float> &clearance;
      std::vector<std::size_t> open;
      std::priority_queue<std::pair<float, std::size_t>> narrow;
    };

    /** Proceeds from the lower to the upper end of the grid, always at the
     * place of largest @p clearance; none of it counts for more than
     * @p band. */
    WidestPath
    flood(const RegularGrid &grid,
          const std::vector<float> &clearance,
          const std::function<bool(const Point<3> &)> &inside,
          const double thickness,
          const double band)
    {
      const std::size_t strides[3] = {grid.plane_size(),
                                      std::size_t(grid.size[2]),
                                      1};

      std::vector<char> seen(strides[0] * grid.size[0], false);
      Front front(clearance);
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
          if (clearance[n] < tightest)
            {
              tightest = clearance[n];
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
      return {0, grid.lower};
    }
  } // namespace



  WidestPath
  widest_path(const std::vector<Point<3>> &points,
              const std::vector<std::array<unsigned int, 3>> &triangles,
              const double thickness,
              const std::function<bool(const dealii::Point<3> &)> &inside,
              const Point<3> &lower,
              const Point<3> &upper,
              const double spacing,
              const double largest_width,
              MPI_Comm communicator)
  {
    for (unsigned int d = 0; d < 3; ++d)
      if (!(upper[d] > lower[d]) || !(spacing > 0) || !(thickness > 0))
        throw InputError("The widest path needs a box, a thickness and a grid "
                         "spacing of positive size.");
    const double step                 = std::min(spacing, 0.3 * thickness);
    const double band                 = (thickness + largest_width) / 2;
    const std::vector<Triangle> sheet = make_triangles(points, triangles);
    const auto path_on_grid = [&](const double spacing, const double band) {
      const RegularGrid grid(lower, upper, spacing);
      return flood(grid,
                   all_clearances(sheet, grid, band, communicator),
                   inside,
                   thickness,
                   band);
    };

    // An open valve shows on a coarse grid, at a fraction of the cost. There
    // clearances are up to half a spacing too large, and the sheet may come
    // nearer by as much between two points.
    const double coarse = 4 * step, wide_band = band + coarse;
    const WidestPath on_coarse = path_on_grid(coarse, wide_band);
    if (on_coarse.width >= 2 * wide_band - thickness)
      return {largest_width, on_coarse.position};
    return path_on_grid(step, band);
  }
} // namespace coapt
