#ifndef coapt_tests_solid_bricks_h
#define coapt_tests_solid_bricks_h

#include <coapt/geometry/quadratic_mesh.h>
#include <coapt/solid/largest_frequency.h>
#include <coapt/solid/solid_operator.h>
#include <coapt/time/central_differences.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

/** Bricks cut into tetrahedra of four or ten nodes, as leaflets are, with loads
 * and supports, at rest or in motion. */
namespace bricks
{
  using namespace coapt;
  using dealii::Point;
  using dealii::Tensor;

  /** The unit box of n[0] x n[1] x n[2] bricks, each cut into five, moved by
   * @p map. */
  inline SimplexMesh<3>
  box(const std::array<unsigned int, 3> &n,
      const std::function<Point<3>(const Point<3> &)> &map)
  {
    constexpr unsigned int cuts[2][5][4] = {
      {{0, 1, 3, 4}, {1, 2, 3, 6}, {1, 4, 5, 6}, {3, 4, 6, 7}, {1, 3, 4, 6}},
      {{0, 1, 2, 5}, {0, 2, 3, 7}, {0, 4, 5, 7}, {2, 5, 6, 7}, {0, 5, 2, 7}}};
    constexpr unsigned int corners[8][3] = {{0, 0, 0},
                                            {1, 0, 0},
                                            {1, 1, 0},
                                            {0, 1, 0},
                                            {0, 0, 1},
                                            {1, 0, 1},
                                            {1, 1, 1},
                                            {0, 1, 1}};
    SimplexMesh<3> mesh;
    for (unsigned int k = 0; k <= n[2]; ++k)
      for (unsigned int j = 0; j <= n[1]; ++j)
        for (unsigned int i = 0; i <= n[0]; ++i)
          mesh.points.push_back(map(
            Point<3>(double(i) / n[0], double(j) / n[1], double(k) / n[2])));
    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
          for (const auto &cut : cuts[(i + j + k) % 2])
            {
              std::array<unsigned int, 4> cell;
              for (unsigned int a = 0; a < 4; ++a)
                {
                  const auto &c = corners[cut[a]];
                  cell[a] = ((k + c[2]) * (n[1] + 1) + j + c[1]) * (n[0] + 1) +
                    i + c[0];
                }
              mesh.cells.push_back(cell);
            }
    return mesh;
  }

  /** Elements of four nodes, the same with averaged volumes, and elements of
   * ten nodes, on the vertices of a linear mesh. @{ */
  struct Linear
  {
    static constexpr bool averages_volume = false;

    static SimplexMesh<3>
    mesh(const SimplexMesh<3> &linear)
    {
      return linear;
    }
  };

  struct Averaged : Linear
  {
    static constexpr bool averages_volume = true;
  };

  struct Quadratic
  {
    static constexpr bool averages_volume = false;

    static SimplexMesh<3>
    mesh(const SimplexMesh<3> &linear)
    {
      return quadratic_mesh(linear);
    }
  };
  /** @} */

  /** Nodes of each face of all elements that carry its load if it is uniform,
   * a third each: the vertices of a triangle of three nodes, and the middles of
   * the edges of one of six. */
  inline std::vector<std::array<unsigned int, 3>>
  loaded_nodes_of_faces(const SimplexMesh<3> &mesh)
  {
    constexpr unsigned int vertices[4][3] = {{0, 1, 2},
                                             {0, 1, 3},
                                             {0, 2, 3},
                                             {1, 2, 3}};
    constexpr unsigned int middles[4][3]  = {{4, 5, 7},
                                             {4, 6, 8},
                                             {5, 6, 9},
                                             {7, 8, 9}};
    std::vector<std::array<unsigned int, 3>> result;
    for (const auto &cell : mesh.quadratic_cells)
      for (const auto &f : middles)
        result.push_back({{cell[f[0]], cell[f[1]], cell[f[2]]}});
    if (result.empty())
      for (const auto &cell : mesh.cells)
        for (const auto &f : vertices)
          result.push_back({{cell[f[0]], cell[f[1]], cell[f[2]]}});
    return result;
  }

  /** A body with supports and constant forces. */
  template <typename Element>
  struct Body
  {
    SimplexMesh<3> mesh;
    SolidOperator<3> solid;
    std::vector<Point<3>> points;
    std::vector<bool> held;   // by component
    std::vector<double> load; // by component, N

    /** With one @p fibre everywhere, which may be zero for a material without.
     */
    Body(const SimplexMesh<3> &linear,
         const Material &material,
         const double density,
         const Tensor<1, 3> &fibre = {})
      : Body(Element::mesh(linear), parameters(material, density), fibre)
    {
    }

    /** Positions at rest. */
    std::vector<double>
    positions() const
    {
      std::vector<double> X;
      for (const Point<3> &x : points)
        X.insert(X.end(), {x[0], x[1], x[2]});
      return X;
    }

