#ifndef coapt_contact_candidate_search_h
#define coapt_contact_candidate_search_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Finds the triangles of the mid-surface near each column by sorting the
   * triangles into buckets. Neighbours of a column are never candidates:
   * triangles whose closest point is within the exclusion distance of it in
   * the reference configuration (the centroid would not do: with it
   * neighbours repel each other).
   */
  class CandidateSearch
  {
  public:
    /** A triangle, and a lower bound of its distance (m) from the column at
     * the positions of the last find(). */
    struct Candidate
    {
      unsigned int triangle;
      double least_distance;
    };

    /** Searches on behalf of @p columns only, the share of this rank.
     * @p reference holds the positions of all columns (m). */
    CandidateSearch(const std::vector<dealii::Point<3>> &reference,
                    const std::vector<std::array<unsigned int, 3>> &triangles,
                    const double exclusion_distance,
                    const std::vector<unsigned int> &columns);

    /**
     * Gathers all triangles within @p radius (m) for the columns at
     * @p points, and keeps the points for displacement(). Distances are
     * bounded by spheres around the triangles, so some triangles beyond the
     * radius are gathered, too.
     */
    void
    find(const std::vector<dealii::Point<3>> &points, const double radius);

    /** The candidates of the i-th column of this rank. Who measures a distance
     * may raise its lower bound. */
    std::vector<Candidate> &
    candidates(const unsigned int i);

    /** The neighbours of the i-th column of this rank. */
    const std::vector<unsigned int> &
    neighbours(const unsigned int i) const
    {
      return excluded[i];
    }

    /** How many triangles the last find() has looked at, each once for each
     * column: its cost. */
    std::size_t
    n_visited() const
    {
      return visited;
    }

    /**
     * Largest displacement of a column (m) since find(), infinite before it.
     * Throws NumericalError if a position is not finite.
     */
    double
    displacement(const std::vector<dealii::Point<3>> &points) const;

    /** Where the points were in the last find() (m). */
    const std::vector<dealii::Point<3>> &
    searched_points() const
    {
      return points_at_find;
    }

  private:
    struct Buckets;

    void
    exclude_neighbours(const std::vector<dealii::Point<3>> &reference,
                       const double distance);

    void
    find_for_column(const Buckets &buckets,
                    const dealii::Point<3> &p,
                    const double radius,
                    const unsigned int i);

    std::vector<std::array<unsigned int, 3>> triangles;
    std::vector<unsigned int> columns;
    std::vector<std::vector<unsigned int>> excluded;
    std::vector<std::vector<Candidate>> found;
    std::vector<unsigned int> mark; // scratch, by triangle
    std::size_t visited = 0;
    std::vector<dealii::Point<3>> points_at_find;
  };
} // namespace coapt

#endif
