#ifndef coapt_contact_facing_rule_h
#define coapt_contact_facing_rule_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /** A column of a mid-surface at its closest point on a triangle. */
  struct Encounter
  {
    unsigned int triangle = 0;
    double distance       = 0;       // m
    dealii::Tensor<1, 3> normal;     // unit vector to the closest point
    std::array<double, 3> weights{}; // of the triangle's corners there
  };

  /**
   * Tells the parts of a surface that face a column from those that go on
   * beside it. The neighbours of a column are left out of the search; what is
   * nearest in the rest of a flat sheet is the border of this hole, and
   * nothing is there that could be touched.
   *
   * A point faces the column if the distance is a local minimum there on the
   * whole surface, hole included: no triangle that shares the point is nearer.
   * The column then lies on the normal of that surface, or outside of its free
   * edge or crease. No angle has to be chosen, edges are found whichever way
   * they point, and the distance of a point that faces the column changes
   * without jumps while it slides over facets, creases and edges.
   */
  class FacingRule
  {
  public:
    /** Triangles with corners below @p n_columns. */
    FacingRule(const std::vector<std::array<unsigned int, 3>> &triangles,
               const unsigned int n_columns);

    /** Closest point of a triangle to a column at @p points (m). */
    Encounter
    encounter(const std::vector<dealii::Point<3>> &points,
              const unsigned int column,
              const unsigned int triangle) const;

    /** Whether the point of this encounter faces the column. */
    bool
    faces(const std::vector<dealii::Point<3>> &points,
          const unsigned int column,
          const Encounter &encounter) const;

    /** Corners of a triangle. */
    const std::array<unsigned int, 3> &
    corners(const unsigned int triangle) const;

    /** The first of the triangles that share the point of an encounter. */
    unsigned int
    first_sharing(const Encounter &encounter) const;

    /**
     * Goes from the triangle of @p found over those beside it to where the
     * distance from @p p (m) is a local minimum, and takes that for @p found.
     * Returns how much p is opposite to it: 0 in a triangle that
     * @p is_neighbour, else 1, but outside of a free edge 0 where the surface
     * lies beside p, 1 where it shows its edge to p and between both where the
     * cosine of the angle of the connection with the surface's normal falls
     * from 0.4 to 0.2.
     */
    double
    descend(const std::vector<dealii::Point<3>> &points,
            const dealii::Point<3> &p,
            const std::vector<bool> &is_neighbour,
            Encounter &found) const;

  private:
    /** The corners between which a point of the surface lies: three of a
     * triangle, two of an edge, or one. */
    struct Support
    {
      std::array<unsigned int, 3> columns{};
      unsigned int n = 0;
    };

    Support
    support(const Encounter &found) const;

    bool
    contains(const unsigned int triangle, const Support &support) const;

    double
    share(const std::vector<dealii::Point<3>> &points,
          const Encounter &found,
          const std::vector<bool> &is_neighbour) const;

    Encounter
    encounter(const std::vector<dealii::Point<3>> &points,
              const dealii::Point<3> &p,
              const unsigned int triangle) const;

    std::vector<std::array<unsigned int, 3>> triangles;
    std::vector<std::vector<unsigned int>> around; // triangles of a column
    std::vector<bool> is_free; // whether a column lies on a free edge
  };
} // namespace coapt

#endif
