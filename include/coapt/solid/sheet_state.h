#ifndef coapt_solid_sheet_state_h
#define coapt_solid_sheet_state_h

#include <coapt/solid/materials/material.h>
#include <coapt/solid/tangent.h>

#include <array>
#include <optional>

namespace coapt
{
  /** Directions of a sheet in the plane of the axes 1 and 2 whose fibres
   * include this angle (rad) with axis 1: fibre, across it, normal. */
  std::array<double, 9>
  sheet_directions(const double fibre_angle);

  /**
   * Homogeneous state of a thin sheet stretched along the axes 1 and 2, free
   * of stress along axis 3.
   */
  struct SheetState
  {
    /** Deformation gradient, diagonal. */
    SmallMatrix<3, double> F;

    /** First Piola-Kirchhoff stress (Pa). */
    SmallMatrix<3, double> P;
  };

  /**
   * The state at these stretches, with the thickness from Newton's method.
   *
   * @throws NumericalError if there is none, InputError if a stretch is not
   * positive.
   */
  SheetState
  stretched_sheet(const Material &material,
                  const double stretch_1,
                  const double stretch_2,
                  const std::array<double, 9> &directions);

  /** Tangent of a material of any type at the deformation gradient @p F. */
  MaterialTangent
  tangent_at(const Material &material,
             const SmallMatrix<3, double> &F,
             const std::array<double, 9> &directions);

  /** Derivative of the two normal stresses of a sheet to its two stretches, the
   * thickness being free (Pa). */
  SmallMatrix<2, double>
  tangent_in_plane(const MaterialTangent &tangent);

  /** Smaller eigenvalue of tangent_in_plane(), which is symmetric. */
  double
  smaller_eigenvalue(const SmallMatrix<2, double> &matrix);

  /**
   * The state under these first Piola-Kirchhoff @p stresses (Pa), by Newton's
   * method from the stretches @p begin. Nothing if that does not converge, or
   * to a state that is not stable under dead loads.
   */
  std::optional<SheetState>
  loaded_sheet(const Material &material,
               const std::array<double, 2> &stresses,
               const std::array<double, 9> &directions,
               const std::array<double, 2> &begin);

  /** Normal first Piola-Kirchhoff stresses (Pa) of the same sheet of
   * incompressible material, the pressure of which makes the stress along axis
   * 3 vanish; for numbers and batches. */
  template <typename Law, typename Number>
  std::array<Number, 2>
  incompressible_sheet(const Law &law,
                       const Number &stretch_1,
                       const Number &stretch_2,
                       const Number *directions)
  {
    SmallMatrix<3, Number> F{};
    F[0][0]               = stretch_1;
    F[1][1]               = stretch_2;
    F[2][2]               = 1. / (stretch_1 * stretch_2);
    const auto P          = law.first_piola(F, directions);
    const Number pressure = P[2][2] * F[2][2];
    return {{P[0][0] - pressure / stretch_1, P[1][1] - pressure / stretch_2}};
  }
} // namespace coapt

#endif
