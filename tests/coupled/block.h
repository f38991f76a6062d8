#ifndef coapt_tests_coupled_block_h
#define coapt_tests_coupled_block_h

#include <coapt/geometry/simplex_mesh.h>
#include <coapt/solid/solid_operator.h>
#include <coapt/time/explicit_integrator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

/** A block of simplices, the image of the unit square or cube. */
template <int dim>
struct Block
{
  coapt::SimplexMesh<dim> mesh;

  /** Coordinates in the unit square or cube of each node. */
  std::vector<dealii::Point<dim>> unit;

  /** Whether each node fulfils @p condition on its unit coordinates. */
  std::vector<bool>
  nodes_where(
    const std::function<bool(const dealii::Point<dim> &)> &condition) const
  {
    std::vector<bool> result;
    for (const auto &x : unit)
      result.push_back(condition(x));
    return result;
  }
};

/** @p n parts in each direction, each cut into dim! simplices as Freudenthal
 * does; @p map keeps the orientation. */
template <int dim>
Block<dim>
make_block(
  const std::array<unsigned int, dim> &n,
  const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &map)
{
  Block<dim> block;
  std::array<unsigned int, dim> stride;
  unsigned int n_nodes = 1, n_boxes = 1;
  for (int d = 0; d < dim; ++d)
    {
      stride[d] = n_nodes;
      n_nodes *= n[d] + 1;
      n_boxes *= n[d];
    }
  for (unsigned int i = 0; i < n_nodes; ++i)
    {
      dealii::Point<dim> x;
      for (int d = 0; d < dim; ++d)
        x[d] = double(i / stride[d] % (n[d] + 1)) / n[d];
      block.unit.push_back(x);
      block.mesh.points.push_back(map(x));
    }
  for (unsigned int box = 0; box < n_boxes; ++box)
    {
      unsigned int rest = box, corner = 0;
      for (int d = 0; d < dim; ++d)
        {
          corner += stride[d] * (rest % n[d]);
          rest /= n[d];
        }
      std::array<int, dim> path;
      for (int d = 0; d < dim; ++d)
        path[d] = d;
      do
        {
          std::array<unsigned int, dim + 1> cell;
          cell[0]   = corner;
          int turns = 0;
          for (int d = 0; d < dim; ++d)
            {
              cell[d + 1] = cell[d] + stride[path[d]];
              for (int e = 0; e < d; ++e)
                turns += path[e] > path[d];
            }
          if (turns % 2 == 1)
            std::swap(cell[0], cell[1]);
          block.mesh.cells.push_back(cell);
      } while (std::next_permutation(path.begin(), path.end()));
    }
  return block;
}

/** Nodal positions as one array. */
template <int dim>
std::vector<double>
as_array(const std::vector<dealii::Point<dim>> &points)
{
  std::vector<double> X;
  for (const auto &x : points)
    for (int d = 0; d < dim; ++d)
      X.push_back(x[d]);
  return X;
}

/** Follower pressure on the face of a block where the first unit coordinate is
 * zero. */
template <int dim>
class FollowerPressure
{
public:
  explicit FollowerPressure(const Block<dim> &block)
  {
    for (const auto &cell : block.mesh.cells)
      for (unsigned int opposite = 0; opposite <= dim; ++opposite)
        {
          std::array<unsigned int, dim> face;
          bool on_face = true;
          for (unsigned int a = 0, i = 0; a <= dim; ++a)
            if (a != opposite)
              {
                face[i++] = cell[a];
                on_face   = on_face && block.unit[cell[a]][0] < 1e-9;
              }
          if (!on_face)
            continue;
          const std::vector<double> X = as_array(block.mesh.points);
          const auto area             = area_vector(face, X.data());
          double inwards              = 0;
          for (int d = 0; d < dim; ++d)
            inwards +=
              area[d] * (X[dim * cell[opposite] + d] - X[dim * face[0] + d]);
          if (inwards < 0)
            std::swap(face[0], face[1]);
          faces.push_back(face);
        }
  }

  /** F += forces of the pressure @p p on the block at @p X. */
  void
  add(const double p, const double *X, double *F) const
  {
    for (const auto &face : faces)
      {
        const auto area = area_vector(face, X);
        for (const unsigned int node : face)
          for (int d = 0; d < dim; ++d)
            F[dim * node + d] += p * area[d] / dim;
      }
  }

private:
  static std::array<double, dim>
  area_vector(const std::array<unsigned int, dim> &face, const double *X)
  {
    const auto edge = [&](const int i, const int d) {
      return X[dim * face[i] + d] - X[dim * face[0] + d];
    };
    std::array<double, dim> area;
    if constexpr (dim == 2)
      area = {{edge(1, 1), -edge(1, 0)}};
    else
      for (int d = 0; d < 3; ++d)
        area[d] = 0.5 *
          (edge(1, (d + 1) % 3) * edge(2, (d + 2) % 3) -
           edge(1, (d + 2) % 3) * edge(2, (d + 1) % 3));
    return area;
  }

  std::vector<std::array<unsigned int, dim>> faces;
};

/** Positions of the block at rest in vacuum under the pressure @p p on its
 * first face: a motion with mass damping at the rate @p damping (1/s), the
 * pressure rising within a fifth of the time @p end. */
template <int dim>
std::vector<double>
dry_equilibrium(const Block<dim> &block,
                const coapt::SolidOperator<dim> &solid,
                const std::vector<bool> &pinned,
                const double p,
                const double damping,
                const double dt,
                const double end)
{
  const FollowerPressure<dim> pressure(block);
  std::vector<double> y = as_array(block.mesh.points);
  const unsigned int n  = y.size();
  y.resize(2 * n, 0.);
  const auto rhs = [&](const double t, const double *y, double *y_dot) {
    std::copy_n(y + n, n, y_dot);
    double *force = y_dot + n;
    std::fill_n(force, n, 0.);
    solid.add_forces(y, y + n, force);
    pressure.add(p * std::min(1., 5 * t / end), y, force);
    for (unsigned int i = 0; i < n; ++i)
      force[i] = pinned[i / dim]
        ? 0.
        : force[i] / solid.mass()[i / dim] - damping * y[n + i];
  };
  coapt::ExplicitIntegrator integrator(MPI_COMM_SELF,
                                       rhs,
                                       [](double, double *) {});
  integrator.start(0, y);
  while (integrator.time() < end)
    integrator.step(dt);
  y.resize(n);
  return y;
}

#endif
