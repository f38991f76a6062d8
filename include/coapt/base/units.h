#ifndef coapt_base_units_h
#define coapt_base_units_h

namespace coapt
{
  /**
   * Factors to SI: `5 * units::millimetre` is a length in m. Everything inside
   * the program is in SI; these are for reading parameters and for printing.
   */
  namespace units
  {
    constexpr double millimetre        = 1e-3;
    constexpr double square_millimetre = 1e-6;
    constexpr double millilitre        = 1e-6;
    constexpr double kilopascal        = 1e3;
    /** Conventional millimetre of mercury, 13595.1 kg/m^3 x 9.80665 m/s^2. */
    constexpr double mmHg   = 133.322387415;
    constexpr double degree = 3.14159265358979323846 / 180.;
  } // namespace units
} // namespace coapt

#endif
