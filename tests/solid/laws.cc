// What every material must fulfil: the stress is the energy's derivative,
// frames do not matter, energies are positive, frequency bounds are bounds, and
// a lost positivity is found.

#include <coapt/solid/sheet_state.h>
#include <coapt/solid/stability.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests.h"

using namespace coapt;

using Matrix = SmallMatrix<3, double>;

std::mt19937 generator(3);

double
random_number()
{
  return std::uniform_real_distribution<double>(-1, 1)(generator);
}

Matrix
product(const Matrix &A, const Matrix &B)
{
  Matrix C{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        C[i][j] += A[i][k] * B[k][j];
  return C;
}

double
difference(const Matrix &A, const Matrix &B)
{
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      sum += (A[i][j] - B[i][j]) * (A[i][j] - B[i][j]);
  return std::sqrt(sum);
}

/** A random deformation gradient with the determinant J. */
Matrix
random_gradient(const double J, const double amplitude = 0.15)
{
  Matrix F;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      F[i][j] = (i == j ? 1. : 0.) + amplitude * random_number();
  const double factor = J / determinant(F, cofactors(F));
  for (int j = 0; j < 3; ++j)
    F[0][j] *= factor;
  return F;
}

/** Rotation by an angle about the unit vector n (Rodrigues). */
Matrix
rotation(const double *n, const double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      R[i][j] = (i == j ? c : 0.) + (1 - c) * n[i] * n[j];
  for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      R[k][j] += s * n[i];
      R[j][k] -= s * n[i];
    }
  return R;
}

/** Directions of a cell: fibre, across, normal. */
const double directions[9] =
  {2. / 7, 3. / 7, 6. / 7, 3. / 7, -6. / 7, 2. / 7, 6. / 7, 2. / 7, -3. / 7};

/** Entries of the derivative of the energy by automatic differentiation. */
template <typename Law>
double
derivative_error(const Law &law, const Matrix &F)
{
  Dual<9> fibre[9];
  for (int i = 0; i < 9; ++i)
    fibre[i] = directions[i];
  const Dual<9> W = law.energy(with_derivatives(F), fibre);
  Matrix slope;
  for (int i = 0; i < 9; ++i)
    slope[i / 3][i % 3] = W.slope[i];
  const Matrix P = law.first_piola(F, directions);
  return difference(slope, P) / std::sqrt(square_norm(P));
}

/** Largest difference of the tangent from differences of the stress. */
template <typename Law>
double
tangent_error(const Law &law, const Matrix &F)
{
  const MaterialTangent A = material_tangent(law, F, directions);
  const double step       = 1e-6;
  double error = 0, largest = 0;
  for (int k = 0; k < 9; ++k)
    {
      Matrix upper = F, lower = F;
      upper[k / 3][k % 3] += step;
      lower[k / 3][k % 3] -= step;
      const Matrix P = law.first_piola(upper, directions);
      const Matrix Q = law.first_piola(lower, directions);
      for (int i = 0; i < 9; ++i)
        {
          const double slope = (P[i / 3][i % 3] - Q[i / 3][i % 3]) / (2 * step);
          error              = std::max(error, std::abs(slope - A[i][k]));
          largest            = std::max(largest, std::abs(slope));
        }
    }
  return error / largest;
}

template <typename Law>
void
check_derivatives(const std::string &name, const Law &law)
{
  double error = 0, error_of_tangent = 0;
  for (unsigned int i = 0; i < 20; ++i)
    for (const double J : {0.8, 0.95, 1., 1.05, 0.05, -0.3})
      error = std::max(error, derivative_error(law, random_gradient(J)));
  check(name + ": stress is the derivative of the energy", error < 1e-8, error);

  // Principal stretches may coincide, two or all of them; with all, fibres are
  // about to become slack, which is a kink.
  Matrix equal{}, two_equal{};
  equal[0][1] = equal[1][2] = equal[2][0] = 1.02;
  two_equal[0][0] = two_equal[1][1] = 1.1;
  two_equal[2][2]                   = 0.8;
  for (const Matrix &F : {random_gradient(1.02), two_equal})
    error_of_tangent = std::max(error_of_tangent, tangent_error(law, F));
  if (!law.has_fibres)
    error_of_tangent = std::max(error_of_tangent, tangent_error(law, equal));
  check(name + ": tangent is the derivative of the stress",
        error_of_tangent < 1e-4,
        error_of_tangent);
}

/** A rotation of the deformed body turns the stress; one of the reference, with
 * its directions, too. */
