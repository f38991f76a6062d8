#ifndef coapt_tests_contact_sheets_h
#define coapt_tests_contact_sheets_h

#include <coapt/geometry/leaflet.h>

#include <functional>

/**
 * Leaflets for tests: flat sheets of columns, without tetrahedra, and the
 * state of motion of their nodes.
 */
struct Sheets
{
  static constexpr double density   = 1000;
  static constexpr double thickness = 1e-3;

  coapt::Leaflet leaflet;
  std::vector<double> mass, X, V;

  Sheets()
  {
    leaflet.thickness = thickness;
  }

  /**
   * Adds n[0] x n[1] quadrilaterals with three nodes through the thickness.
   * @p shape maps (a, b) in [0,1]^2 and the coordinate through the thickness
   * (m, zero at the mid-surface) to a point. The mass of a node is what its
   * share of the given @p area weighs.
   */
  void
  add(const std::array<unsigned int, 2> &n,
      const std::function<dealii::Point<3>(double, double, double)> &shape,
      const double area,
      const bool pinned)
  {
    const unsigned int first = leaflet.columns.size();
    for (unsigned int i = 0; i <= n[0]; ++i)
      for (unsigned int j = 0; j <= n[1]; ++j)
        {
          const double share = (i % n[0] == 0 ? 0.5 : 1.) / n[0] *
            (j % n[1] == 0 ? 0.5 : 1.) / n[1];
          std::vector<unsigned int> column;
          for (unsigned int l = 0; l < 3; ++l)
            {
              column.push_back(leaflet.mesh.points.size());
              leaflet.mesh.points.push_back(
                shape(i * 1. / n[0], j * 1. / n[1], (1. - l) * thickness / 2));
              leaflet.pinned.push_back(pinned);
              mass.push_back(density * thickness * area * share *
                             (l == 1 ? 0.4 : 0.3));
            }
          leaflet.columns.push_back(column);
        }
    const unsigned int row = n[1] + 1;
    for (unsigned int i = 0; i < n[0]; ++i)
      for (unsigned int j = 0; j < n[1]; ++j)
        {
          const unsigned int c = first + row * i + j;
          leaflet.quads.push_back({{c, c + 1, c + row + 1, c + row}});
        }
    X.clear();
    for (const auto &p : leaflet.mesh.points)
      X.insert(X.end(), {p[0], p[1], p[2]});
    V.assign(X.size(), 0.);
  }

  /** Adds a horizontal rectangle with a corner at @p corner. */
  void
  add_rectangle(const std::array<unsigned int, 2> &n,
                const dealii::Point<3> &corner,
                const std::array<double, 2> &sides,
                const bool pinned)
  {
    add(
      n,
      [=](const double a, const double b, const double t) {
        return dealii::Point<3>(corner[0] + a * sides[0],
                                corner[1] + b * sides[1],
                                corner[2] + t);
      },
      sides[0] * sides[1],
      pinned);
  }

  double
  kinetic_energy() const
  {
    double energy = 0;
    for (unsigned int i = 0; i < V.size(); ++i)
      energy += 0.5 * mass[i / 3] * V[i] * V[i];
    return energy;
  }

  void
  drift(const double dt)
  {
    for (unsigned int i = 0; i < X.size(); ++i)
      X[i] += dt * V[i];
  }

  /** Mean of the velocities of nodes that are not pinned, by mass; imposed on
   * all of them if @p rigid, so that they move as one rigid body without
   * rotation. */
  dealii::Tensor<1, 3>
  mean_velocity(const bool rigid)
  {
    dealii::Tensor<1, 3> momentum;
    double total = 0;
    for (unsigned int node = 0; node < mass.size(); ++node)
      if (!leaflet.pinned[node])
        {
          total += mass[node];
          for (unsigned int d = 0; d < 3; ++d)
            momentum[d] += mass[node] * V[3 * node + d];
        }
    momentum /= total;
    for (unsigned int node = 0; rigid && node < mass.size(); ++node)
      if (!leaflet.pinned[node])
        for (unsigned int d = 0; d < 3; ++d)
          V[3 * node + d] = momentum[d];
    return momentum;
  }
};

#endif
