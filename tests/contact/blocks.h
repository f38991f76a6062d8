#ifndef coapt_tests_contact_blocks_h
#define coapt_tests_contact_blocks_h

#include <coapt/contact/facet_contact.h>
#include <coapt/solid/solid_operator.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

/** Elastic bodies that touch: blocks of triangles or tetrahedra. */
template <int dim>
struct Blocks
{
  using Point = dealii::Point<dim>;

  coapt::SimplexMesh<dim> mesh;

  /**
   * Adds n[0] x n[1] (x n[2]) boxes, each cut into two triangles, whose
   * diagonals alternate, or six tetrahedra. @p shape maps the unit square or
   * cube to the block. Returns the number of its first node; x runs fastest.
   */
  unsigned int
  add(const std::array<unsigned int, dim> &n,
      const std::function<Point(const Point &)> &shape)
  {
    const unsigned int first = mesh.points.size();
    std::array<unsigned int, dim> stride;
    unsigned int n_nodes = 1, n_boxes = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        stride[d] = n_nodes;
        n_nodes *= n[d] + 1;
        n_boxes *= n[d];
      }
    for (unsigned int node = 0; node < n_nodes; ++node)
      {
        Point p;
        for (unsigned int d = 0; d < dim; ++d)
          p[d] = node / stride[d] % (n[d] + 1) / double(n[d]);
        mesh.points.push_back(shape(p));
      }
    for (unsigned int box = 0; box < n_boxes; ++box)
      {
        unsigned int corner = first, rest = box, sum = 0;
        for (unsigned int d = 0; d < dim; rest /= n[d], ++d)
          {
            corner += rest % n[d] * stride[d];
            sum += rest % n[d];
          }
        add_box(corner, stride, sum % 2 == 1);
      }
    return first;
  }

private:
  void
  add_box(const unsigned int corner,
          const std::array<unsigned int, dim> &stride,
          const bool other_diagonal)
  {
    if constexpr (dim == 2)
      {
        const unsigned int a = corner, b = a + stride[0], c = a + stride[1],
                           d = b + stride[1];
        if (other_diagonal)
          {
            mesh.cells.push_back({{a, b, c}});
            mesh.cells.push_back({{b, d, c}});
          }
        else
          {
            mesh.cells.push_back({{a, b, d}});
            mesh.cells.push_back({{a, d, c}});
          }
      }
    else
      {
        std::array<unsigned int, 3> order{{0, 1, 2}};
        bool even = true;
        do
          {
            const unsigned int b = corner + stride[order[0]],
                               c = b + stride[order[1]],
                               d = c + stride[order[2]];
            // the permutations come with alternating pairs of signs
            even = (order[1] + 3 - order[0]) % 3 == 1;
            if (even)
              mesh.cells.push_back({{corner, b, c, d}});
            else
              mesh.cells.push_back({{corner, c, b, d}});
        } while (std::next_permutation(order.begin(), order.end()));
      }
  }
};

/** The motion of elastic bodies in contact by symplectic Euler steps. */
template <int dim>
struct Motion
{
  static constexpr double density = 1000;

  /** Young's modulus 1 MPa and this @p poisson ratio. The step is @p safety
   * times the stable one. */
  Motion(const coapt::SimplexMesh<dim> &mesh,
         const std::vector<bool> &held,
         const coapt::ContactParameters &parameters,
         const double depth,
         const double poisson,
         const double safety)
    : mesh(mesh)
    , held(held)
    , solid(mesh, material(poisson), {}, {}, MPI_COMM_WORLD)
    , contact(mesh, solid.mass(), held, parameters, depth, MPI_COMM_WORLD)
    , V(dim * mesh.points.size())
    , external(V.size())
  {
    for (const auto &p : mesh.points)
      for (unsigned int d = 0; d < dim; ++d)
        X.push_back(p[d]);
    dt = safety * 2 / solid.max_frequency(X.data());
  }

  static coapt::SolidParameters
  material(const double poisson)
  {
    coapt::SolidParameters parameters;
    parameters.material       = coapt::NeoHookean::name;
    parameters.density        = density;
    parameters.viscosity      = 0;
    parameters.neo_hookean.mu = modulus / (2 * (1 + poisson));
    parameters.neo_hookean.lambda =
      modulus * poisson / ((1 + poisson) * (1 - 2 * poisson));
    return parameters;
  }

  static constexpr double modulus = 1e6;

  /** One step; @p damping is the rate at which velocities decay (1/s). */
  void
  step(const double damping)
  {
    F = std::vector<double>(X.size(), 0.);
    solid.add_forces(X.data(), V.data(), F.data());
    dealii::Utilities::MPI::sum(F, MPI_COMM_WORLD, F);
    for (unsigned int n = 0; n < mesh.points.size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        {
          double &v = V[dim * n + d];
          // At rest, what the impulse of contact left is gone by now.
          if (!held[n])
            v = (v +
                 dt * (F[dim * n + d] + external[dim * n + d]) /
                   solid.mass()[n]) *
              (1 - damping * dt);
        }
    constrain(V);
    for (unsigned int i = 0; i < X.size(); ++i)
      X[i] += dt * V[i];
    result = contact.apply_impulse(X.data(), V.data(), dt);
    constrain(V);
    time += dt;
  }

  const coapt::SimplexMesh<dim> mesh;
  const std::vector<bool> held;
  const coapt::SolidOperator<dim> solid;
  coapt::FacetContact<dim> contact;
  std::vector<double> X, V, external, F;
  std::function<void(std::vector<double> &)> constrain =
    [](std::vector<double> &) {};
  typename coapt::FacetContact<dim>::Result result;
  double dt, time = 0;
};

#endif
