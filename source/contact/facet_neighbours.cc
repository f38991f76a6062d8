#include <coapt/base/exceptions.h>
#include <coapt/contact/facet_neighbours.h>
#include <coapt/contact/facet_overlap.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    template <std::size_t n, std::size_t m>
    bool
    share_a_node(const std::array<unsigned int, n> &a,
                 const std::array<unsigned int, m> &b)
    {
      return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) !=
        a.end();
    }

    /** Barycentric coordinates of a point in a cell, and their change along a
     * way. */
    template <int dim>
    struct Coordinates
    {
      Coordinates(const std::array<Point<dim>, dim + 1> &corners,
                  const Point<dim> &x,
                  const Tensor<1, dim> &way)
      {
        Tensor<2, dim> edges; // by columns
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            edges[d][i] = corners[i + 1][d] - corners[0][d];
        const Tensor<2, dim> inverse = invert(edges);
        const Tensor<1, dim> at      = inverse * (x - corners[0]),
                             by      = inverse * way;
        value[0]                     = 1;
        for (unsigned int i = 0; i < dim; ++i)
          {
            value[i + 1]  = at[i];
            change[i + 1] = by[i];
            value[0] -= at[i];
            change[0] -= by[i];
          }
      }

      std::array<double, dim + 1> value{}, change{};
    };
  } // namespace



  template <int dim>
  FacetNeighbours<dim>::FacetNeighbours(const SimplexMesh<dim> &mesh,
                                        const std::vector<Facet> &facets,
                                        const double across,
                                        const double along)
    : mesh(mesh)
    , facets(facets)
    , across(across)
    , along(along)
    , beyond(mesh.cells.size())
    , facets_of_node(mesh.points.size())
  {
    // Faces wait here for their second cell; outer ones remain.
    std::map<Facet, CellAndOpposite> faces;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int opposite = 0; opposite <= dim; ++opposite)
        {
          Facet face;
          for (unsigned int i = 0; i < dim; ++i)
            face[i] = mesh.cells[cell][i < opposite ? i : i + 1];
          std::sort(face.begin(), face.end());
          beyond[cell][opposite]     = {none, none};
          const auto [first, is_new] = faces.insert({face, {cell, opposite}});
          if (is_new)
            continue;
          beyond[cell][opposite]                            = first->second;
          beyond[first->second.first][first->second.second] = {cell, opposite};
          faces.erase(first);
        }
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        std::array<Point<dim>, dim> corners;
        Point<dim> centre;
        for (unsigned int i = 0; i < dim; ++i)
          {
            corners[i] = mesh.points[facets[f][i]];
            centre += corners[i] / double(dim);
            facets_of_node[facets[f][i]].push_back(f);
          }
        double radius = 0;
        for (const Point<dim> &corner : corners)
          radius = std::max(radius, centre.distance(corner));
        radii.push_back(radius);
        const Tensor<1, dim> normal = area_normal<dim>(corners);
        centres.push_back(centre);
        normals.push_back(normal / normal.norm());
        Facet face = facets[f];
        std::sort(face.begin(), face.end());
        const auto behind = faces.find(face);
        if (behind == faces.end())
          throw InputError("Contact: a facet is none of the surface");
        cell_behind.push_back(behind->second);
      }
  }



  template <int dim>
  bool
  FacetNeighbours<dim>::operator()(const unsigned int a, const unsigned int b)
  {
    const std::pair<unsigned int, unsigned int> pair = std::minmax(a, b);
    const auto [entry, is_new] = known.insert({pair, true});
    if (is_new)
      entry->second = share_a_node(facets[a], facets[b]) ||
        across_the_solid(pair.first, pair.second) ||
        along_the_surface(pair.first, pair.second);
    return entry->second;
  }



  template <int dim>
  bool
  FacetNeighbours<dim>::across_the_solid(const unsigned int a,
                                         const unsigned int b) const
  {
    const Tensor<1, dim> way = centres[b] - centres[a];
    const double distance    = way.norm();
    // Not the neighbours in a plane
    const double behind = 1e-6 * distance;
    return distance - radii[a] - radii[b] < across &&
      way * normals[a] < -behind && way * normals[b] > behind &&
      share_a_node(mesh.cells[end_of_way(a, way)], facets[b]);
  }



  template <int dim>
  unsigned int
  FacetNeighbours<dim>::end_of_way(const unsigned int facet,
                                   const Tensor<1, dim> &way) const
  {
    auto [cell, entered] = cell_behind[facet];
    // The number of steps is bounded, should round-off lead round an edge.
    for (unsigned int step = 0; step < mesh.cells.size(); ++step)
      {
        std::array<Point<dim>, dim + 1> corners;
        for (unsigned int i = 0; i <= dim; ++i)
          corners[i] = mesh.points[mesh.cells[cell][i]];
        const Coordinates<dim> at(corners, centres[facet], way);
        // The face that is reached first; never back through the last one.
        unsigned int left = none;
        double share      = 1;
        for (unsigned int i = 0; i <= dim; ++i)
          if (i != entered && at.change[i] < 0 &&
              at.value[i] + share * at.change[i] < 0)
            {
              share = -at.value[i] / at.change[i];
              left  = i;
            }
        if (left == none || beyond[cell][left].first == none)
          break;
        std::tie(cell, entered) = beyond[cell][left];
      }
    return cell;
  }



  template <int dim>
  bool
  FacetNeighbours<dim>::along_the_surface(const unsigned int a,
                                          const unsigned int b) const
  {
    const auto is_close = [&](const unsigned int other) {
      for (const unsigned int i : facets[a])
        for (const unsigned int j : facets[other])
          if (mesh.points[i].distance(mesh.points[j]) < along)
            return true;
      return false;
    };
    if (!is_close(b))
      return false;
    std::vector<unsigned int> chain{a};
    for (unsigned int c = 0; c < chain.size(); ++c)
      for (const unsigned int node : facets[chain[c]])
        for (const unsigned int other : facets_of_node[node])
          if (std::find(chain.begin(), chain.end(), other) == chain.end() &&
              is_close(other))
            {
              if (other == b)
                return true;
              chain.push_back(other);
            }
    return false;
  }



  template class FacetNeighbours<2>;
  template class FacetNeighbours<3>;
} // namespace coapt
