#ifndef coapt_contact_pressure_law_h
#define coapt_contact_pressure_law_h

#include <coapt/contact/contact_parameters.h>

#include <vector>

namespace coapt
{
  /**
   * The pressure of contact as a function of the penetration, which is the
   * clearance minus the gap: linear pieces, so that one bound of the slope, by
   * the time step, serves every law. The exponential law
   *
   *   p = p0 s (exp(s) - 1)/(e - 1),  s = penetration / clearance,
   *
   * with the pressure p0 where surfaces touch, begins with zero slope and is
   * cut into pieces (as in common finite-element programs, for example
   * Abaqus' "softened" contact).
   */
  class PressureLaw
  {
  public:
    /** Throws InputError if the table is not one, or if the exponential law
     * has no clearance to act in. */
    explicit PressureLaw(const ContactParameters &parameters);

    /** Pressure (Pa) and its slope (Pa/m). */
    struct Value
    {
      double pressure = 0;
      double slope    = 0;
    };

    /** The law at a @p penetration (m); no piece of it is steeper than
     * @p largest_slope (Pa/m). */
    Value
    operator()(const double penetration, const double largest_slope) const;

  private:
    struct Piece
    {
      double begin; // penetration, m
      double slope; // Pa/m
    };

    void
    add_exponential(const ContactParameters &parameters);

    void
    add_table(const ContactParameters &parameters);

    std::vector<Piece> pieces;
  };
} // namespace coapt

#endif
