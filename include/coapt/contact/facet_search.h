#ifndef coapt_contact_facet_search_h
#define coapt_contact_facet_search_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Finds the facets near each facet with a tree of their boxes. Facets that
   * share a node are neighbours and never candidates.
   */
  template <int dim>
  class FacetSearch
  {
  public:
    /** Searches on behalf of the @p own facets among all @p facets, which are
     * given by their nodes. */
    FacetSearch(const std::vector<std::array<unsigned int, dim>> &facets,
                const std::vector<unsigned int> &own);

    /** Gathers the facets whose boxes are within @p reach (m) of those of the
     * own ones, for nodes at @p points. */
    void
    find(const std::vector<dealii::Point<dim>> &points, const double reach);

    /** Candidates of the i-th own facet, in ascending order. */
    const std::vector<unsigned int> &
    candidates(const unsigned int i) const
    {
      return found[i];
    }

    /**
     * Largest displacement of a node of a facet (m) since find(), infinite
     * before it. Throws NumericalError if a position is not finite.
     */
    double
    displacement(const std::vector<dealii::Point<dim>> &points) const;

  private:
    std::vector<std::array<unsigned int, dim>> facets;
    std::vector<unsigned int> own;
    std::vector<unsigned int> nodes; // of the facets, each once
    std::vector<std::vector<unsigned int>> found;
    std::vector<dealii::Point<dim>> points_at_find;
  };
} // namespace coapt

#endif