template <typename Law>
void
check_frames(const std::string &name, const Law &law)
{
  double error = 0;
  for (unsigned int i = 0; i < 20; ++i)
    {
      const Matrix F = random_gradient(1 + 0.05 * random_number());
      const Matrix R = rotation(directions + 3 * (i % 3), 3 * random_number());
      const Matrix P = law.first_piola(F, directions);
      const double W = law.energy(F, directions);
      const double size = std::sqrt(square_norm(P));
      const Matrix RF   = product(R, F);
      error             = std::max(
        {error,
                     difference(law.first_piola(RF, directions), product(R, P)) / size,
                     std::abs(law.energy(RF, directions) - W) / size});

      Matrix transposed;
      double turned[9];
      for (int k = 0; k < 3; ++k)
        {
          multiply(R, directions + 3 * k, turned + 3 * k);
          for (int l = 0; l < 3; ++l)
            transposed[k][l] = R[l][k];
        }
      const Matrix FR = product(F, transposed);
      error           = std::max(error,
                       difference(law.first_piola(FR, turned),
                                  product(P, transposed)) /
                         size);
    }
  check(name + ": objective, and directions turn with the body",
        error < 1e-11,
        error);
}

/** Rotations of the reference about the fibre, or only half a turn. */
template <typename Law>
void
check_symmetry(const std::string &name, const Law &law, const bool any_angle)
{
  double error = 0;
  for (unsigned int i = 0; i < 20; ++i)
    {
      const Matrix F = random_gradient(1.01);
      const Matrix Q =
        rotation(directions, any_angle ? 3 * random_number() : std::acos(-1.));
      const Matrix P = law.first_piola(F, directions);
      error          = std::max(error,
                       difference(law.first_piola(product(F, Q), directions),
                                  product(P, Q)) /
                         std::sqrt(square_norm(P)));
    }
  check(name + ": symmetric about the fibre", error < 1e-11, error);
}

template <typename Law>
void
check_energy(const std::string &name, const Law &law)
{
  Matrix identity{};
  for (int i = 0; i < 3; ++i)
    identity[i][i] = 1;
  double smallest = 0;
  for (unsigned int i = 0; i < 2000; ++i)
    smallest = std::min(smallest,
                        law.energy(random_gradient(1 + 0.2 * random_number(),
                                                   0.05 + 0.002 * (i % 200)),
                                   directions));
  check(name + ": energy is not negative", smallest >= 0, smallest);
  const double at_rest = std::abs(law.energy(identity, directions)) +
    std::sqrt(square_norm(law.first_piola(identity, directions)));
  check(name + ": neither energy nor stress at rest", at_rest < 1e-8, at_rest);
}

/** Largest eigenvalue of the stiffness of a tetrahedron with these gradients,
 * per volume, by power iteration on the shifted matrix. */
double
largest_stiffness(const MaterialTangent &A, const double (&g)[4][3])
{
  double K[12][12] = {}, shift = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
              K[3 * a + i][3 * b + j] +=
                g[a][k] * A[3 * i + k][3 * j + l] * g[b][l];
  for (const auto &row : K)
    for (const double entry : row)
      shift += entry * entry / 144;
  shift = std::sqrt(shift);
  std::vector<double> x(12);
  for (double &entry : x)
    entry = random_number();
  double value = 0;
  for (unsigned int n = 0; n < 400; ++n)
    {
      std::vector<double> y(12);
      double square = 0, dot = 0;
      for (int i = 0; i < 12; ++i)
        {
          y[i] = shift * x[i];
          for (int j = 0; j < 12; ++j)
            y[i] += K[i][j] * x[j];
          square += x[i] * x[i];
          dot += x[i] * y[i];
        }
      value             = dot / square - shift;
      const double norm = 1 / std::sqrt(square);
      for (int i = 0; i < 12; ++i)
        x[i] = y[i] * norm;
    }
  return value;
}

/** The bound of a cell's stiffness against the largest one found, for regular
 * and for flat cells. */
template <typename Law>
void
check_bound(const std::string &name, const Law &law, const double closeness)
{
  double lowest = 1e300, highest = 0;
  for (unsigned int n = 0; n < 300; ++n)
    {
      const Matrix F = random_gradient(1 + 0.05 * random_number(), 0.25);
      double g[4][3] = {};
      for (int a = 1; a < 4; ++a)
        for (int i = 0; i < 3; ++i)
          {
            g[a][i] = (a == i + 1 ? 1 : 0) + 0.3 * random_number();
            if (n % 2 == 1 && a == 3)
              g[a][i] *= 4;
          }
      for (int a = 1; a < 4; ++a)
        for (int i = 0; i < 3; ++i)
          g[0][i] -= g[a][i];
      const double found =
        largest_stiffness(material_tangent(law, F, directions), g);
      const double ratio = law.stiffness_bound(F, directions, g) / found;
      lowest             = std::min(lowest, ratio);
      highest            = std::max(highest, ratio);
    }
  check(name + ": the stiffness bound is one", lowest > 1 - 1e-6, lowest);
  check(name + ": the stiffness bound is near", highest < closeness, highest);
}

