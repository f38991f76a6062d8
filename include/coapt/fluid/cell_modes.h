#ifndef coapt_fluid_cell_modes_h
#define coapt_fluid_cell_modes_h

#include <coapt/base/eight_doubles.h>

#include <cmath>

namespace coapt
{
  namespace internal
  {
    /** x = sqrt(x). */
    inline void
    take_square_root(double &x)
    {
      x = std::sqrt(x);
    }

    /** The same for eight numbers. */
    inline void
    take_square_root(EightDoubles &x)
    {
#ifdef __AVX512F__
      x = (EightDoubles)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#else
      for (int lane = 0; lane < 8; ++lane)
        x[lane] = std::sqrt(x[lane]);
#endif
    }

    /**
     * Replaces the values at a cell's corners (deal.II's vertex order) by
     * their modes m_S = sum_i s_S(i) v_i, where bit d of S tells whether the
     * mode alternates in direction d: m_0 is 2^dim times the mean,
     * m_{1<<d} is 2^{dim-1} h times the mean derivative in direction d, the
     * others are the hourglass modes.
     */
    template <int dim, typename Number>
    inline __attribute__((always_inline)) void
    corners_to_modes(Number *v)
    {
#pragma GCC unroll 3
      for (int bit = 1; bit < (1 << dim); bit *= 2)
#pragma GCC unroll 8
        for (int i = 0; i < (1 << dim); ++i)
          if (!(i & bit))
            {
              const Number lower = v[i], upper = v[i + bit];
              v[i]       = upper + lower;
              v[i + bit] = upper - lower;
            }
    }

    /** The adjoint of corners_to_modes(): v_i = sum_S s_S(i) m_S. */
    template <int dim, typename Number>
    inline __attribute__((always_inline)) void
    modes_to_corners(Number *m)
    {
#pragma GCC unroll 3
      for (int bit = 1; bit < (1 << dim); bit *= 2)
#pragma GCC unroll 8
        for (int i = 0; i < (1 << dim); ++i)
          if (!(i & bit))
            {
              const Number even = m[i], odd = m[i + bit];
              m[i]       = even - odd;
              m[i + bit] = even + odd;
            }
    }

    /** Whether a mode alternates in two or more directions. */
    constexpr bool
    is_hourglass(const int mode)
    {
      return (mode & (mode - 1)) != 0;
    }

    /** Constants of the cell forces, see FluidParameters. */
    struct CellCoefficients
    {
      double viscosity;            // Pa s
      double artificial_viscosity; // rho times the coefficient, kg/m^3
      double hourglass;            // rho s, kg/(m^2 s)
      double convection;           // rho, or 0 without convection, kg/m^3
      double bulk_modulus;         // rho c^2, Pa
    };

    /** Effective viscosity mu + a rho h |u| of a cell with mean velocity
     * m_c / 2^dim, where m are the zeroth modes. */
    template <int dim, typename Number>
    inline __attribute__((always_inline)) void
    effective_viscosity(const Number (&u)[dim][1 << dim],
                        const Number &h,
                        const CellCoefficients &k,
                        Number &viscosity)
    {
      Number speed = u[0][0] * u[0][0];
      for (int c = 1; c < dim; ++c)
        speed += u[c][0] * u[c][0];
      take_square_root(speed);
      viscosity =
        k.viscosity + (k.artificial_viscosity / (1 << dim)) * h * speed;
    }

    /**
     * Forces on the corners of a cube of size @p h (N) and the rate of its
     * pressure (Pa/s). On input @p u holds the *modes* of the velocity
     * components, on output the modes of the forces, to be turned into nodal
     * forces by modes_to_corners().
     *
     * Gradients are integrated by their mean (one-point quadrature; exact for
     * the pressure term). With mean velocity U, mean gradient G_cd = d_d u_c,
     * volume V the nodal forces are
     *
     *   f_ic = V d_d N_i (p delta_cd - mu G_cd + rho U_c U_d / 2)
     *          - V N_i rho U_d G_cd / 2 - hourglass damping.
     *
     * The two convective parts are -[rho u.grad u + div(rho u u)]/2, tested
     * with u they cancel in every cell, so convection does no work.
     */
    template <int dim, typename Number>
    inline __attribute__((always_inline)) void
    cell_forces(Number (&u)[dim][1 << dim],
                const Number &p,
                const Number &h,
                const CellCoefficients &k,
                Number &pressure_rate)
    {
      constexpr int n_modes  = 1 << dim;
      constexpr double mean  = 1. / n_modes;
      const Number half      = 0.5 * h;
      const Number face      = (dim == 3) ? half * half : half;
      const Number slope     = (2 * mean) / h;
      const Number hourglass = (-0.5 * mean * k.hourglass) * face;
      const Number force     = (-0.5 * mean * k.convection) * face;

      Number viscosity;
      effective_viscosity<dim>(u, h, k, viscosity);
      const Number viscous = viscosity * slope;
      Number U[dim], divergence = u[0][1];
      for (int c = 0; c < dim; ++c)
        U[c] = mean * u[c][0];
      for (int d = 1; d < dim; ++d)
        divergence += u[d][1 << d];
      pressure_rate = -k.bulk_modulus * slope * divergence;

#pragma GCC unroll 3
      for (int c = 0; c < dim; ++c)
        {
          const Number momentum = (0.5 * k.convection) * U[c];
          Number transport      = U[0] * u[c][1];
#pragma GCC unroll 3
          for (int d = 1; d < dim; ++d)
            transport += U[d] * u[c][1 << d];
#pragma GCC unroll 3
          for (int d = 0; d < dim; ++d)
            {
              Number stress = momentum * U[d] - viscous * u[c][1 << d];
              if (c == d)
                stress += p;
              u[c][1 << d] = face * stress;
            }
#pragma GCC unroll 8
          for (int s = 0; s < n_modes; ++s)
            if (is_hourglass(s))
              u[c][s] *= hourglass;
          u[c][0] = force * transport;
        }
    }
  } // namespace internal
} // namespace coapt

#endif
