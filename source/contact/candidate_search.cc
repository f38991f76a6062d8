#include <coapt/base/exceptions.h>
#include <coapt/contact/candidate_search.h>
#include <coapt/geometry/triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  using dealii::Point;

  /**
   * A grid of buckets over the bounding box of all points. Each triangle lies
   * in the bucket of its centroid, and reaches no farther than its radius.
   * Triangles are stored bucket after bucket.
   */
  struct CandidateSearch::Buckets
  {
    struct Entry
    {
      Point<3> centroid;
      double radius;
      unsigned int triangle;
    };

    Buckets(const std::vector<Point<3>> &points,
            const std::vector<std::array<unsigned int, 3>> &triangles,
            const double search_radius)
    {
      std::vector<Entry> unsorted(triangles.size());
      for (unsigned int t = 0; t < triangles.size(); ++t)
        {
          const Point<3> &a = points[triangles[t][0]],
                         &b = points[triangles[t][1]],
                         &c = points[triangles[t][2]];
          const Point<3> centroid((a + (b - a) / 3.) + (c - a) / 3.);
          const double radius = std::max(
            {centroid.distance(a), centroid.distance(b), centroid.distance(c)});
          unsorted[t]    = {centroid, radius, t};
          largest_radius = std::max(largest_radius, radius);
        }
      set_up_grid(points, search_radius + largest_radius);
      sort(unsorted);
    }

    void
    set_up_grid(const std::vector<Point<3>> &points, const double reach)
    {
      // A grid that a runaway node stretches must not exhaust the memory.
      const int max_buckets = 64;
      Point<3> upper        = points[0];
      lower                 = points[0];
      for (const auto &p : points)
        for (unsigned int d = 0; d < 3; ++d)
          {
            lower[d] = std::min(lower[d], p[d]);
            upper[d] = std::max(upper[d], p[d]);
          }
      for (unsigned int d = 0; d < 3; ++d)
        {
          const double extent = upper[d] - lower[d];
          width[d]            = std::max(reach, 1.01 * extent / max_buckets);
          n[d]                = static_cast<int>(extent / width[d]) + 1;
        }
    }

    int
    coordinate(const double x, const unsigned int d) const
    {
      const double i = std::floor((x - lower[d]) / width[d]);
      return static_cast<int>(std::min(std::max(i, 0.), n[d] - 1.));
    }

    int
    row(const int i, const int j) const
    {
      return (i * n[1] + j) * n[2];
    }

    void
    sort(const std::vector<Entry> &unsorted)
    {
      std::vector<int> bucket(unsorted.size());
      begin.assign(n[0] * n[1] * n[2] + 1, 0);
      for (unsigned int t = 0; t < unsorted.size(); ++t)
        {
          const Point<3> &p = unsorted[t].centroid;
          bucket[t] =
            row(coordinate(p[0], 0), coordinate(p[1], 1)) + coordinate(p[2], 2);
          ++begin[bucket[t] + 1];
        }
      for (unsigned int b = 1; b < begin.size(); ++b)
        begin[b] += begin[b - 1];
      std::vector<unsigned int> next(begin.begin(), begin.end() - 1);
      entries.resize(unsorted.size());
      for (unsigned int t = 0; t < unsorted.size(); ++t)
        entries[next[bucket[t]]++] = unsorted[t];
    }

    Point<3> lower;
    std::array<double, 3> width;
    std::array<int, 3> n;
    double largest_radius = 0;
    std::vector<unsigned int> begin;
    std::vector<Entry> entries;
  };



  CandidateSearch::CandidateSearch(
    const std::vector<Point<3>> &reference,
    const std::vector<std::array<unsigned int, 3>> &triangles,
    const double exclusion_distance,
    const std::vector<unsigned int> &columns)
    : triangles(triangles)
    , columns(columns)
    , excluded(columns.size())
    , found(columns.size())
    , mark(triangles.size(), columns.size())
  {
    exclude_neighbours(reference, exclusion_distance);
  }



  void
  CandidateSearch::exclude_neighbours(const std::vector<Point<3>> &reference,
                                      const double distance)
  {
    find(reference, distance);
    for (unsigned int i = 0; i < columns.size(); ++i)
      {
        const Point<3> &p = reference[columns[i]];
        for (const Candidate &candidate : found[i])
          {
            const auto &corner = triangles[candidate.triangle];
            double weights[3];
            if (p.distance(closest_point_on_triangle(p,
                                                     reference[corner[0]],
                                                     reference[corner[1]],
                                                     reference[corner[2]],
                                                     weights)) <= distance)
              excluded[i].push_back(candidate.triangle);
          }
        found[i].clear();
      }
    points_at_find.clear();
  }



  void
  CandidateSearch::find(const std::vector<Point<3>> &points,
                        const double radius)
  {
    points_at_find = points;
    visited        = 0;
    if (points.empty())
      return;
    const Buckets buckets(points, triangles, radius);
    std::fill(mark.begin(), mark.end(), columns.size());
    for (unsigned int i = 0; i < columns.size(); ++i)
      find_for_column(buckets, points[columns[i]], radius, i);
  }



  void
  CandidateSearch::find_for_column(const Buckets &buckets,
                                   const Point<3> &p,
                                   const double radius,
                                   const unsigned int i)
  {
    for (const unsigned int triangle : excluded[i])
      mark[triangle] = i;

    const double reach = radius + buckets.largest_radius;
    std::array<int, 3> from, to;
    for (unsigned int d = 0; d < 3; ++d)
      {
        from[d] = buckets.coordinate(p[d] - reach, d);
        to[d]   = buckets.coordinate(p[d] + reach, d);
      }
    found[i].clear();
    for (int k = from[0]; k <= to[0]; ++k)
      for (int j = from[1]; j <= to[1]; ++j)
        {
          const int row    = buckets.row(k, j);
          const auto end   = buckets.begin[row + to[2] + 1];
          const auto first = buckets.begin[row + from[2]];
          visited += end - first;
          for (auto e = first; e < end; ++e)
            {
              const auto &entry   = buckets.entries[e];
              const double limit  = radius + entry.radius;
              const double square = p.distance_square(entry.centroid);
              if (square <= limit * limit && mark[entry.triangle] != i)
                found[i].push_back(
                  {entry.triangle,
                   std::max(0., std::sqrt(square) - entry.radius)});
            }
        }
  }



  std::vector<CandidateSearch::Candidate> &
  CandidateSearch::candidates(const unsigned int i)
  {
    return found[i];
  }



  double
  CandidateSearch::displacement(const std::vector<Point<3>> &points) const
  {
    double sum = 0, largest = 0;
    for (unsigned int c = 0; c < points.size(); ++c)
      {
        const double square = points_at_find.empty()
          ? points[c].norm_square()
          : points[c].distance_square(points_at_find[c]);
        sum += square;
        largest = std::max(largest, square);
      }
    if (!std::isfinite(sum))
      throw NumericalError(
        "Contact: the position of the leaflet is not finite");
    return points_at_find.empty() ? std::numeric_limits<double>::infinity()
                                  : std::sqrt(largest);
  }
} // namespace coapt
