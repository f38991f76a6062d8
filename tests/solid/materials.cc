// Stresses of the materials against closed forms and against the derivative
// of their energies; inadmissible parameters are refused.

#include <coapt/base/exceptions.h>
#include <coapt/solid/solid_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <random>

#include "tests.h"

using namespace coapt;

using Matrix = SmallMatrix<3, double>;

std::mt19937 generator(1);

double
random_number()
{
  return std::uniform_real_distribution<double>(-1, 1)(generator);
}

/** A random deformation gradient with the determinant J. */
template <int dim>
SmallMatrix<dim, double>
random_gradient(const double J)
{
  SmallMatrix<dim, double> F;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      F[i][j] = (i == j ? 1. : 0.) + 0.15 * random_number();
  const double factor = J / determinant(F, cofactors(F));
  for (int j = 0; j < dim; ++j)
    F[0][j] *= factor;
  return F;
}

const double fibre[9] = {2. / 7, 3. / 7, 6. / 7};

/** Largest difference of the stress from the energy's derivative, relative. */
template <int dim, typename Material>
double
derivative_error(const Material &material, const SmallMatrix<dim, double> &F)
{
  const auto P      = material.first_piola(F, fibre);
  double error      = 0;
  const double step = 1e-5;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      {
        const auto energy = [&](const double s) {
          auto G = F;
          G[i][j] += s;
          return material.energy(G, fibre);
        };
        const double slope = (8 * (energy(step) - energy(-step)) -
                              (energy(2 * step) - energy(-2 * step))) /
          (12 * step);
        error = std::max(error, std::abs(slope - P[i][j]));
      }
  return error / std::sqrt(square_norm(P));
}

template <int dim, typename Material>
void
check_derivative(const std::string &name, const Material &material)
{
  double error = 0;
  for (const double J : {0.8, 0.95, 1., 1.05, 0.05, -0.3})
    error =
      std::max(error, derivative_error(material, random_gradient<dim>(J)));
  check(name + ": stress is the derivative of the energy", error < 1e-7, error);
}

/** Second Piola-Kirchhoff stress S_ii under equibiaxial stretch l at constant
 * volume, with the pressure that makes the third normal stress vanish. */
double
equibiaxial(const HolzapfelGasserOgden &material, const double l, const int i)
{
  Matrix F{};
  F[0][0] = F[1][1]       = l;
  F[2][2]                 = 1 / (l * l);
  const double along_1[9] = {1};
  const auto P            = material.first_piola(F, along_1);
  return (P[i][i] * F[i][i] - P[2][2] * F[2][2]) / (l * l);
}

void
check_hgo()
{
  const HolzapfelGasserOgden m;
  const double stretches[]  = {1.05, 1.10, 1.15, 1.20};
  const double printed[][2] = {{1.249, 1.173},
                               {2.542, 2.150},
                               {9.036, 4.917},
                               {281.8, 114.4}};
  double formula_error = 0, printed_error = 0;
  for (int k = 0; k < 4; ++k)
    {
      const double l2 = stretches[k] * stretches[k], l4 = 1 / (l2 * l2);
      const double E =
        m.kappa * (2 * l2 + l4 - 3) + (1 - 3 * m.kappa) * (l2 - 1);
      const double S        = m.K1 * E * std::exp(m.K2 * E * E);
      const double s22      = 2 * (m.C10 + m.kappa * S) * (l2 - l4);
      const double s11      = s22 + 2 * (1 - 3 * m.kappa) * S * l2;
      const double exact[2] = {s11 / l2, s22 / l2};
      for (int i = 0; i < 2; ++i)
        {
          const double value = equibiaxial(m, stretches[k], i);
          formula_error =
            std::max(formula_error, std::abs(value / exact[i] - 1));
          printed_error = std::max(printed_error,
                                   std::abs(value / (1e3 * printed[k][i]) - 1));
        }
    }
  check("HGO equibiaxial, formula", formula_error < 1e-6, formula_error);
  check("HGO equibiaxial, published digits",
        printed_error < 5e-4,
        printed_error);

  // Beyond the limit, the fibre stress goes on with its slope at the limit.
  HolzapfelGasserOgden soft;
  soft.C10               = 1e-3;
  soft.exponential_limit = 0.2;
  const auto stress      = [&](const double E) {
    // E is linear in the square of the stretch if kappa is zero.
    HolzapfelGasserOgden fibres = soft;
    fibres.kappa                = 0;
    const double l              = std::sqrt(1 + E);
    Matrix F{};
    F[0][0] = l;
    F[1][1] = F[2][2]       = 1 / std::sqrt(l);
    const double along_1[9] = {1};
    const auto P            = fibres.first_piola(F, along_1);
    return (P[0][0] * F[0][0] - P[1][1] * F[1][1]) / (2 * l * l);
  };
  const double limit = 4000 * 0.2 * std::exp(150 * 0.04);
  const double slope = 4000 * (1 + 2 * 150 * 0.04) * std::exp(150 * 0.04);
  check_relative("HGO at the limit", stress(0.2), limit, 1e-6);
  check_relative("HGO beyond it", stress(0.5), limit + 0.3 * slope, 1e-6);
}

Ogden
ogden(const std::string &convention,
      const std::vector<double> &mu,
      const std::vector<double> &alpha)
{
  Ogden m;
  m.convention = convention;
  m.mu         = mu;
  m.alpha      = alpha;
  return m;
}

