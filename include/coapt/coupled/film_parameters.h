#ifndef coapt_coupled_film_parameters_h
#define coapt_coupled_film_parameters_h

#include <deal.II/base/parameter_handler.h>

namespace coapt
{
  /** Parameters of the film of fluid between leaflets that the fluid cells do
   * not resolve (subsection "Film"). */
  struct FilmParameters
  {
    /** Whether films are released and drained. */
    bool drains = false;

    /** A film is treated fully below the first and not at all above the second
     * of these widths, in units of the finest fluid cell. */
    double treated_width = 1.5;
    double largest_width = 2.;

    /** Fractional rate of drainage for each Pa above the atrial pressure
     * (1/(Pa s)). */
    double drainage = 0.028;

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them; throws InputError if the widths are not in order. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
