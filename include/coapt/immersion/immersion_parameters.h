#ifndef coapt_immersion_immersion_parameters_h
#define coapt_immersion_immersion_parameters_h

#include <coapt/base/log.h>

#include <deal.II/base/parameter_handler.h>

namespace coapt
{
  /** Parameters of the immersed coupling (subsection "Coupling"). */
  struct ImmersionParameters
  {
    /** Largest distance between coupling points over the fluid cell size. */
    double spacing = 0.75;

    /** In-plane stretch of the leaflet that the spacing allows for. */
    double expected_stretch = 1.3;

    /** Least number of layers of coupling points through the thickness. */
    unsigned int min_layers = 2;

    /** Relaxation time of the multiplier over the time step. */
    double relaxation_steps = 2.;

    /** Largest relaxation time (s), for a valve at the largest pressure;
     * bounds the leak, which grows with its square, and with it the step. */
    double max_relaxation_time = 16e-6;

    /** Damping ratio zeta of the relaxed constraint. */
    double damping_ratio = 0.5;

    /**
     * Largest stable ratio of the solid mass that is coupled to a fluid node
     * to the mass of that node (-). With r this ratio and s that of the
     * densities, the difference of the velocities there decays at the rate
     * G = 2 zeta/tau (1 + r) 2/(1 + s), which the integrator bears up to
     * G dt = 2.5 (real axis of the Kinnmark-Gray 5(3) table).
     * @p density_ratio is s, solid over fluid.
     */
    double
    largest_mass_ratio(const double density_ratio) const;

    /** Warns @p log of a @p mass_ratio above largest_mass_ratio(). */
    void
    warn_of_mass(const double mass_ratio,
                 const double density_ratio,
                 Log &log) const;

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

  /**
   * Coefficients of the relaxed multiplier: lambda' = k (v - J u),
   * f = lambda + beta (v - J u). Where a point is released from the fluid, its
   * multiplier decays at the rate 1/tau.
   */
  struct RelaxationCoefficients
  {
    double stiffness = 0; // k, Pa/m^2
    double drag      = 0; // beta, Pa s/m^2
    double decay     = 0; // 1/tau, 1/s
  };

  /**
   * k = rho* / tau^2 and beta = 2 zeta rho* / tau with the harmonic mean
   * rho* = 2 rho_s rho_f / (rho_s + rho_f), so that the constraint behaves as
   * an oscillator of damping ratio zeta and period of the order of tau.
   * Densities in kg/m^3, @p tau in s.
   */
  RelaxationCoefficients
  relaxation_coefficients(const double solid_density,
                          const double fluid_density,
                          const double tau,
                          const double damping_ratio);
} // namespace coapt

#endif
