#include <coapt/base/exceptions.h>
#include <coapt/solid/sheet_state.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace coapt
{
  namespace
  {
    double
    largest_entry(const MaterialTangent &A)
    {
      double largest = 0;
      for (const auto &row : A.entry)
        for (const double entry : row)
          largest = std::max(largest, std::abs(entry));
      return largest;
    }
  } // namespace



  std::array<double, 9>
  sheet_directions(const double fibre_angle)
  {
    const double c = std::cos(fibre_angle), s = std::sin(fibre_angle);
    return {{c, s, 0, -s, c, 0, 0, 0, 1}};
  }

  SheetState
  stretched_sheet(const Material &material,
                  const double stretch_1,
                  const double stretch_2,
                  const std::array<double, 9> &directions)
  {
    std::ostringstream name;
    name << "A sheet stretched by " << stretch_1 << " and " << stretch_2;
    if (!(stretch_1 > 0 && stretch_2 > 0))
      throw InputError(name.str() + ": stretches must be positive.");

    SheetState state{};
    state.F[0][0] = stretch_1;
    state.F[1][1] = stretch_2;
    double &l     = state.F[2][2];
    l             = 1 / (stretch_1 * stretch_2);
    for (unsigned int i = 0; i < 100; ++i)
      {
        std::visit(
          [&](const auto &law) {
            state.P = law.first_piola(state.F, directions.data());
          },
          material);
        const double slope  = tangent_at(material, state.F, directions)[8][8];
        const double change = state.P[2][2] / slope;
        if (!(slope > 0))
          break;
        if (std::abs(change) < 1e-14 * l)
          return state;
        l = change < 0.5 * l ? l - change : 0.5 * l;
      }
    throw NumericalError(name.str() +
                         " has no thickness at which the stress across it "
                         "vanishes.");
  }



  MaterialTangent
  tangent_at(const Material &material,
             const SmallMatrix<3, double> &F,
             const std::array<double, 9> &directions)
  {
    return std::visit(
      [&](const auto &law) {
        return material_tangent(law, F, directions.data());
      },
      material);
  }



  SmallMatrix<2, double>
  tangent_in_plane(const MaterialTangent &A)
  {
    SmallMatrix<2, double> K;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        K[i][j] = A[4 * i][4 * j] - A[4 * i][8] * A[8][4 * j] / A[8][8];
    return K;
  }



  double
  smaller_eigenvalue(const SmallMatrix<2, double> &K)
  {
    return (K[0][0] + K[1][1]) / 2 -
      std::hypot((K[0][0] - K[1][1]) / 2, K[0][1]);
  }



  std::optional<SheetState>
  loaded_sheet(const Material &material,
               const std::array<double, 2> &stresses,
               const std::array<double, 9> &directions,
               const std::array<double, 2> &begin)
  {
    auto stretch = begin;
    for (unsigned int iteration = 0; iteration < 100; ++iteration)
      {
        SheetState state{};
        try
          {
            state =
              stretched_sheet(material, stretch[0], stretch[1], directions);
          }
        catch (const NumericalError &)
          {
            return {};
          }
        const MaterialTangent A  = tangent_at(material, state.F, directions);
        SmallMatrix<2, double> K = tangent_in_plane(A);
        // Moduli below this are zero: a sheet without matrix is slack at rest.
        const double least   = 1e-6 * largest_entry(A);
        const double lacking = least - smaller_eigenvalue(K);
        double rest[2], error = 0;
        for (int i = 0; i < 2; ++i)
          {
            rest[i] = stresses[i] - state.P[i][i];
            error   = std::max(error, std::abs(rest[i]));
          }
        if (error < 1e-4 * least)
          return lacking <= 2 * least ? std::optional<SheetState>(state)
                                      : std::nullopt;
        if (lacking > 0)
          for (int i = 0; i < 2; ++i)
            K[i][i] += lacking;
        const double D = K[0][0] * K[1][1] - K[0][1] * K[1][0];
        double change[2], largest = 0;
        for (int i = 0; i < 2; ++i)
          {
            const int j = 1 - i;
            change[i]   = (K[j][j] * rest[i] - K[i][j] * rest[j]) / D;
            largest     = std::max(largest, std::abs(change[i] / stretch[i]));
          }
        if (!std::isfinite(largest))
          return {};
        for (int i = 0; i < 2; ++i)
          stretch[i] += change[i] * std::min(1., 0.2 / largest);
      }
    return {};
  }
} // namespace coapt
