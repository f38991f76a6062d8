#ifndef coapt_chordae_chordae_parameters_h
#define coapt_chordae_chordae_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** Behaviour common to all chordae: the subsection "Chordae". */
  struct ChordaeParameters
  {
    /** Time in which rest lengths shrink from the open lengths (s). */
    double ramp_time = 10e-3;

    /** Damping ratio of each chorda against the mass it holds. */
    double damping_ratio = 0.2;

    /** Declares the subsection "Chordae". */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads it. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
