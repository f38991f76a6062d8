#ifndef coapt_tests_contact_blocks_h
#define coapt_tests_contact_blocks_h

#include <coapt/contact/facet_contact.h>
#include <coapt/geometry/boundary_faces.h>
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
   * Adds n[0] x n[1] (x n[2]) boxes, each cut into two triangles or six
   * tetrahedra. @p shape maps the unit square or
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
        unsigned int corner = first, rest = box;
        for (unsigned int d = 0; d < dim; rest /= n[d], ++d)
          corner += rest % n[d] * stride[d];
        add_box(corner, stride);
      }
    return first;
  }

private:
  void
  add_box(const unsigned int corner,
          const std::array<unsigned int, dim> &stride)
  {
    if constexpr (dim == 2)
      {
        const unsigned int a = corner, b = a + stride[0], c = a + stride[1],
                           d = b + stride[1];
        mesh.cells.push_back({{a, b, d}});
        mesh.cells.push_back({{a, d, c}});
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

/** Elastic bodies in contact, by symplectic Euler steps. */
template <int dim>
struct Motion
{
  static constexpr double density = 1000, modulus = 1e6;

  using Facets = std::vector<std::array<unsigned int, dim>>;

  /** Young's modulus 1 MPa and this @p poisson ratio. The step is 0.5 times the
   * stable one; if only the state of rest is asked for, steps are of length
   * one and masses such that they are stable (Underwood 1983). */
  Motion(const coapt::SimplexMesh<dim> &mesh,
         const std::vector<bool> &held,
         const Facets &facets,
         const coapt::ContactParameters &parameters,
         const double depth,
         const double poisson,
         const bool relaxes)
    : mesh(mesh)
    , held(held)
    , solid(mesh, material(poisson), {}, {}, MPI_COMM_WORLD)
    , mass(relaxes ? fictitious_masses(facets, poisson) : solid.mass())
    , contact(mesh, facets, mass, held, parameters, depth, MPI_COMM_WORLD)
    , V(dim * mesh.points.size())
    , external(V.size())
  {
    for (const auto &p : mesh.points)
      for (unsigned int d = 0; d < dim; ++d)
        X.push_back(p[d]);
    dt = relaxes ? 1 : 1 / solid.max_frequency(X.data());
  }

  /** One step. */
  void
  step()
  {
    pull();
    constrain(V);
    push();
  }

  /** Steps to rest: velocities are set to zero whenever the kinetic energy
   * falls (Cundall's kinetic damping). */
  void
  relax(const unsigned int n_steps)
  {
    double last = 0;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        pull();
        constrain(V);
        double energy = 0;
        for (unsigned int i = 0; i < V.size(); ++i)
          energy += mass[i / dim] * V[i] * V[i];
        if (energy < last)
          {
            std::fill(V.begin(), V.end(), 0.);
            energy = 0;
          }
        last = energy;
        push();
      }
  }

  const coapt::SimplexMesh<dim> mesh;
  const std::vector<bool> held;
  const coapt::SolidOperator<dim> solid;
  const std::vector<double> mass;
  coapt::FacetContact<dim> contact;
  std::vector<double> X, V, external, F;
  std::function<void(std::vector<double> &)> constrain =
    [](std::vector<double> &) {};
  typename coapt::FacetContact<dim>::Result result;
  double dt;

  /** Puts a @p pressure (Pa) on the facets all of whose corners satisfy the
   * @p condition, for their area in the reference, along @p direction. */
  void
  load(const double pressure,
       const dealii::Tensor<1, dim> &direction,
       const std::function<bool(const dealii::Point<dim> &)> &condition)
  {
    for (const auto &face : coapt::boundary_faces<dim>(mesh.cells))
      {
        std::array<dealii::Point<dim>, dim> corners;
        bool on_it = true;
        for (unsigned int i = 0; i < dim; ++i)
          {
            corners[i] = mesh.points[face.nodes[i]];
            on_it      = on_it && condition(corners[i]);
          }
        const double share =
          on_it ? coapt::area_normal<dim>(corners).norm() / dim : 0.;
        for (const unsigned int node : face.nodes)
          for (unsigned int d = 0; d < dim; ++d)
            external[dim * node + d] += pressure * share * direction[d];
      }
  }

private:
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

  /** Half of the sums of the rows of the stiffness matrix (bounds by the norms
   * of the gradients): twice what steps of length one need. The stiffness of
   * contact goes with the least mass of its nodes, so all of them get eight
   * times the largest. */
  std::vector<double>
  fictitious_masses(const Facets &facets, const double poisson) const
  {
    const auto constants = material(poisson).neo_hookean;
    std::vector<double> masses(mesh.points.size());
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const auto &cell = mesh.cells[c];
        dealii::Tensor<2, dim> edges;
        for (unsigned int i = 0; i < dim; ++i)
          edges[i] = mesh.points[cell[i + 1]] - mesh.points[cell[0]];
        const auto gradients = transpose(invert(edges));
        std::array<double, dim + 1> norms;
        dealii::Tensor<1, dim> first;
        double sum = 0;
        for (unsigned int i = 0; i < dim; ++i)
          {
            norms[i + 1] = gradients[i].norm();
            first -= gradients[i];
            sum += norms[i + 1];
          }
        norms[0] = first.norm();
        sum += norms[0];
        for (unsigned int i = 0; i <= dim; ++i)
          masses[cell[i]] += 0.5 * (constants.lambda + 2 * constants.mu) *
            solid.cell_volumes()[c] * norms[i] * sum;
      }

    std::vector<double> area(masses.size());
    for (const auto &facet : facets)
      {
        std::array<dealii::Point<dim>, dim> corners;
        for (unsigned int i = 0; i < dim; ++i)
          corners[i] = mesh.points[facet[i]];
        for (const unsigned int node : facet)
          area[node] += coapt::area_normal<dim>(corners).norm() / dim;
      }
    double largest = 0;
    for (unsigned int n = 0; n < masses.size(); ++n)
      if (area[n] > 0 && !held[n])
        largest = std::max(largest, masses[n] / area[n]);
    for (unsigned int n = 0; n < masses.size(); ++n)
      masses[n] = std::max(masses[n], 8 * largest * area[n]);
    return masses;
  }

  void
  pull()
  {
    F = std::vector<double>(X.size(), 0.);
    solid.add_forces(X.data(), V.data(), F.data());
    dealii::Utilities::MPI::sum(F, MPI_COMM_WORLD, F);
    for (unsigned int i = 0; i < X.size(); ++i)
      if (!held[i / dim])
        V[i] += dt * (F[i] + external[i]) / mass[i / dim];
  }

  // At rest, the impulse of contact is what the next pull takes away.
  void
  push()
  {
    for (unsigned int i = 0; i < X.size(); ++i)
      X[i] += dt * V[i];
    result = contact.apply_impulse(X.data(), V.data(), dt);
    constrain(V);
  }
};

#endif
