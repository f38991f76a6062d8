// The solid on irregular meshes, of linear elements, of such with averaged
// volumes, and of quadratic ones: patch test, rigid motion, conservation,
// energy, frequency bound, prestretch, and the division among ranks.

#include <coapt/base/exceptions.h>
#include <coapt/geometry/quadratic_mesh.h>
#include <coapt/solid/largest_frequency.h>
#include <coapt/solid/solid_operator.h>

#include <algorithm>
#include <limits>
#include <random>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

std::mt19937 generator(2);

double
random_number()
{
  return std::uniform_real_distribution<double>(-1, 1)(generator);
}

/** A cube of side 3 mm of n^dim boxes cut into simplices (Kuhn), whose
 * inner nodes are shaken. */
template <int dim>
SimplexMesh<dim>
shaken_cube(const unsigned int n)
{
  SimplexMesh<dim> mesh;
  const double h         = 3e-3 / n;
  const unsigned int n_z = (dim == 3 ? n : 0);
  const auto index       = [&](const unsigned int *i) {
    return (dim == 3 ? i[2] * (n + 1) * (n + 1) : 0) + i[1] * (n + 1) + i[0];
  };
  for (unsigned int z = 0; z <= n_z; ++z)
    for (unsigned int y = 0; y <= n; ++y)
      for (unsigned int x = 0; x <= n; ++x)
        {
          const unsigned int i[3] = {x, y, z};
          bool inner              = true;
          for (int d = 0; d < dim; ++d)
            inner = inner && i[d] > 0 && i[d] < n;
          Point<dim> p;
          for (int d = 0; d < dim; ++d)
            p[d] = h * (i[d] + (inner ? 0.15 * random_number() : 0.));
          mesh.points.push_back(p);
        }
  for (unsigned int z = 0; z < std::max(n_z, 1u); ++z)
    for (unsigned int y = 0; y < n; ++y)
      for (unsigned int x = 0; x < n; ++x)
        {
          int order[3] = {0, 1, 2};
          do
            {
              unsigned int i[3] = {x, y, z};
              std::array<unsigned int, dim + 1> cell;
              cell[0] = index(i);
              for (int d = 0; d < dim; ++d)
                {
                  ++i[order[d]];
                  cell[d + 1] = index(i);
                }
              Tensor<2, dim> edges;
              for (int d = 0; d < dim; ++d)
                edges[d] = mesh.points[cell[d + 1]] - mesh.points[cell[0]];
              if (determinant(edges) < 0)
                std::swap(cell[dim - 1], cell[dim]);
              mesh.cells.push_back(cell);
          } while (std::next_permutation(order, order + dim));
        }
  return mesh;
}

template <int dim>
std::vector<double>
mapped(const SimplexMesh<dim> &mesh, const Tensor<2, dim> &F)
{
  std::vector<double> X;
  for (const Point<dim> &p : mesh.points)
    for (int c = 0; c < dim; ++c)
      X.push_back((F * p)[c]);
  return X;
}

template <int dim>
bool
on_boundary(const Point<dim> &p)
{
  for (int d = 0; d < dim; ++d)
    if (p[d] < 1e-9 || p[d] > 3e-3 - 1e-9)
      return true;
  return false;
}

/** Forces of all ranks. */
template <int dim>
std::vector<double>
forces(const SolidOperator<dim> &solid,
       const std::vector<double> &X,
       const std::vector<double> &V)
{
  std::vector<double> F(X.size(), 0.), sum(X.size());
  solid.add_forces(X.data(), V.data(), F.data());
  dealii::Utilities::MPI::sum(F, MPI_COMM_WORLD, sum);
  return sum;
}

