#include <coapt/contact/tributary_patch.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    struct Sample
    {
      double x, y;
    };

    /**
     * Samples of the unit square: a Fibonacci lattice (Zaremba 1966), all of
     * whose points differ in x and in y. Rows of a square lattice, parallel to
     * the sides of elements, would cross those of the partner all at once, and
     * would need five times as many points for the same accuracy. In an order
     * in which each is near the last one.
     */
    std::vector<Sample>
    fibonacci_lattice()
    {
      constexpr unsigned int n = 34, step = 21, n_bands = 6;
      std::vector<Sample> samples;
      for (unsigned int i = 0; i < n; ++i)
        samples.push_back({(i + 0.5) / n, (i * step % n + 0.5) / n});
      const auto key = [](const Sample &s) {
        const double band = std::floor(n_bands * s.y);
        return std::make_pair(band, std::fmod(band, 2) == 0 ? s.x : -s.x);
      };
      std::sort(samples.begin(),
                samples.end(),
                [&](const Sample &a, const Sample &b) {
                  return key(a) < key(b);
                });
      return samples;
    }
  } // namespace



  TributaryPatches::TributaryPatches(const MidSurface &surface,
                                     const FacingRule &rule)
    : surface(surface), rule(rule), is_neighbour(surface.triangles().size())
  {
    own.weights.assign(surface.n_columns(), 0.);
    partner.weights.assign(surface.n_columns(), 0.);
  }



  TributaryPatches::Offset
  TributaryPatches::offset(const TributaryPatch &patch,
                           const std::vector<Point<3>> &points,
                           const unsigned int column) const
  {
    const Frame frame = frame_of(points, patch.triangle);
    Offset result;
    result.slid = points[column] - frame.origin - patch.foot[0] * frame.u -
      patch.foot[1] * frame.v;
    const double along_normal = result.slid * frame.normal;
    result.slid -= along_normal * frame.normal;
    result.distance = std::abs(along_normal);
    return result;
  }



  TributaryPatches::Frame
  TributaryPatches::frame_of(const std::vector<Point<3>> &points,
                             const unsigned int triangle) const
  {
    const auto &corner = rule.corners(triangle);
    Frame frame;
    frame.origin        = points[corner[0]];
    frame.u             = points[corner[1]] - frame.origin;
    frame.v             = points[corner[2]] - frame.origin;
    frame.normal        = cross_product_3d(frame.u, frame.v);
    const double length = frame.normal.norm();
    if (length > 0)
      frame.normal /= length;
    return frame;
  }



  void
  TributaryPatches::Sum::add(const unsigned int column, const double weight)
  {
    if (weight == 0)
      return;
    if (weights[column] == 0)
      columns.push_back(column);
    weights[column] += weight;
  }



  void
  TributaryPatches::Sum::fetch(const double total,
                               std::vector<TributaryPatch::Part> &parts)
  {
    parts.clear();
    for (const unsigned int column : columns)
      {
        parts.push_back({column, weights[column] / total});
        weights[column] = 0;
      }
    columns.clear();
  }



  void
  TributaryPatches::update(TributaryPatch &patch,
                           const std::vector<Point<3>> &points,
                           const unsigned int column,
                           const Encounter &encounter,
                           const std::vector<unsigned int> &neighbours)
  {
    for (const unsigned int triangle : neighbours)
      is_neighbour[triangle] = true;
    area            = 0;
    area_that_faces = 0;
    Encounter start = encounter;
    start.triangle  = rule.first_sharing(encounter);
    for (const unsigned int q : surface.quadrilaterals_around(column))
      for (unsigned int corner = 0; corner < 4; ++corner)
        if (surface.quadrilaterals()[q][corner] == column)
          sample(points, q, corner, start);

    const Frame frame         = frame_of(points, start.triangle);
    const Tensor<1, 3> offset = points[column] - frame.origin;
    const Tensor<1, 3> across = cross_product_3d(frame.u, frame.v);
    const double square       = across.norm_square();
    patch.triangle            = start.triangle;
    patch.foot                = {{0., 0.}};
    if (square > 0)
      patch.foot = {{cross_product_3d(offset, frame.v) * across / square,
                     cross_product_3d(frame.u, offset) * across / square}};
    for (const unsigned int triangle : neighbours)
      is_neighbour[triangle] = false;
    patch.fraction = area_that_faces > 0 ? area_that_faces / area : 0.;
    own.fetch(area_that_faces, patch.own);
    partner.fetch(area_that_faces, patch.partner);
  }



  // The samples have the weights of the bilinear function that is one in the
  // column. Each begins its search where the last one has found what faces it.
  void
  TributaryPatches::sample(const std::vector<Point<3>> &points,
                           const unsigned int q,
                           const unsigned int corner,
                           const Encounter &start)
  {
    static const std::vector<Sample> samples = fibonacci_lattice();
    const auto &c                            = surface.quadrilaterals()[q];
    const double quad_area                   = 0.5 *
      cross_product_3d(points[c[2]] - points[c[0]], points[c[3]] - points[c[1]])
        .norm();
    Encounter last = start;
    for (const Sample &s : samples)
      {
        const double N[] = {(1 - s.x) * (1 - s.y),
                            s.x * (1 - s.y),
                            s.x * s.y,
                            (1 - s.x) * s.y};
        Point<3> p;
        for (unsigned int v = 0; v < 4; ++v)
          p += N[v] * points[c[v]];
        const double weight = quad_area * N[corner];
        area += weight;
        Encounter found = last;
        const double facing =
          weight * rule.descend(points, p, is_neighbour, found);
        if (facing == 0)
          continue;
        last = found;
        area_that_faces += facing;
        for (unsigned int v = 0; v < 4; ++v)
          own.add(c[v], facing * N[v]);
        for (unsigned int v = 0; v < 3; ++v)
          partner.add(rule.corners(found.triangle)[v],
                      facing * found.weights[v]);
      }
  }
} // namespace coapt
