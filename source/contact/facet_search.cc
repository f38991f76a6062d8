#include <coapt/base/exceptions.h>
#include <coapt/contact/facet_search.h>

#include <deal.II/base/bounding_box.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace coapt
{
  using dealii::Point;

  template <int dim>
  FacetSearch<dim>::FacetSearch(
    const std::vector<std::array<unsigned int, dim>> &facets,
    const std::vector<unsigned int> &own)
    : facets(facets), own(own), found(own.size())
  {
    for (const auto &facet : facets)
      nodes.insert(nodes.end(), facet.begin(), facet.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }



  template <int dim>
  void
  FacetSearch<dim>::find(const std::vector<Point<dim>> &points,
                         const double reach)
  {
    using Entry = std::pair<dealii::BoundingBox<dim>, unsigned int>;
    std::vector<Entry> boxes;
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        std::vector<Point<dim>> corners;
        for (const unsigned int node : facets[f])
          corners.push_back(points[node]);
        boxes.emplace_back(dealii::BoundingBox<dim>(corners), f);
      }
    const auto tree = dealii::pack_rtree(boxes);

    std::vector<Entry> near;
    for (unsigned int i = 0; i < own.size(); ++i)
      {
        dealii::BoundingBox<dim> box = boxes[own[i]].first;
        box.extend(reach);
        near.clear();
        tree.query(boost::geometry::index::intersects(box),
                   std::back_inserter(near));
        found[i].clear();
        const auto &facet = facets[own[i]];
        for (const auto &entry : near)
          {
            const auto &other = facets[entry.second];
            if (std::find_first_of(facet.begin(),
                                   facet.end(),
                                   other.begin(),
                                   other.end()) == facet.end())
              found[i].push_back(entry.second);
          }
        std::sort(found[i].begin(), found[i].end());
      }
    points_at_find = points;
  }



  template <int dim>
  double
  FacetSearch<dim>::displacement(const std::vector<Point<dim>> &points) const
  {
    if (points_at_find.empty())
      return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const unsigned int n : nodes)
      {
        const double square = points[n].distance_square(points_at_find[n]);
        if (!std::isfinite(square))
          throw NumericalError("Contact: a position is not finite");
        largest = std::max(largest, square);
      }
    return std::sqrt(largest);
  }



  template class FacetSearch<2>;
  template class FacetSearch<3>;
} // namespace coapt
