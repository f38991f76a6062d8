#ifndef coapt_solid_stability_h
#define coapt_solid_stability_h

#include <coapt/base/log.h>
#include <coapt/solid/solid_parameters.h>
#include <coapt/solid/tangent.h>

#include <optional>
#include <string>

namespace coapt
{
  /** Smallest and largest modulus (Pa) of plane waves: eigenvalues of the
   * acoustic tensor A_ijkl n_j n_l over all directions n in the reference. The
   * wave speed is the root of modulus over density. */
  struct WaveModuli
  {
    double smallest, largest;
  };

  /** Over @p n_directions directions, evenly spread over half a sphere. */
  WaveModuli
  wave_moduli(const MaterialTangent &tangent,
              const unsigned int n_directions = 200);

  /** Largest modulus of a plane wave in the @p material at rest (Pa). */
  double
  largest_wave_modulus_at_rest(const Material &material);

  /** A state of a thin sheet (SheetState) in which its tangent is not
   * positive. */
  struct Instability
  {
    double along_fibre, across; ///< stretches
    double modulus;             ///< the negative one (Pa)
    std::string what;           ///< kind of the modulus
  };

  /**
   * The state nearest to rest in which the @p material loses positivity, among
   * @p n x @p n stretches between @p lowest and @p highest along the fibres and
   * across them: either a plane wave has a negative modulus (the equations of
   * motion lose hyperbolicity), or the stress in the plane falls while the
   * stretches grow.
   */
  std::optional<Instability>
  first_instability(const Material &material,
                    const double lowest,
                    const double highest,
                    const unsigned int n = 21);

  /** A text that warns of first_instability() in the range that the parameters
   * give; empty if there is none. */
  std::string
  stability_warning(const SolidParameters &parameters);

  /** Puts it into the @p log. */
  void
  warn_if_unstable(const SolidParameters &parameters, Log &log);
} // namespace coapt

#endif
