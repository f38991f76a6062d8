#include <coapt/geometry/boundary_curves.h>
#include <coapt/geometry/boundary_faces.h>
#include <coapt/geometry/coupling_lattice.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    /**
     * Centroids, in barycentric coordinates, of the n^dim parts of a simplex.
     * In the coordinates 1 >= x_1 >= ... >= x_dim >= 0 the simplex is one of
     * the dim! parts of the unit cube; of each of the n^dim small cubes those
     * parts belong to it whose centroid does.
     */
    template <int dim>
    std::vector<std::array<double, dim + 1>>
    part_centroids(const unsigned int n)
    {
      std::vector<std::array<double, dim + 1>> centroids;
      const unsigned int n_cubes = std::lround(std::pow(n, dim));
      for (unsigned int cube = 0; cube < n_cubes; ++cube)
        {
          std::array<unsigned int, dim> order;
          std::iota(order.begin(), order.end(), 0);
          do
            {
              // from the cube's lowest corner one edge after the other, in
              // this order: the first is in dim of the dim + 1 corners, ...
              std::array<double, dim> x;
              unsigned int rest = cube;
              for (unsigned int d = 0; d < dim; ++d, rest /= n)
                x[d] = rest % n;
              for (unsigned int d = 0; d < dim; ++d)
                x[order[d]] += (dim - d) / (dim + 1.);

              std::array<double, dim + 1> barycentric;
              barycentric[0] = 1 - x[0] / n;
              for (unsigned int d = 1; d < dim; ++d)
                barycentric[d] = (x[d - 1] - x[d]) / n;
              barycentric[dim] = x[dim - 1] / n;
              if (*std::min_element(barycentric.begin(), barycentric.end()) > 0)
                centroids.push_back(barycentric);
          } while (std::next_permutation(order.begin(), order.end()));
        }
      return centroids;
    }

    template <int dim>
    double
    simplex_volume(const SimplexMesh<dim> &mesh,
                   const std::array<unsigned int, dim + 1> &cell)
    {
      Tensor<2, dim> edges;
      double factorial = 1;
      for (unsigned int d = 0; d < dim; ++d)
        {
          edges[d] = mesh.points[cell[d + 1]] - mesh.points[cell[0]];
          factorial *= d + 1;
        }
      return std::abs(determinant(edges)) / factorial;
    }

    template <int dim>
    double
    longest_edge(const SimplexMesh<dim> &mesh,
                 const std::array<unsigned int, dim + 1> &cell)
    {
      double longest = 0;
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = 0; b < a; ++b)
          longest =
            std::max(longest,
                     mesh.points[cell[a]].distance(mesh.points[cell[b]]));
      return longest;
    }

    /** Parts along the edges of a cell: none of a part's is longer than the
     * spacing. */
    template <int dim>
    unsigned int
    n_parts(const SimplexMesh<dim> &mesh,
            const std::array<unsigned int, dim + 1> &cell,
            const double spacing)
    {
      return std::ceil(longest_edge(mesh, cell) / spacing * (1 - 1e-12));
    }

    template <int dim>
    double
    area(const std::array<Point<dim>, dim> &corners)
    {
      const Tensor<1, dim> u = corners[1] - corners[0];
      if (dim == 2)
        return u.norm();
      const Tensor<1, dim> v = corners[dim - 1] - corners[0];
      return std::sqrt((u * u) * (v * v) - (u * v) * (u * v)) / 2;
    }

    /** Unit normal of a face towards the cell behind it. */
    template <int dim>
    Tensor<1, dim>
    inward_normal(const std::array<Point<dim>, dim> &corners,
                  const Point<dim> &behind)
    {
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(corners[1] - corners[0]);
      else
        normal =
          cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
      normal /= normal.norm();
      return normal * (behind - corners[0]) > 0 ? normal : -normal;
    }

    template <int dim>
    Point<dim>
    centroid(const SimplexMesh<dim> &mesh, const unsigned int cell)
    {
      Point<dim> result;
      for (const unsigned int node : mesh.cells[cell])
        result += mesh.points[node] / (dim + 1.);
      return result;
    }

    template <int dim>
    struct PlacedSample
    {
      SamplePoint<dim> sample;
      Point<dim> position;
      Tensor<1, dim> inwards; // unit normal of the surface
    };

    /** Points at most @p spacing apart all over the surface, each with the
     * volume of a layer of @p depth below its part. */
    template <int dim>
    std::vector<PlacedSample<dim>>
    dense_surface_points(const SimplexMesh<dim> &mesh,
                         const double spacing,
                         const double depth)
    {
      std::vector<PlacedSample<dim>> result;
      for (const BoundaryFace<dim> &face : boundary_faces<dim>(mesh.cells))
        {
          std::array<Point<dim>, dim> corners;
          double longest = 0;
          for (unsigned int i = 0; i < dim; ++i)
            {
              corners[i] = mesh.points[mesh.cells[face.cell][face.vertices[i]]];
              for (unsigned int j = 0; j < i; ++j)
                longest = std::max(longest, corners[i].distance(corners[j]));
            }
          const auto parts =
            part_centroids<dim - 1>(std::ceil(longest / spacing));
          const Tensor<1, dim> inwards =
            inward_normal<dim>(corners, centroid(mesh, face.cell));
          for (const auto &part : parts)
            {
              PlacedSample<dim> placed;
              placed.sample.cell = face.cell;
              for (unsigned int i = 0; i < dim; ++i)
                {
                  placed.sample.barycentric[face.vertices[i]] = part[i];
                  placed.position += part[i] * corners[i];
                }
              placed.inwards       = inwards;
              placed.sample.volume = area<dim>(corners) * depth / parts.size();
              result.push_back(placed);
            }
        }
      return result;
    }



    /** Of dense points those that are no nearer to others than @p spacing, each
     * with the volumes of the points around it. */
    std::vector<PlacedSample<3>>
    spaced_surface_points(const SimplexMesh<3> &mesh,
                          const double spacing,
                          const double depth)
    {
      std::vector<PlacedSample<3>> dense =
        dense_surface_points(mesh, spacing / 20, depth);
      // In the order of x, with some tolerance, so that points on both sides of
      // a body along x are chosen alike.
      std::stable_sort(dense.begin(),
                       dense.end(),
                       [&](const auto &p, const auto &q) {
                         return p.position[0] < q.position[0] - 1e-6 * spacing;
                       });
      std::vector<PlacedSample<3>> kept;
      for (const PlacedSample<3> &candidate : dense)
        if (std::none_of(kept.begin(), kept.end(), [&](const auto &other) {
              return other.position.distance(candidate.position) < spacing;
            }))
          {
            kept.push_back(candidate);
            kept.back().sample.volume = 0;
          }
      for (const PlacedSample<3> &part : dense)
        std::min_element(kept.begin(),
                         kept.end(),
                         [&](const auto &p, const auto &q) {
                           return p.position.distance_square(part.position) <
                             q.position.distance_square(part.position);
                         })
          ->sample.volume += part.sample.volume;
      return kept;
    }



    /** Point at the distance @p s (m) along a curve. */
    PlacedSample<2>
    point_on_curve(const SimplexMesh<2> &mesh,
                   const BoundaryCurve &curve,
                   double s)
    {
      auto edge = curve.edges.begin();
      for (; edge + 1 != curve.edges.end() && s > edge->length; ++edge)
        s -= edge->length;
      const double share = std::min(1., s / edge->length);
      const auto &cell   = mesh.cells[edge->cell];
      const std::array<Point<2>, 2> ends{
        {mesh.points[cell[edge->vertices[0]]],
         mesh.points[cell[edge->vertices[1]]]}};
      PlacedSample<2> placed;
      placed.sample.cell                           = edge->cell;
      placed.sample.barycentric[edge->vertices[0]] = 1 - share;
      placed.sample.barycentric[edge->vertices[1]] = share;
      placed.position = ends[0] + share * (ends[1] - ends[0]);
      placed.inwards  = inward_normal<2>(ends, centroid(mesh, edge->cell));
      return placed;
    }



    /** Equal steps along each smooth curve of the boundary: the same above and
     * below the axis of a body along x, or the flow around it would be bent.
     * From a right corner the first points on both sides are as far from each
     * other as neighbours on a side. */
    std::vector<PlacedSample<2>>
    spaced_surface_points(const SimplexMesh<2> &mesh,
                          const double spacing,
                          const double depth)
    {
      std::vector<PlacedSample<2>> result;
      for (const BoundaryCurve &curve : boundary_curves(mesh))
        {
          // in units of a step
          const double margins = curve.closed ? 1 : std::sqrt(2.);
          const double between = std::max(
            0., std::floor((curve.length / spacing - margins) * (1 + 1e-9)));
          const double step = curve.length / (between + margins);
          for (unsigned int i = 0; i <= between; ++i)
            {
              PlacedSample<2> placed =
                point_on_curve(mesh, curve, (0.5 * margins + i) * step);
              const unsigned int n_ends = (i == 0) + (i == between);
              placed.sample.volume =
                depth * step * (1 + n_ends * (margins - 1) / 2);
              result.push_back(placed);
            }
        }
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<SamplePoint<dim>>
  simplex_lattice(const SimplexMesh<dim> &mesh, const double spacing)
  {
    check_point_spacing(spacing);
    std::vector<SamplePoint<dim>> samples;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        const auto centroids =
          part_centroids<dim>(n_parts(mesh, mesh.cells[cell], spacing));
        const double part =
          simplex_volume(mesh, mesh.cells[cell]) / centroids.size();
        for (const auto &centroid : centroids)
          {
            SamplePoint<dim> sample;
            sample.cell        = cell;
            sample.barycentric = centroid;
            sample.volume      = part;
            samples.push_back(sample);
          }
      }
    return samples;
  }



  template <int dim>
  double
  deformed_spacing(const SimplexMesh<dim> &mesh,
                   const double spacing,
                   const std::vector<Point<dim>> &positions)
  {
    check_point_spacing(spacing);
    const SimplexMesh<dim> deformed{positions, mesh.cells, {}};
    double largest = 0;
    for (const auto &cell : mesh.cells)
      largest =
        std::max(largest,
                 longest_edge(deformed, cell) / n_parts(mesh, cell, spacing));
    // The centroids of two parts with a common face are as far apart as the
    // vertices opposite of it, which two edges join, over dim + 1.
    return 2. / (dim + 1) * largest;
  }



  template <int dim>
  std::vector<SamplePoint<dim>>
  surface_lattice(const SimplexMesh<dim> &mesh,
                  const double spacing,
                  const double depth)
  {
    check_point_spacing(spacing);
    std::vector<SamplePoint<dim>> samples;
    for (const PlacedSample<dim> &placed :
         spaced_surface_points(mesh, spacing, depth))
      {
        samples.push_back(placed.sample);
        samples.back().outwards = -1. * placed.inwards;
      }
    return samples;
  }



  template std::vector<SamplePoint<2>>
  simplex_lattice<2>(const SimplexMesh<2> &, const double);
  template std::vector<SamplePoint<3>>
  simplex_lattice<3>(const SimplexMesh<3> &, const double);
  template double
  deformed_spacing<2>(const SimplexMesh<2> &,
                      const double,
                      const std::vector<Point<2>> &);
  template double
  deformed_spacing<3>(const SimplexMesh<3> &,
                      const double,
                      const std::vector<Point<3>> &);
  template std::vector<SamplePoint<2>>
  surface_lattice<2>(const SimplexMesh<2> &, const double, const double);
  template std::vector<SamplePoint<3>>
  surface_lattice<3>(const SimplexMesh<3> &, const double, const double);
} // namespace coapt
