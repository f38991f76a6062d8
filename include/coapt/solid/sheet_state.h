#ifndef coapt_solid_sheet_state_h
#define coapt_solid_sheet_state_h

#include <coapt/solid/materials/material.h>

#include <array>

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