/** Slope of the shear stress at no strain. */
double
measured_shear_modulus(const Ogden &m)
{
  Matrix F{};
  F[0][0] = F[1][1] = F[2][2] = 1;
  F[0][1]                     = 1e-5;
  return m.first_piola(F, fibre)[0][1] / F[0][1];
}

void
check_refused(const std::string &name,
              const std::function<void()> &action,
              const std::vector<std::string> &words)
{
  std::string message = "nothing was refused";
  try
    {
      action();
    }
  catch (const InputError &error)
    {
      message = error.what();
    }
  bool complete = true;
  for (const std::string &word : words)
    complete = complete && message.find(word) != std::string::npos;
  check(name, complete);
  if (!complete)
    std::cout << message << std::endl;
}

void
check_ogden()
{
  const std::vector<double> mu_1    = {0.002, 1010.038, 1230.418};
  const std::vector<double> alpha_1 = {63.659, 9.471, 22.412};
  const std::vector<double> mu_2    = {-481836.3, 484166.6, 742.8};
  const std::vector<double> alpha_2 = {-19.4, -19.3, -25};

  for (const Ogden &m : {ogden("Abaqus", mu_1, alpha_1),
                         ogden("classical", mu_1, alpha_1),
                         ogden("Abaqus", mu_2, alpha_2)})
    {
      m.check();
      check_relative("Ogden " + m.convention + ": initial shear modulus",
                     measured_shear_modulus(m),
                     m.shear_modulus(),
                     1e-5);
      check_derivative<3>("Ogden " + m.convention, m);
    }
  check_relative("Ogden Abaqus: sum of mu",
                 ogden("Abaqus", mu_2, alpha_2).shear_modulus(),
                 3073.1,
                 1e-6);
  check_refused("Ogden classical: negative shear modulus refused",
                [&]() { ogden("classical", mu_2, alpha_2).check(); },
                {"-7680", "classical", "positive"});
  check_refused("Ogden: lists of different length refused",
                [&]() { ogden("Abaqus", mu_1, {2.}).check(); },
                {"3 values of mu", "1 of alpha"});

  // With one exponent of two, both conventions are neo-Hookean, as is HGO
  // without fibres; also where principal stretches coincide.
  HolzapfelGasserOgden matrix;
  matrix.K1    = 0;
  double error = 0;
  Matrix equal{};
  equal[0][1] = equal[1][2] = 1.1;
  equal[2][0]               = 0.9;
  for (const Matrix &F : {random_gradient<3>(1.02), equal})
    for (const std::string convention : {"Abaqus", "classical"})
      {
        const auto P = matrix.first_piola(F, fibre);
        const auto Q =
          ogden(convention, {2 * matrix.C10}, {2.}).first_piola(F, fibre);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            error = std::max(error, std::abs(P[i][j] - Q[i][j]));
      }
  check("Ogden with exponent two is neo-Hookean", error < 1e-8, error);
}

/** A batch gives what its entries give one by one. */
template <typename Material>
void
check_batch(const std::string &name, const Material &material)
{
  SmallMatrix<3, Batch> F;
  Batch directions[9] = {};
  Matrix single[batch_size];
  for (unsigned int lane = 0; lane < batch_size; ++lane)
    {
      single[lane] = random_gradient<3>(1 + 0.02 * random_number());
      for (int i = 0; i < 3; ++i)
        {
          directions[i][lane] = fibre[i];
          for (int j = 0; j < 3; ++j)
            F[i][j][lane] = single[lane][i][j];
        }
    }
  const auto P = material.first_piola(F, directions);
  double error = 0;
  for (unsigned int lane = 0; lane < batch_size; ++lane)
    {
      const auto p = material.first_piola(single[lane], fibre);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          error = std::max(error,
                           std::abs(P[i][j][lane] - p[i][j]) /
                             std::sqrt(square_norm(p)));
    }
  check(name + ": batch equals single cells", error < 1e-12, error);
}

void
check_parameters()
{
  const auto parse = [](const std::string &text) {
    dealii::ParameterHandler prm;
    SolidParameters::declare_parameters(prm);
    prm.parse_input_from_string("subsection Solid\n" + text + "\nend\n");
    SolidParameters parameters;
    parameters.parse_parameters(prm);
    return parameters;
  };
  const SolidParameters read = parse("set Density = 1200"), defaults;
  check("parameters: default and given values",
        read.density == 1200 && read.viscosity == defaults.viscosity &&
          read.holzapfel_gasser_ogden.kappa == 0.25 &&
          read.ogden.alpha == defaults.ogden.alpha &&
          read.neo_hookean.lambda == defaults.neo_hookean.lambda);
  check_refused(
    "parameters: dispersion above 1/3 refused",
    [&]() {
      parse("subsection Holzapfel-Gasser-Ogden\nset Dispersion = 0.4\nend");
    },
    {"0.4", "from 0 to 1/3", "Dispersion"});
}

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_hgo();
  check_derivative<3>("HGO", HolzapfelGasserOgden());
  check_derivative<2>("neo-Hookean 2D", NeoHookean());
  check_derivative<3>("neo-Hookean 3D", NeoHookean());
  check_derivative<2>("St Venant-Kirchhoff 2D", SaintVenantKirchhoff());
  check_derivative<3>("St Venant-Kirchhoff 3D", SaintVenantKirchhoff());
  check_derivative<2>("tense fibres 2D", TenseFibres());
  check_derivative<3>("tense fibres 3D", TenseFibres());
  check_ogden();
  check_batch("HGO", HolzapfelGasserOgden());
  check_batch("Ogden", Ogden());
  check_batch("neo-Hookean", NeoHookean());
  check_parameters();
}