double
largest(const std::vector<double> &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

double
dot(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

std::vector<double>
shaken(const std::vector<double> &x, const double amplitude)
{
  std::vector<double> result = x;
  for (double &entry : result)
    entry += amplitude * random_number();
  return result;
}

template <int dim>
Tensor<2, dim>
identity()
{
  Tensor<2, dim> I;
  for (int d = 0; d < dim; ++d)
    I[d][d] = 1;
  return I;
}

template <int dim>
Tensor<2, dim>
rotation()
{
  Tensor<2, dim> R = identity<dim>();
  R[0][0] = R[1][1] = std::cos(0.7);
  R[1][0]           = std::sin(0.7);
  R[0][1]           = -R[1][0];
  if constexpr (dim == 3)
    {
      Tensor<2, 3> S = identity<3>();
      S[1][1] = S[2][2] = std::cos(1.9);
      S[2][1]           = std::sin(1.9);
      S[1][2]           = -S[2][1];
      R                 = S * R;
    }
  return R;
}

/** Largest frequency of the linearised solid, by power iteration. */
template <int dim>
double
measured_frequency(const SolidOperator<dim> &solid,
                   const std::vector<double> &X)
{
  const std::vector<double> rest(X.size(), 0.);
  std::vector<double> u = shaken(rest, 1.);
  double square         = 0;
  for (unsigned int iteration = 0; iteration < 300; ++iteration)
    {
      auto plus = X, minus = X;
      const double scale = 1e-9 / largest(u);
      for (unsigned int i = 0; i < X.size(); ++i)
        {
          plus[i] += scale * u[i];
          minus[i] -= scale * u[i];
        }
      const auto f_plus  = forces(solid, plus, rest);
      const auto f_minus = forces(solid, minus, rest);
      const double norm  = std::sqrt(dot(u, u));
      for (unsigned int i = 0; i < X.size(); ++i)
        u[i] = (f_minus[i] - f_plus[i]) / (2 * scale) /
          (norm * solid.mass()[i / dim]);
      square = std::sqrt(dot(u, u));
    }
  return std::sqrt(square);
}

enum class Elements
{
  linear,
  averaged,
  quadratic
};

/** The cube of elements of this kind. */
template <int dim>
SimplexMesh<dim>
cube_of(const Elements elements, const unsigned int n)
{
  const SimplexMesh<dim> linear = shaken_cube<dim>(n);
  if constexpr (dim == 3)
    if (elements == Elements::quadratic)
      return quadratic_mesh(linear);
  return linear;
}

template <int dim>
void
check_all(const std::string &material,
          const unsigned int n,
          const Elements elements = Elements::linear)
{
  const bool averages_volume = elements == Elements::averaged;
  const bool quadratic       = elements == Elements::quadratic;
  const std::string name     = std::to_string(dim) + "D " + material +
    (averages_volume ? ", averaged, "
       : quadratic   ? ", quadratic, "
                     : ", ");
  const SimplexMesh<dim> mesh = cube_of<dim>(elements, n);
  SolidParameters parameters;
  parameters.material        = material;
  parameters.averages_volume = averages_volume;
  std::vector<Tensor<1, dim>> fibre(mesh.cells.size());
  for (auto &f : fibre)
    for (int d = 0; d < dim; ++d)
      f[d] = (d < 2 ? 1. + d : 0.2);
  const SolidOperator<dim> solid(mesh, parameters, fibre, {}, MPI_COMM_WORLD);
  const auto X = mapped(mesh, identity<dim>());
  const std::vector<double> rest(X.size(), 0.);

  // The scale of a force: stiffness times an area.
  const double scale = 1e4 * std::pow(3e-3 / n, dim - 1);
  double mass        = 0;
  for (const double m : solid.mass())
    mass += m;
  check_relative(name + "mass",
                 mass,
                 parameters.density * std::pow(3e-3, dim),
                 1e-12);

  const std::vector<double> uniform(X.size(), 2.);
  check_relative(name + "kinetic energy",
                 solid.kinetic_energy(uniform.data()),
                 2. * dim * mass,
                 1e-12);

  const double rigid =
    largest(forces(solid, mapped(mesh, rotation<dim>()), rest)) / scale;
  check(name + "rigid rotation, no force", rigid < 1e-9, rigid);

  // Patch test.
  Tensor<2, dim> A = identity<dim>();
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      A[i][j] += 0.06 * std::sin(1. + 2 * i + 5 * j);
  const auto affine = mapped(mesh, A);
  const auto F      = forces(solid, affine, rest);
  double inside     = 0;
  for (unsigned int i = 0; i < F.size(); ++i)
    if (!on_boundary(mesh.points[i / dim]))
      inside = std::max(inside, std::abs(F[i]));
  check(name + "patch test", inside < 1e-10 * largest(F), inside);

  // The energy's change is the work against the forces.
  const auto crumpled = shaken(affine, 2e-5);
  const auto way      = shaken(rest, 1e-9);
  auto ahead = crumpled, behind = crumpled;
  for (unsigned int i = 0; i < way.size(); ++i)
    {
      ahead[i] += way[i];
      behind[i] -= way[i];
    }
  const double change =
    solid.elastic_energy(ahead.data()) - solid.elastic_energy(behind.data());
  check_relative(name + "energy and work",
                 change,
                 -2 * dot(forces(solid, crumpled, rest), way),
                 1e-6);

  // Momentum, angular momentum (elastic), and viscous power.
  const auto V       = shaken(rest, 1.);
  const auto force   = forces(solid, crumpled, V);
  const auto elastic = forces(solid, crumpled, rest);
  double momentum = 0, moment = 0;
  for (int c = 0; c < dim; ++c)
    {
      double sum = 0;
      for (unsigned int node = 0; node < solid.n_nodes(); ++node)
        sum += force[dim * node + c];
      momentum = std::max(momentum, std::abs(sum));
    }
  for (unsigned int node = 0; node < solid.n_nodes(); ++node)
    moment += crumpled[dim * node] * elastic[dim * node + 1] -
      crumpled[dim * node + 1] * elastic[dim * node];
  check(name + "sum of forces", momentum < 1e-11 * largest(force), momentum);
  check(name + "sum of moments",
        std::abs(moment) < 1e-13 * largest(force),
        moment);
  check_relative(name + "viscous power",
                 solid.viscous_power(V.data()),
                 dot(elastic, V) - dot(force, V),
                 1e-9);

  // Frequencies, also where the fibres are locked.
  Tensor<2, dim> locked = A;
  locked[0][0] *= 1.2;
  locked[1][1] *= 1.2;
  locked[dim - 1][dim - 1] /= (dim == 3 ? 1.44 : 1.2);
  const auto stretched = shaken(mapped(mesh, locked), 2e-5);
  const auto bound     = solid.step_bound(crumpled.data());
  const std::vector<bool> pinned(mesh.points.size(), false);
  LargestFrequency<dim> frequency(solid, mesh, pinned, MPI_COMM_WORLD);
  const double most_above = elements == Elements::linear ? 3 : 4;
  for (const auto &state : {crumpled, stretched})
    {
      const double omega    = solid.max_frequency(state.data());
      const double measured = measured_frequency(solid, state);
      check(name + "frequency is bounded",
            measured <= omega && omega < most_above * measured,
            omega / measured);
      // What limits has changed; a few calls find it.
      double estimate = 0;
      for (unsigned int i = 0; i < 5; ++i)
        estimate = frequency.update(state.data()).omega;
      const double expected =
        std::max(1.05 * measured, omega / (averages_volume ? 2.5 : 1.8));
      check(name + "frequency is estimated",
            std::abs(estimate / expected - 1) < 0.05,
            estimate / measured);
    }

  // The same on one rank.
  const SolidOperator<dim> serial(mesh, parameters, fibre, {}, MPI_COMM_SELF);
  std::vector<double> G(X.size(), 0.);
  serial.add_forces(crumpled.data(), V.data(), G.data());
  for (unsigned int i = 0; i < G.size(); ++i)
    G[i] -= force[i];
  const auto serial_bound = serial.step_bound(crumpled.data());
  check(name + "any number of ranks, same forces",
        largest(G) < 1e-12 * largest(force),
        largest(G));
  check(name + "any number of ranks, same bound",
        std::abs(serial_bound.omega / bound.omega - 1) < 1e-12 &&
          serial_bound.cell == bound.cell &&
          std::abs(serial_bound.min_jacobian - bound.min_jacobian) < 1e-12);
  const unsigned int n_owned =
    dealii::Utilities::MPI::sum<unsigned int>(solid.owned_cells().size(),
                                              MPI_COMM_WORLD);
  check(name + "each cell has one owner, parts are balanced",
        n_owned == mesh.cells.size() &&
          1.1 * n_owned > solid.owned_cells().size() *
              dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));

  // A position that is not a number is noticed.
  auto broken = crumpled;
  broken[1]   = std::numeric_limits<double>::quiet_NaN();
  check(name + "not a number is not masked",
        std::isnan(solid.step_bound(broken.data()).omega) &&
          std::isnan(forces(solid, broken, rest)[1]));

  // A prestretched solid is at rest where the prestretch is undone, and its
  // stress is that of the total deformation.
  Tensor<2, dim> F0 = identity<dim>();
  F0[0][0]          = 1.1;
  F0[1][1]          = 1 / 1.1;
  F0[0][1]          = 0.05;
  const std::vector<Tensor<2, dim>> all_F0(mesh.cells.size(), F0);
  const SolidOperator<dim> taut(
    mesh, parameters, fibre, all_F0, MPI_COMM_WORLD);
  const double undone =
    largest(forces(taut, mapped(mesh, rotation<dim>() * invert(F0)), rest)) /
    scale;
  check(name + "prestretch undone, no force", undone < 1e-9, undone);
  const CellResults cells = taut.cell_results(affine.data());
  const CellResults same  = solid.cell_results(mapped(mesh, A * F0).data());
  double difference       = 0;
  for (unsigned int i = 0; i < cells.von_mises.size(); ++i)
    difference = std::max(difference,
                          std::abs(cells.von_mises[i] / same.von_mises[i] - 1) +
                            std::abs(cells.volume_ratio[i] - determinant(A)));
  check(name + "stress of F F0, Jacobian of F", difference < 1e-9, difference);
}

/** Uniaxial stretch: stress and strain in closed form. */
void
check_results()
{
  const SimplexMesh<3> mesh = shaken_cube<3>(2);
  SolidParameters parameters;
  parameters.material  = "neo-Hookean";
  Tensor<2, 3> stretch = identity<3>();
  stretch[0][0]        = 1.3;
  const Tensor<2, 3> R = rotation<3>();
  const SolidOperator<3> solid(mesh, parameters, {}, {}, MPI_COMM_WORLD);
  const CellResults cells =
    solid.cell_results(mapped(mesh, R * stretch).data());
  const double mu = parameters.neo_hookean.mu;
  const double first =
    (mu * (1.69 - 1) + parameters.neo_hookean.lambda * std::log(1.3)) / 1.3;
  double error = 0;
  for (unsigned int i = 0; i < cells.von_mises.size(); ++i)
    error =
      std::max({error,
                std::abs(cells.von_mises[i] / (mu * (1.69 - 1) / 1.3) - 1),
                std::abs(cells.principal_stress[i] / first - 1),
                std::abs(cells.largest_strain[i] / std::log(1.3) - 1),
                std::abs(cells.volume_ratio[i] - 1.3)});
  check("stress and strain of a stretched block", error < 1e-10, error);
}

void
check_refused()
{
  SimplexMesh<3> mesh = shaken_cube<3>(2);
  std::swap(mesh.cells[3][0], mesh.cells[3][1]);
  std::string message;
  try
    {
      SolidParameters parameters;
      parameters.material = "neo-Hookean";
      SolidOperator<3>(mesh, parameters, {}, {}, MPI_COMM_WORLD);
    }
  catch (const InputError &error)
    {
      message = error.what();
    }
  check("inverted cell is refused by number",
        message.find("1 cells are inverted") != std::string::npos &&
          message.find("3 at (") != std::string::npos);
}

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_all<2>("neo-Hookean", 5);
  check_all<3>("neo-Hookean", 3);
  check_all<3>("HGO", 3);
  check_all<3>("Ogden", 3);
  check_all<2>("neo-Hookean", 5, Elements::averaged);
  check_all<3>("HGO", 3, Elements::averaged);
  check_all<3>("neo-Hookean", 3, Elements::quadratic);
  check_all<3>("HGO", 3, Elements::quadratic);
  check_all<3>("Ogden", 3, Elements::quadratic);
  check_results();
  check_refused();
}
