// The search for facets, against brute force.

#include <coapt/contact/facet_search.h>

#include "tests.h"

#include <algorithm>
#include <numeric>

using dealii::Point;

namespace
{
  template <int dim>
  using Facets = std::vector<std::array<unsigned int, dim>>;

  template <int dim>
  std::vector<Point<dim>>
  random_points(const unsigned int n)
  {
    std::vector<Point<dim>> points(n);
    for (Point<dim> &p : points)
      for (unsigned int d = 0; d < dim; ++d)
        p[d] = std::rand() / (1. * RAND_MAX);
    return points;
  }

  /** Distance of two boxes around facets along the axis in which it is largest,
   * negative if they overlap. */
  template <int dim>
  double
  distance(const std::vector<Point<dim>> &points,
           const std::array<unsigned int, dim> &a,
           const std::array<unsigned int, dim> &b)
  {
    double largest = -1e300;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const auto less = [&](const unsigned int i, const unsigned int j) {
          return points[i][d] < points[j][d];
        };
        const auto range = [&](const std::array<unsigned int, dim> &facet) {
          const auto ends =
            std::minmax_element(facet.begin(), facet.end(), less);
          return std::array<double, 2>{
            {points[*ends.first][d], points[*ends.second][d]}};
        };
        largest = std::max(
          {largest, range(a)[0] - range(b)[1], range(b)[0] - range(a)[1]});
      }
    return largest;
  }

  /** Random facets of random points, among which many share a node. */
  template <int dim>
  void
  compare()
  {
    const unsigned int n_nodes = 250;
    Facets<dim> facets(300);
    for (auto &facet : facets)
      for (unsigned int i = 0; i < dim; ++i)
        do
          facet[i] = std::rand() % n_nodes;
        while (std::find(facet.begin(), facet.begin() + i, facet[i]) !=
               facet.begin() + i);
    std::vector<unsigned int> own;
    for (unsigned int f = 0; f < facets.size(); f += 2)
      own.push_back(f);
    coapt::FacetSearch<dim> search(facets, own);

    unsigned int different = 0, found = 0, left_out = 0;
    for (const double reach : {0., 0.02, 0.3})
      {
        // Facets of the size of a fifth of the box.
        auto points = random_points<dim>(n_nodes);
        for (const auto &facet : facets)
          for (unsigned int i = 1; i < dim; ++i)
            points[facet[i]] =
              points[facet[0]] + 0.2 * (points[facet[i]] - points[facet[0]]);
        search.find(points, reach);
        for (unsigned int i = 0; i < own.size(); ++i)
          {
            std::vector<unsigned int> expected;
            const auto &facet = facets[own[i]];
            for (unsigned int f = 0; f < facets.size(); ++f)
              {
                const bool shares =
                  std::find_first_of(facet.begin(),
                                     facet.end(),
                                     facets[f].begin(),
                                     facets[f].end()) != facet.end();
                if (distance<dim>(points, facet, facets[f]) > reach)
                  continue;
                if (shares)
                  ++left_out;
                else
                  expected.push_back(f);
              }
            different += expected != search.candidates(i);
            found += expected.size();
          }
      }
    check("facets near each other, " + std::to_string(dim) + "D",
          different == 0 && found > 1000 && left_out > 100,
          different);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  compare<2>();
  compare<3>();
}
