// Thin strips, and plates with plane strain, of linear and of quadratic
// elements on the same nodes: the deflection of one held at an end against that
// of a beam; no force inside under a linear map; mass, and the bound of the
// frequency.
#include <coapt/geometry/body_shapes.h>
#include <coapt/solid/solid_operator.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <random>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double length = 0.7, thickness = 0.0212, width = 0.05;
  constexpr double mu = 2e7, lambda = 8e7, density = 100;

  /** A strip along y, held at its lower end; in 3D without strain along z. */
  template <int dim>
  class Strip
  {
  public:
    Strip(const double size, const bool quadratic, const double bow = 0)
      : bow(bow)
      , mesh(strip_body(shape(bow), size, quadratic).mesh)
      , solid(mesh, parameters(), {}, {}, MPI_COMM_SELF)
    {
      for (const Point<dim> &x : mesh.points)
        for (unsigned int d = 0; d < dim; ++d)
          {
            X.push_back(x[d]);
            held.push_back(x[1] < 1e-9 || d == 2);
          }
    }

    unsigned int
    n_nodes() const
    {
      return mesh.points.size();
    }

    double
    mass() const
    {
      double sum = 0;
      for (const double m : solid.mass())
        sum += m;
      return sum;
    }

    /** Mean deflection of the free end under a small force there, which nodes
     * share by their masses, over that of a beam with its shear deformation. */
    double
    deflection() const
    {
      dealii::FullMatrix<double> compliance(X.size(), X.size());
      for (unsigned int j = 0; j < X.size(); ++j)
        {
          std::vector<double> unit(X.size(), 0.);
          unit[j]           = 1;
          const auto column = stiffness(unit);
          for (unsigned int i = 0; i < X.size(); ++i)
            compliance(i, j) = held[i] || held[j] ? i == j : column[i];
        }
      compliance.gauss_jordan();
      double sum = 0, weights = 0;
      for (unsigned int m = 0; m < n_nodes(); ++m)
        for (unsigned int n = 0; n < n_nodes(); ++n)
          if (mesh.points[m][1] > length - 1e-9 &&
              mesh.points[n][1] > length - 1e-9)
            {
              const double weight = solid.mass()[m] * solid.mass()[n];
              sum += weight * compliance(dim * m, dim * n);
              weights += weight;
            }
      const double depth   = dim == 3 ? width : 1;
      const double modulus = 4 * mu * (lambda + mu) / (lambda + 2 * mu);
      const double inertia = depth * std::pow(thickness, 3) / 12;
      const double beam    = std::pow(length, 3) / (3 * modulus * inertia) +
        1.2 * length / (mu * depth * thickness);
      return sum / weights / beam;
    }

    /** Largest force on nodes inside over that on any node, when the strip is
     * mapped linearly. */
    double
    force_inside() const
    {
      std::vector<double> mapped = X;
      for (unsigned int i = 0; i < mapped.size(); i += dim)
        {
          mapped[i] += 0.2 * X[i + 1];
          mapped[i + 1] *= 1.1;
        }
      const std::vector<double> F = forces(mapped);
      double inside = 0, largest = 0;
      for (unsigned int i = 0; i < F.size(); ++i)
        {
          largest = std::max(largest, std::abs(F[i]));
          if (!on_surface(mesh.points[i / dim]))
            inside = std::max(inside, std::abs(F[i]));
        }
      return inside / largest;
    }

    /** Bound of the frequency over the largest one, by power iteration. */
    double
    frequency_bound() const
    {
      std::mt19937 generator(1);
      std::uniform_real_distribution<double> noise(-1, 1);
      std::vector<double> u;
      for (unsigned int i = 0; i < X.size(); ++i)
        u.push_back(held[i] ? 0. : noise(generator));
      double growth = 0;
      for (unsigned int k = 0; k < 300; ++k)
        {
          double before = 0, after = 0;
          auto next = stiffness(u);
          for (unsigned int i = 0; i < u.size(); ++i)
            {
              next[i] = held[i] ? 0. : next[i] / solid.mass()[i / dim];
              before += u[i] * u[i];
              after += next[i] * next[i];
            }
          growth = std::sqrt(after / before);
          for (unsigned int i = 0; i < u.size(); ++i)
            u[i] = next[i] / growth;
        }
      return solid.max_frequency(X.data()) / std::sqrt(growth);
    }

  private:
    static StripShape<dim>
    shape(const double bow)
    {
      StripShape<dim> shape;
      shape.end       = Point<2>(0, length);
      shape.thickness = Tensor<1, 2>({-thickness, 0.});
      shape.bow       = bow;
      shape.z_upper   = width;
      return shape;
    }

    static SolidParameters
    parameters()
    {
      SolidParameters result;
      result.material           = "neo-Hookean";
      result.density            = density;
      result.viscosity          = 0;
      result.neo_hookean.mu     = mu;
      result.neo_hookean.lambda = lambda;
      return result;
    }

    std::vector<double>
    forces(const std::vector<double> &X) const
    {
      std::vector<double> F(X.size(), 0.);
      const std::vector<double> V(X.size(), 0.);
      solid.add_forces(X.data(), V.data(), F.data());
      return F;
    }

    /** Stiffness times the displacement @p u, as a difference. */
    std::vector<double>
    stiffness(const std::vector<double> &u) const
    {
      double largest = 0;
      for (const double value : u)
        largest = std::max(largest, std::abs(value));
      const double scale        = 1e-5 * thickness / largest;
      std::vector<double> moved = X, back = X;
      for (unsigned int i = 0; i < u.size(); ++i)
        {
          moved[i] += scale * u[i];
          back[i] -= scale * u[i];
        }
      std::vector<double> result  = forces(back);
      const std::vector<double> F = forces(moved);
      for (unsigned int i = 0; i < u.size(); ++i)
        result[i] = (result[i] - F[i]) / (2 * scale);
      return result;
    }

    bool
    on_surface(const Point<dim> &x) const
    {
      const double s = x[1] / length, tiny = 1e-9;
      const double middle = -bow * 4 * s * (1 - s);
      return x[1] < tiny || x[1] > length - tiny ||
        std::abs(x[0] - middle) > thickness / 2 - tiny ||
        (dim == 3 && (x[dim - 1] < tiny || x[dim - 1] > width - tiny));
    }

    double bow;
    SimplexMesh<dim> mesh;
    SolidOperator<dim> solid;
    std::vector<double> X;
    std::vector<bool> held; // by component
  };

  template <int dim>
  void
  check_strip(const std::string &name)
  {
    // Two nodes' distances across the thickness are half of those along it.
    const Strip<dim> linear(0.025, false), quadratic(0.025, true);
    const double of_linear    = linear.deflection();
    const double of_quadratic = quadratic.deflection();
    check(name + ", P1 bends too stiffly", of_linear < 0.7, of_linear);
    check(name + ", P2 bends as a beam",
          std::abs(of_quadratic - 1) < 0.03,
          of_quadratic);
    check_relative(name + ", P2, mass",
                   quadratic.mass(),
                   density * length * thickness * (dim == 3 ? width : 1),
                   1e-12);
    const double bound = quadratic.frequency_bound();
    check(name + ", P2, bound of the frequency",
          bound > 1 && bound < 2.5,
          bound);
    const double force = quadratic.force_inside();
    check(name + ", P2, no force inside", force < 1e-12, force);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_strip<2>("strip");
  check_strip<3>("plate");

  const Strip<2> coarse(0.05, true), fine(0.0125, true);
  const double of_coarse = coarse.deflection(), of_fine = fine.deflection();
  check("strip, P2, coarse", std::abs(of_coarse - 1) < 0.05, of_coarse);
  check("strip, P2, fine", std::abs(of_fine - 1) < 0.01, of_fine);
  check("strip, as many nodes for P1 and P2",
        Strip<2>(0.0106, false).n_nodes() == Strip<2>(0.0106, true).n_nodes());
  const double force = Strip<2>(0.025, true, 0.5 * thickness).force_inside();
  check("strip with curved edges, P2, no force inside", force < 1e-12, force);
}
