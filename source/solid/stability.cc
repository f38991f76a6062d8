#include <coapt/base/exceptions.h>
#include <coapt/solid/sheet_state.h>
#include <coapt/solid/stability.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace coapt
{
  WaveModuli
  wave_moduli(const MaterialTangent &A, const unsigned int n_directions)
  {
    const double golden = 3.14159265358979323846 * (3 - std::sqrt(5.));
    WaveModuli moduli   = {std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::lowest()};
    for (unsigned int d = 0; d < n_directions + 3; ++d)
      {
        // the axes, and a spiral
        double n[3] = {d == 0 ? 1. : 0., d == 1 ? 1. : 0., d == 2 ? 1. : 0.};
        if (d > 2)
          {
            const double z = (d - 2.5) / n_directions;
            const double r = std::sqrt(1 - z * z);
            n[0]           = r * std::cos(golden * d);
            n[1]           = r * std::sin(golden * d);
            n[2]           = z;
          }
        SmallMatrix<3, double> Q{}, vectors;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
              for (int l = 0; l < 3; ++l)
                Q[i][j] += A[3 * i + k][3 * j + l] * n[k] * n[l];
        diagonalise(Q, vectors);
        for (int i = 0; i < 3; ++i)
          {
            moduli.smallest = std::min(moduli.smallest, Q[i][i]);
            moduli.largest  = std::max(moduli.largest, Q[i][i]);
          }
      }
    return moduli;
  }

  double
  largest_wave_modulus_at_rest(const Material &material)
  {
    SmallMatrix<3, double> rest{};
    for (int i = 0; i < 3; ++i)
      rest[i][i] = 1;
    const auto directions = sheet_directions(0);
    return std::visit(
      [&](const auto &law) {
        return wave_moduli(material_tangent(law, rest, directions.data()))
          .largest;
      },
      material);
  }



  namespace
  {
    std::optional<Instability>
    instability_at(const Material &material,
                   const double along_fibre,
                   const double across)
    {
      const auto directions = sheet_directions(0);
      MaterialTangent A{};
      try
        {
          const SheetState state =
            stretched_sheet(material, along_fibre, across, directions);
          A = tangent_at(material, state.F, directions);
        }
      catch (const NumericalError &)
        {
          return Instability{along_fibre,
                             across,
                             std::nan(""),
                             "there is no thickness free of stress"};
        }
      double largest = 0;
      for (const auto &row : A.entry)
        for (const double entry : row)
          largest = std::max(largest, std::abs(entry));
      // Zero moduli, such as of fibres without matrix, are no instability.
      const double tolerance = 1e-6 * largest;
      const double wave      = wave_moduli(A).smallest;
      if (!(wave >= -tolerance))
        return Instability{along_fibre,
                           across,
                           wave,
                           "modulus of a plane wave"};
      const double plane = smaller_eigenvalue(tangent_in_plane(A));
      if (!(plane >= -tolerance))
        return Instability{along_fibre,
                           across,
                           plane,
                           "stiffness in the plane"};
      return {};
    }
  } // namespace

  std::optional<Instability>
  first_instability(const Material &material,
                    const double lowest,
                    const double highest,
                    const unsigned int n)
  {
    std::optional<Instability> nearest;
    double distance = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          const double along  = lowest + (highest - lowest) * i / (n - 1);
          const double across = lowest + (highest - lowest) * j / (n - 1);
          const double here   = std::hypot(std::log(along), std::log(across));
          if (here >= distance)
            continue;
          const auto found = instability_at(material, along, across);
          if (found)
            {
              nearest  = found;
              distance = here;
            }
        }
    return nearest;
  }

  std::string
  stability_warning(const SolidParameters &parameters)
  {
    if (!(parameters.lowest_stretch < parameters.highest_stretch))
      return "";
    const auto found = first_instability(parameters.selected_material(),
                                         parameters.lowest_stretch,
                                         parameters.highest_stretch);
    if (!found)
      return "";
    std::ostringstream message;
    message.precision(4);
    message << "the tangent of the material " << parameters.material
            << " loses positivity at the stretches " << found->along_fibre
            << " along the fibres and " << found->across << " across them ("
            << found->what;
    if (std::isfinite(found->modulus))
      message << " " << found->modulus << " Pa";
    message << "); examined are " << parameters.lowest_stretch << " to "
            << parameters.highest_stretch;
    return message.str();
  }

  void
  warn_if_unstable(const SolidParameters &parameters, Log &log)
  {
    const std::string text = stability_warning(parameters);
    if (!text.empty())
      log.warn("tangent of " + parameters.material, text);
  }
} // namespace coapt