template <typename Law>
void
check_law(const std::string &name,
          const Law &law,
          const bool any_angle,
          const double closeness)
{
  law.check();
  check_derivatives(name, law);
  check_frames(name, law);
  check_symmetry(name, law, any_angle);
  check_energy(name, law);
  check_bound(name, law, closeness);
}

/** A Fung solid with all 21 constants. */
Fung
spatial_fung()
{
  double R[6][6];
  for (auto &row : R)
    for (double &entry : row)
      entry = random_number();
  Fung law;
  law.b.clear();
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      {
        double sum = 0;
        for (int k = 0; k < 6; ++k)
          sum += 4 * R[i][k] * R[j][k];
        law.b.push_back(sum);
      }
  return law;
}

HolzapfelGasserOgden
two_families()
{
  HolzapfelGasserOgden law;
  law.kappa    = 0.1;
  law.families = {{{0.8, 0.6}}, {{0.8, -0.6}}};
  return law;
}

void
check_stability()
{
  SolidParameters parameters;
  parameters.lowest_stretch  = 0.8;
  parameters.highest_stretch = 1.3;
  for (const std::string name : {"neo-Hookean", "HGO"})
    {
      parameters.material = name;
      check(name + ": no instability", stability_warning(parameters).empty());
    }

  // The second term weakens the material and wins at large stretches: the
  // shear modulus 1 - 0.5 of small strain is positive.
  parameters.material          = "Ogden";
  parameters.ogden.convention  = "Abaqus";
  parameters.ogden.mu          = {1000, -500};
  parameters.ogden.alpha       = {2, 12};
  const std::string warning    = stability_warning(parameters);
  const bool names_all_of_them = warning.find("Ogden") != std::string::npos &&
    warning.find("along the fibres") != std::string::npos &&
    warning.find("Pa") != std::string::npos;
  check("Ogden with a negative term: warning with the state",
        names_all_of_them);
  parameters.lowest_stretch  = 0.99;
  parameters.highest_stretch = 1.01;
  check("... but not near rest", stability_warning(parameters).empty());

  // Isotropic moduli: mu for shear waves, lambda + 2 mu for pressure waves.
  const NeoHookean law;
  Matrix identity{};
  for (int i = 0; i < 3; ++i)
    identity[i][i] = 1;
  const WaveModuli moduli =
    wave_moduli(material_tangent(law, identity, directions));
  check_relative("wave modulus of shear", moduli.smallest, law.mu, 1e-9);
  check_relative("wave modulus of pressure",
                 moduli.largest,
                 law.lambda + 2 * law.mu,
                 1e-9);
}

void
check_refusals()
{
  Fung law;
  law.b = {1, 2, 0, 1, 0, 1};
  check("Fung: negative eigenvalue of b refused",
        error_of([&]() { law.check(); }).find("negative eigenvalue") !=
          std::string::npos);
  law.b = {1, 1, 0, 1, 0, 1};
  check("Fung: singular b accepted",
        error_of([&]() { law.check(); }) == "none");
  law.b = {1, 1};
  check("Fung: wrong number of constants refused",
        error_of([&]() { law.check(); }).find("6 (planar) or 21") !=
          std::string::npos);
  SolidParameters parameters;
  parameters.material = "HGo";
  check("unknown material refused",
        error_of([&]() { parameters.check(); }).find("May-Newman-Yin") !=
          std::string::npos);
  check("negative stretch refused",
        error_of([&]() {
          stretched_sheet(NeoHookean(), -1, 1, sheet_directions(0));
        }).find("must be positive") != std::string::npos);
}

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  HolzapfelGasserOgden parallel;
  parallel.kappa = 0;
  MayNewmanYin with_matrix;
  with_matrix.C10 = 500;
  Ogden classical;
  classical.convention = "classical";
  check_law("HGO", HolzapfelGasserOgden(), true, 6);
  check_law("HGO, parallel fibres", parallel, true, 6);
  check_law("HGO, two families", two_families(), false, 6);
  check_law("Ogden Abaqus", Ogden(), true, 6);
  check_law("Ogden classical", classical, true, 6);
  check_law("neo-Hookean", NeoHookean(), true, 6);
  check_law("Fung", Fung(), false, 6);
  check_law("May-Newman-Yin", MayNewmanYin(), true, 6);
  check_law("May-Newman-Yin with matrix", with_matrix, true, 6);
  check_law("St Venant-Kirchhoff", SaintVenantKirchhoff(), true, 6);
  const Fung spatial = spatial_fung();
  check_derivatives("Fung 3D", spatial);
  check_frames("Fung 3D", spatial);
  check_energy("Fung 3D", spatial);
  check_bound("Fung 3D", spatial, 6);
  check_derivatives("tense fibres", TenseFibres());
  check_frames("tense fibres", TenseFibres());
  check_bound("tense fibres", TenseFibres(), 6);
  check_stability();
  check_refusals();
}
