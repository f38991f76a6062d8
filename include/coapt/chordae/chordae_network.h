#ifndef coapt_chordae_chordae_network_h
#define coapt_chordae_chordae_network_h

#include <coapt/chordae/chorda.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace coapt
{
  /**
   * All chordae of a valve: linear springs that carry tension only,
   *   T = max(0, E A (l/l0 - 1) + c dl/dt)  if l > l0, otherwise 0
   * (Millard et al., 2011), from the papillary tip to the weighted mean of
   * the attached nodes, with the damping
   *   c = 2 zeta sqrt(E A / l0 m),  m = 1 / sum(w^2 / nodal mass),
   * where m is the mass that a force on the weighted mean feels, reduced by
   * that of the other end if this is a node with a mass.
   *
   * A chorda that is shorter than its open length would start with a shock:
   * the rest length l0(t) shrinks smoothly (3 s^2 - 2 s^3) during the ramp
   * time, from the open length and 0.1 % if that is longer.
   *
   * Nodal arrays hold three entries a node, [3 * node + component].
   */
  class ChordaeNetwork
  {
  public:
    /**
     * Takes attached @p chordae, the @p nodal_mass (kg) of all nodes, the
     * @p ramp_time (s; zero: no ramp) and the @p damping_ratio zeta.
     *
     * @throws InputError if a chorda is attached to nothing, or has no
     * positive diameter, modulus or rest length.
     */
    ChordaeNetwork(const std::vector<Chorda> &chordae,
                   const std::vector<double> &nodal_mass,
                   const double ramp_time,
                   const double damping_ratio);

    /**
     * Adds to @p F (N) the forces of the chordae at time @p t (s), positions
     * @p X (m) and velocities @p V (m/s). The chorda number i is added by the
     * rank i % @p n_ranks alone.
     */
    void
    add_forces(const double t,
               const double *X,
               const double *V,
               double *F,
               const unsigned int rank,
               const unsigned int n_ranks) const;

    /** Tension of every chorda (N), damping included. */
    std::vector<double>
    tensions(const double t, const double *X, const double *V) const;

    /** Elastic energy of all chordae (J). */
    double
    elastic_energy(const double t, const double *X) const;

    /**
     * Power (W) that the damping of all chordae dissipates. The ramp of the
     * rest lengths does work too, which is not part of it.
     */
    double
    damping_power(const double t, const double *X, const double *V) const;

    /**
     * Power (W) that the shrinking rest lengths feed into the elastic energy:
     * -dE/dl0 dl0/dt, zero after the ramp.
     */
    double
    ramp_power(const double t, const double *X) const;

    /**
     * Largest undamped angular frequency (1/s) of a taut chorda against the
     * mass that it holds, a bound over the whole ramp. For trees, a bound by
     * the sums of rows of the stiffness (Gershgorin's theorem).
     */
    double
    max_frequency() const;

    /** Damping ratio zeta of all chordae at their rest length (-). */
    double
    damping_ratio() const
    {
      return zeta;
    }

    /** Weighted mean of the nodes of every chorda, and its other end (m). @{ */
    std::vector<dealii::Point<3>>
    attachment_points(const double *X) const;

    std::vector<dealii::Point<3>>
    origins(const double *X) const;
    /** @} */

    /** The chordae. */
    const std::vector<Chorda> &
    chordae() const;

  private:
    /** A chorda's line of action at one instant. */
    struct Pull
    {
      dealii::Tensor<1, 3> direction; ///< to the tip, of unit length
      double length;                  ///< l (m)
      double rate;                    ///< dl/dt (m/s)
      double rest_length;             ///< l0 (m)
      double elastic;                 ///< E A (l/l0 - 1), or 0 (N)
      double tension;                 ///< T (N)
    };

    /** Weighted mean of a nodal array. */
    static dealii::Tensor<1, 3>
    mean(const Chorda &chorda, const double *x);

    /** Where a chorda begins at the positions @p X (m). */
    static dealii::Point<3>
    origin(const Chorda &chorda, const double *X);

    /** Line of action of the chorda @p i; without @p V, no damping. */
    Pull
    pull(const unsigned int i,
         const double t,
         const double *X,
         const double *V) const;

    /** Rest length (m) at the start of the ramp. */
    double
    initial_rest_length(const Chorda &chorda) const;

    std::vector<Chorda> all_chordae;
    double ramp_time;
    double zeta;

    /** E A (N), c (N s/m) and the mass m (kg) of every chorda. */
    std::vector<double> axial_stiffness, damping, mass;
    double largest_square_frequency = 0; // 1/s^2
  };
} // namespace coapt

#endif
