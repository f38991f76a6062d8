#ifndef coapt_fluid_fluid_parameters_h
#define coapt_fluid_fluid_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * Material and stabilisation of the weakly compressible fluid. All values
   * in SI units. The stabilisation terms, their scaling and their defaults
   * are those of explicit hydrocodes for the Q1/P0 pair (Flanagan and
   * Belytschko 1981 for the hourglass damping).
   */
  struct FluidParameters
  {
    /** Density rho (kg/m^3). */
    double density = 1060;

    /** Dynamic viscosity mu (Pa s). */
    double viscosity = 2e-3;

    /**
     * Sound speed c (m/s), p' = -rho c^2 div u. 1450 is blood; 50 changes the
     * density by 0.6 % at 16 kPa and allows steps that are 29 times longer.
     */
    double sound_speed = 50;

    /**
     * Speed s (m/s) of the hourglass damping. Each hourglass mode Gamma
     * of a cell of size h exerts -(rho s h^{dim-1} / 4^dim) Gamma (Gamma . u),
     * which lets the mode decay at the rate s/h in the interior. It is a
     * fixed speed rather than a fraction of c, so that the damping does not
     * grow with the sound speed.
     */
    double hourglass_speed = 1;

    /** Checkerboard filter: alternating pressures of sibling cells decay
     * at the rate checkerboard * c/h (dimensionless). */
    double checkerboard = 0.25;

    /** Artificial viscosity in units of rho h |u| (dimensionless). */
    double artificial_viscosity = 0.1;

    /** Whether the convective term is included. */
    bool convection = true;

    /** Declares the parameters in the subsection "Fluid". */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads the parameters from the subsection "Fluid". */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