    /** Accelerations under the load. */
    void
    acceleration(const double *X, const double *V, double *A) const
    {
      std::copy(load.begin(), load.end(), A);
      solid.add_forces(X, V, A);
      for (unsigned int i = 0; i < load.size(); ++i)
        A[i] = held[i] ? 0. : A[i] / solid.mass()[i / 3];
    }

    /** Longest stable step at the positions @p X as runs estimate it, in which
     * the estimate is renewed over and over, too. */
    double
    estimated_step(const std::vector<double> &X) const
    {
      std::vector<bool> pinned;
      for (unsigned int node = 0; node < points.size(); ++node)
        pinned.push_back(held[3 * node] && held[3 * node + 1] &&
                         held[3 * node + 2]);
      LargestFrequency<3> frequency(solid, mesh, pinned, MPI_COMM_SELF);
      double omega = 0;
      for (unsigned int i = 0; i < 5; ++i)
        omega = frequency.update(X.data()).omega;
      return 2 / omega;
    }

    /** Adds the @p force (N) evenly to the faces all of whose nodes are
     * @p inside. */
    void
    add_uniform_load(const Tensor<1, 3> &force,
                     const std::function<bool(const Point<3> &)> &inside)
    {
      double area = 0;
      std::vector<Tensor<1, 3>> parts(points.size());
      for (const auto &nodes : loaded_nodes_of_faces(mesh))
        {
          const Point<3> &a = points[nodes[0]], &b = points[nodes[1]],
                         &c = points[nodes[2]];
          if (!inside(a) || !inside(b) || !inside(c))
            continue;
          // The triangle between the middles of edges is a quarter of theirs,
          // on all faces alike.
          const double part = dealii::cross_product_3d(b - a, c - a).norm() / 2;
          area += part;
          for (const unsigned int node : nodes)
            parts[node] += part / 3 * force;
        }
      for (unsigned int i = 0; i < load.size(); ++i)
        load[i] += parts[i / 3][i % 3] / area;
    }

    /** Moves the positions @p X to where forces balance: undamped motion that
     * is stopped whenever the kinetic energy has passed a maximum. The work of
     * the forces left over is @p tolerance of that of the load. */
    void
    find_rest(std::vector<double> &X, const double step) const;

  private:
    Body(const SimplexMesh<3> &mesh,
         const SolidParameters &parameters,
         const Tensor<1, 3> &fibre)
      : mesh(mesh)
      , solid(mesh,
              parameters,
              std::vector<Tensor<1, 3>>(mesh.cells.size(), fibre),
              {},
              MPI_COMM_SELF)
      , points(mesh.points)
      , held(3 * points.size(), false)
      , load(3 * points.size(), 0.)
    {
    }

    static SolidParameters
    parameters(const Material &material, const double density)
    {
      SolidParameters parameters;
      parameters.density         = density;
      parameters.viscosity       = 0;
      parameters.averages_volume = Element::averages_volume;
      if (const auto *hgo = std::get_if<HolzapfelGasserOgden>(&material))
        parameters.holzapfel_gasser_ogden = *hgo;
      else
        {
          parameters.material    = "neo-Hookean";
          parameters.neo_hookean = std::get<NeoHookean>(material);
        }
      return parameters;
    }
  };

  template <typename Element>
  void
  Body<Element>::find_rest(std::vector<double> &X, const double step) const
  {
    std::vector<double> V(X.size(), 0.), A(X.size());
    double before = 0, highest = 0;
    for (unsigned int n = 0, stops = 0; n < 400000 && stops < 400; ++n)
      {
        acceleration(X.data(), V.data(), A.data());
        double energy = 0;
        for (unsigned int i = 0; i < X.size(); ++i)
          {
            V[i] += step * A[i];
            energy += solid.mass()[i / 3] * V[i] * V[i];
          }
        if (energy < before)
          {
            highest = std::max(highest, before);
            if (before < 1e-11 * highest)
              return;
            // Back to where it was largest, about half a step ago.
            for (unsigned int i = 0; i < X.size(); ++i)
              {
                X[i] -= 0.5 * step * (V[i] - step * A[i]);
                V[i] = 0;
              }
            before = 0;
            ++stops;
            continue;
          }
        before = energy;
        for (unsigned int i = 0; i < X.size(); ++i)
          X[i] += step * V[i];
      }
  }

  /** Neo-Hookean with shear modulus (Pa) and Poisson's ratio. */
  inline NeoHookean
  neo_hookean(const double mu, const double nu)
  {
    NeoHookean law;
    law.mu     = mu;
    law.lambda = 2 * mu * nu / (1 - 2 * nu);
    return law;
  }
} // namespace bricks

#endif
