#include <coapt/base/exceptions.h>
#include <coapt/geometry/coupling_lattice.h>
#include <coapt/geometry/quad_strips.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace coapt
{
  using namespace dealii;

  void
  check_point_spacing(const double spacing)
  {
    if (!(spacing > 0))
      throw InputError("The spacing of coupling points is " +
                       std::to_string(spacing * 1e3) +
                       " mm, but must be positive.");
  }



  namespace
  {
    /** Signed volume of a tetrahedron. */
    double
    volume(const Point<3> &a,
           const Point<3> &b,
           const Point<3> &c,
           const Point<3> &d)
    {
      return cross_product_3d(b - a, c - a) * (d - a) / 6;
    }

    /** Maps the unit cube onto a leaflet between the columns of a quad:
     * bilinear in the surface, linear between the nodes of a column. */
    class ColumnMap
    {
    public:
      ColumnMap(const Leaflet &leaflet, const unsigned int quad)
        : points(leaflet.mesh.points)
        , n_layers(leaflet.columns[leaflet.quads[quad][0]].size() - 1)
      {
        for (unsigned int c = 0; c < 4; ++c)
          columns[c] = &leaflet.columns[leaflet.quads[quad][c]];
      }

      Point<3>
      operator()(const double u, const double v, const double depth) const
      {
        const double weights[4] = {(1 - u) * (1 - v),
                                   u * (1 - v),
                                   u * v,
                                   (1 - u) * v};
        const unsigned int layer =
          std::min<unsigned int>(depth * n_layers, n_layers - 1);
        const double fraction = depth * n_layers - layer;
        Point<3> p;
        for (unsigned int c = 0; c < 4; ++c)
          p += weights[c] *
            ((1 - fraction) * points[(*columns[c])[layer]] +
             fraction * points[(*columns[c])[layer + 1]]);
        return p;
      }

      /** Jacobian determinant, by differences within a layer. */
      double
      jacobian(const double u, const double v, const double depth) const
      {
        const double e = 1e-3 / n_layers;
        const Tensor<1, 3> du =
          (*this)(u + e, v, depth) - (*this)(u - e, v, depth);
        const Tensor<1, 3> dv =
          (*this)(u, v + e, depth) - (*this)(u, v - e, depth);
        const double inwards = depth < 0.5 ? e : -e;
        const Tensor<1, 3> dw =
          ((*this)(u, v, depth + inwards) - (*this)(u, v, depth)) / inwards;
        return std::abs(cross_product_3d(du, dv) * dw) / (4 * e * e);
      }

      /** Longest edge of the quad between columns @p a and @p b or the
       * opposite edge, on the atrial or the ventricular side. */
      double
      longest_edge(const unsigned int a, const unsigned int b) const
      {
        double longest = 0;
        for (const unsigned int node : {0u, n_layers})
          for (const unsigned int shift : {0u, 2u})
            longest =
              std::max(longest,
                       points[(*columns[(a + shift) % 4])[node]].distance(
                         points[(*columns[(b + shift) % 4])[node]]));
        return longest;
      }

    private:
      const std::vector<Point<3>> &points;
      const unsigned int n_layers;
      const std::vector<unsigned int> *columns[4];
    };

    /**
     * Puts a point into the one of @p cells that contains it. The cells fill
     * the region between bilinear surfaces up to their warp: where a point
     * falls outside of all by that, the cell that it misses by least takes it,
     * at its boundary.
     */
    void
    locate(const SimplexMesh<3> &mesh,
           const std::vector<unsigned int> &cells,
           const Point<3> &p,
           SamplePoint<3> &sample)
    {
      double best = -std::numeric_limits<double>::max();
      for (const unsigned int cell : cells)
        {
          const auto &v     = mesh.cells[cell];
          const Point<3> &a = mesh.points[v[0]], &b = mesh.points[v[1]],
                         &c = mesh.points[v[2]], &d = mesh.points[v[3]];
          const double whole                      = volume(a, b, c, d);
          const std::array<double, 4> barycentric = {
            {volume(p, b, c, d) / whole,
             volume(a, p, c, d) / whole,
             volume(a, b, p, d) / whole,
             volume(a, b, c, p) / whole}};
          const double least =
            *std::min_element(barycentric.begin(), barycentric.end());
          if (least > best)
            {
              best               = least;
              sample.cell        = cell;
              sample.barycentric = barycentric;
            }
        }
      double sum = 0;
      for (double &coordinate : sample.barycentric)
        sum += (coordinate = std::max(coordinate, 0.));
      for (double &coordinate : sample.barycentric)
        coordinate /= sum;
    }

    std::vector<std::vector<unsigned int>>
    cells_of_quads(const Leaflet &leaflet)
    {
      std::vector<std::vector<unsigned int>> cells(leaflet.quads.size());
      for (unsigned int cell = 0; cell < leaflet.cell_quad.size(); ++cell)
        cells[leaflet.cell_quad[cell]].push_back(cell);
      return cells;
    }

    double
    total_volume(const SimplexMesh<3> &mesh)
    {
      double sum = 0;
      for (const auto &v : mesh.cells)
        sum += volume(mesh.points[v[0]],
                      mesh.points[v[1]],
                      mesh.points[v[2]],
                      mesh.points[v[3]]);
      return sum;
    }

    /** Where lines of points cross a quad: their coordinates, 0 to 1, and the
     * part of its width that belongs to each. */
    struct Lines
    {
      std::vector<double> places;
      double width = 0;
    };

    /** Lines across a quad: those of constant u, and of constant v. */
    using QuadLines = std::array<Lines, 2>;

    /**
     * Lines at equal distances along the whole @p strip, at most @p in_plane
     * apart on both sides of the leaflet. Their number is even along a closed
     * strip, so that a leaflet with a plane of symmetry has symmetric points.
     */
    void
    add_lines(const QuadStrip &strip,
              const std::vector<ColumnMap> &maps,
              const double in_plane,
              std::vector<QuadLines> &lines)
    {
      std::vector<double> ends = {0.};
      for (const QuadStrip::Crossing &crossing : strip.crossings)
        ends.push_back(
          ends.back() +
          maps[crossing.quad].longest_edge(crossing.direction,
                                           crossing.direction + 1));
      unsigned int n = std::ceil(ends.back() / in_plane * (1 - 1e-12));
      if (strip.is_closed)
        n += n % 2;
      const double step = ends.back() / n;
      for (unsigned int i = 0, k = 0; i < strip.crossings.size(); ++i)
        {
          const QuadStrip::Crossing &crossing = strip.crossings[i];
          const double length                 = ends[i + 1] - ends[i];
          Lines &here = lines[crossing.quad][crossing.direction];
          here.width  = step / length;
          for (; k < n && (k + 0.5) * step < ends[i + 1]; ++k)
            {
              const double place = ((k + 0.5) * step - ends[i]) / length;
              here.places.push_back(crossing.is_reversed ? 1 - place : place);
            }
        }
    }

    /** Group of each of @p n layers: pairs in both halves of the thickness,
     * from outside; one in the middle, or without a partner, is alone. */
    std::vector<unsigned int>
    pairs_of_layers(const unsigned int n)
    {
      const unsigned int half = n / 2, groups_of_half = (half + 1) / 2,
                         last = 2 * groups_of_half + n % 2 - 1;
      std::vector<unsigned int> group(n, groups_of_half);
      for (unsigned int k = 0; k < half; ++k)
        {
          group[k]         = k / 2;
          group[n - 1 - k] = last - k / 2;
        }
      return group;
    }

    unsigned int
    largest_group(const std::vector<unsigned int> &group)
    {
      return *std::max_element(group.begin(), group.end());
    }

    /** The lines of points of a leaflet, and what is at their crossings. */
    class LeafletLines
    {
    public:
      LeafletLines(const Leaflet &leaflet,
                   const double spacing,
                   const double stretch,
                   const unsigned int min_layers)
        : leaflet(leaflet)
        , n_layers(std::max<unsigned int>(min_layers,
                                          std::ceil(leaflet.thickness /
                                                    spacing * (1 - 1e-12))))
        , cells(cells_of_quads(leaflet))
        , lines(leaflet.quads.size())
      {
        for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
          maps.emplace_back(leaflet, q);
        for (const QuadStrip &strip : quad_strips(leaflet.quads))
          add_lines(strip, maps, spacing / stretch, lines);
      }

      std::vector<SamplePoint<3>>
      points() const
      {
        std::vector<SamplePoint<3>> samples;
        for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
          for (const double u : lines[q][0].places)
            for (const double v : lines[q][1].places)
              for (unsigned int k = 0; k < n_layers; ++k)
                {
                  const double depth = (k + 0.5) / n_layers;
                  samples.push_back(sample(q, u, v, depth));
                  samples.back().volume = maps[q].jacobian(u, v, depth) *
                    lines[q][0].width * lines[q][1].width / n_layers;
                }
        rescale_volumes(samples);
        return samples;
      }

      /** Of points(), and what stands for groups of them. */
      NestedLattice<3>
      nested(const unsigned int min_layers) const
      {
        NestedLattice<3> result{points(), {}};
        std::vector<unsigned int> of_layer = pairs_of_layers(n_layers);
        if (largest_group(of_layer) + 1 < min_layers)
          std::iota(of_layer.begin(), of_layer.end(), 0);
        for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
          add_groups(q, of_layer, result);
        return result;
      }

    private:
      SamplePoint<3>
      sample(const unsigned int quad,
             const double u,
             const double v,
             const double depth) const
      {
        SamplePoint<3> result;
        result.quad  = quad;
        result.depth = depth;
        locate(leaflet.mesh, cells[quad], maps[quad](u, v, depth), result);
        return result;
      }

      /** Makes the volumes add up to that of the mesh. */
      void
      rescale_volumes(std::vector<SamplePoint<3>> &samples) const
      {
        double sum = 0;
        for (const SamplePoint<3> &sample : samples)
          sum += sample.volume;
        const double scale = total_volume(leaflet.mesh) / sum;
        for (SamplePoint<3> &sample : samples)
          sample.volume *= scale;
      }

      /** Appends the points that stand for the groups of the quad, whose dense
       * points are the next that have none. */
      void
      add_groups(const unsigned int quad,
                 const std::vector<unsigned int> &of_layer,
                 NestedLattice<3> &lattice) const
      {
        const auto &u               = lines[quad][0].places;
        const auto &v               = lines[quad][1].places;
        const unsigned int n_deep   = largest_group(of_layer) + 1,
                           n_across = (v.size() + 1) / 2,
                           n        = (u.size() + 1) / 2 * n_across * n_deep,
                           first    = lattice.points.size();
        std::vector<dealii::Tensor<1, 3>> places(n);
        std::vector<double> volumes(n, 0.);
        for (unsigned int i = 0; i < u.size(); ++i)
          for (unsigned int j = 0; j < v.size(); ++j)
            for (unsigned int k = 0; k < n_layers; ++k)
              {
                const unsigned int group =
                  (i / 2 * n_across + j / 2) * n_deep + of_layer[k];
                const SamplePoint<3> &dense =
                  lattice.points[lattice.stand_in.size()];
                places[group] +=
                  dense.volume * Point<3>(u[i], v[j], dense.depth);
                volumes[group] += dense.volume;
                lattice.stand_in.push_back(first + group);
              }
        for (unsigned int group = 0; group < n; ++group)
          {
            const dealii::Tensor<1, 3> x = places[group] / volumes[group];
            lattice.points.push_back(sample(quad, x[0], x[1], x[2]));
            lattice.points.back().volume = volumes[group];
          }
      }

      const Leaflet &leaflet;
      const unsigned int n_layers;
      const std::vector<std::vector<unsigned int>> cells;
      std::vector<ColumnMap> maps;
      std::vector<QuadLines> lines;
    };

    LeafletLines
    lines_of(const Leaflet &leaflet,
             const double spacing,
             const double stretch,
             const unsigned int min_layers)
    {
      check_point_spacing(spacing);
      check_point_spacing(spacing / stretch);
      return LeafletLines(leaflet, spacing, stretch, min_layers);
    }
  } // namespace



  std::vector<SamplePoint<3>>
  leaflet_lattice(const Leaflet &leaflet,
                  const double spacing,
                  const double stretch,
                  const unsigned int min_layers)
  {
    return lines_of(leaflet, spacing, stretch, min_layers).points();
  }



  NestedLattice<3>
  nested_leaflet_lattice(const Leaflet &leaflet,
                         const double spacing,
                         const double stretch,
                         const unsigned int min_layers)
  {
    return lines_of(leaflet, spacing, stretch, min_layers).nested(min_layers);
  }
} // namespace coapt
