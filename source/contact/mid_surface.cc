#include <coapt/base/exceptions.h>
#include <coapt/contact/mid_surface.h>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    void
    check_columns(const Leaflet &leaflet, const std::vector<double> &mass)
    {
      if (mass.size() != leaflet.mesh.points.size() ||
          leaflet.pinned.size() != leaflet.mesh.points.size())
        throw InputError("Contact: " + std::to_string(mass.size()) +
                         " nodal masses and " +
                         std::to_string(leaflet.pinned.size()) +
                         " marks of pinned nodes were given for " +
                         std::to_string(leaflet.mesh.points.size()) +
                         " nodes; there must be one of each a node.");
      for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
        {
          const auto &column = leaflet.columns[c];
          if (column.size() < 2 || column.size() != leaflet.columns[0].size())
            throw InputError("Contact: column " + std::to_string(c) + " has " +
                             std::to_string(column.size()) +
                             " nodes through the thickness; all columns need "
                             "the same number, at least 2.");
          for (const unsigned int node : column)
            if (!(mass[node] > 0))
              throw InputError("Contact: node " + std::to_string(node) +
                               " has mass " + std::to_string(mass[node]) +
                               " kg; it must be positive.");
        }
    }

    // Nodes are evenly spaced at z = 1 ... -1. The weights are the masses times
    // a linear function of z, with the sum 1 and the mean z = 0.
    std::vector<double>
    weights_of_nodes(const std::vector<unsigned int> &column,
                     const std::vector<double> &nodal_mass)
    {
      const auto z = [&](const unsigned int l) {
        return 1 - 2. * l / (column.size() - 1);
      };
      double mass = 0, first = 0, second = 0;
      for (unsigned int l = 0; l < column.size(); ++l)
        {
          const double m = nodal_mass[column[l]];
          mass += m;
          first += m * z(l);
          second += m * z(l) * z(l);
        }
      std::vector<double> weights;
      for (unsigned int l = 0; l < column.size(); ++l)
        weights.push_back(nodal_mass[column[l]] * (second - first * z(l)) /
                          (mass * second - first * first));
      return weights;
    }
  } // namespace



  MidSurface::MidSurface(const Leaflet &leaflet,
                         const std::vector<double> &nodal_mass)
    : nodes_per_column(leaflet.columns.empty() ? 0 : leaflet.columns[0].size())
    , quads(leaflet.quads)
    , around(leaflet.columns.size())
    , corners(triangulate(leaflet.quads))
  {
    check_columns(leaflet, nodal_mass);
    for (unsigned int q = 0; q < quads.size(); ++q)
      for (const unsigned int column : quads[q])
        around[column].push_back(q);
    for (const auto &column : leaflet.columns)
      {
        const std::vector<double> weights =
          weights_of_nodes(column, nodal_mass);
        double inverse = 0;
        for (unsigned int l = 0; l < nodes_per_column; ++l)
          {
            const double velocity = leaflet.pinned[column[l]]
              ? 0.
              : weights[l] / nodal_mass[column[l]];
            nodes.push_back({column[l], weights[l], velocity});
            inverse += weights[l] * velocity;
          }
        inverse_masses.push_back(inverse);
      }
  }



  unsigned int
  MidSurface::n_columns() const
  {
    return inverse_masses.size();
  }



  const std::vector<std::array<unsigned int, 3>> &
  MidSurface::triangles() const
  {
    return corners;
  }



  const std::vector<std::array<unsigned int, 4>> &
  MidSurface::quadrilaterals() const
  {
    return quads;
  }



  Tensor<1, 3>
  MidSurface::average(const unsigned int column, const double *V) const
  {
    Tensor<1, 3> mean;
    const Node *node = &nodes[nodes_per_column * column];
    for (unsigned int l = 0; l < nodes_per_column; ++l, ++node)
      for (unsigned int d = 0; d < 3; ++d)
        mean[d] += node->weight * V[3 * node->number + d];
    return mean;
  }



  void
  MidSurface::positions(const double *X, std::vector<Point<3>> &points) const
  {
    for (unsigned int c = 0; c < n_columns(); ++c)
      points[c] = Point<3>(average(c, X));
  }



  void
  MidSurface::areas(const std::vector<Point<3>> &points,
                    std::vector<double> &areas) const
  {
    areas.assign(n_columns(), 0.);
    for (const auto &quad : quads)
      {
        const double area = 0.5 *
          cross_product_3d(points[quad[2]] - points[quad[0]],
                           points[quad[3]] - points[quad[1]])
            .norm();
        for (const unsigned int column : quad)
          areas[column] += 0.25 * area;
      }
  }



  double
  MidSurface::inverse_mass(const unsigned int column) const
  {
    return inverse_masses[column];
  }



  std::array<double, 2>
  MidSurface::apply_impulse(const unsigned int column,
                            const Tensor<1, 3> &first,
                            const Tensor<1, 3> &second,
                            double *V) const
  {
    const Tensor<1, 3> sum = first + second;
    std::array<double, 2> work{{0., 0.}};
    const Node *node = &nodes[nodes_per_column * column];
    for (unsigned int l = 0; l < nodes_per_column; ++l, ++node)
      if (node->velocity != 0) // not pinned
        for (unsigned int d = 0; d < 3; ++d)
          {
            double &v              = V[3 * node->number + d];
            const double increment = node->velocity * sum[d];
            const double mean      = node->weight * (v + 0.5 * increment);
            work[0] += first[d] * mean;
            work[1] += second[d] * mean;
            v += increment;
          }
    return work;
  }
} // namespace coapt
