#ifndef coapt_contact_facet_neighbours_h
#define coapt_contact_facet_neighbours_h

#include <coapt/geometry/simplex_mesh.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace coapt
{
  /**
   * Facets that never touch each other, since it would be the body itself that
   * lies between them, or only the corner in which both meet. What counts is
   * the reference.
   *
   * Opposite sides of a thin part, and the sides of an edge: each lies behind
   * the other, and the straight way from one to the other stays in the
   * solid. A right-angled edge is one as well, since it becomes an acute one as
   * soon as the body is sheared. Surfaces that are pressed into each other from
   * the start also lie behind each other, but the way through the cells does
   * not lead there.
   *
   * The sides of a corner that opens outwards come within the clearance of each
   * other when it closes a little, without touching. So what is close along the
   * surface is left out there.
   */
  template <int dim>
  class FacetNeighbours
  {
  public:
    /**
     * @p facets are outer ones with normals outwards. What is farther from each
     * other than @p across (m) through the solid or @p along (m) on the surface
     * is not a neighbour.
     */
    FacetNeighbours(const SimplexMesh<dim> &mesh,
                    const std::vector<std::array<unsigned int, dim>> &facets,
                    const double across,
                    const double along);

    /** Whether these facets are neighbours, in any order. */
    bool
    operator()(const unsigned int a, const unsigned int b);

  private:
    using Facet = std::array<unsigned int, dim>;

    /** A cell, and which of its nodes is not on the face. */
    using CellAndOpposite = std::pair<unsigned int, unsigned int>;

    /** Whether one lies behind the other and the solid in between. */
    bool
    across_the_solid(const unsigned int a, const unsigned int b) const;

    /** The cell in which the straight way from a facet's centre ends, after
     * @p way or where it leaves the solid. */
    unsigned int
    end_of_way(const unsigned int facet,
               const dealii::Tensor<1, dim> &way) const;

    /** Whether a chain of facets with common nodes leads from one to the other
     * and does not go farther away. */
    bool
    along_the_surface(const unsigned int a, const unsigned int b) const;

    const SimplexMesh<dim> mesh;
    const std::vector<Facet> facets;
    const double across, along;
    std::vector<dealii::Point<dim>> centres;
    std::vector<double> radii; // around the centres (m)
    std::vector<dealii::Tensor<1, dim>> normals;
    std::vector<CellAndOpposite> cell_behind; // by facet
    // Beyond the face opposite to each node: a cell, and its node opposite.
    std::vector<std::array<CellAndOpposite, dim + 1>> beyond;
    std::vector<std::vector<unsigned int>> facets_of_node;
    std::map<std::pair<unsigned int, unsigned int>, bool> known;
  };
} // namespace coapt

#endif
