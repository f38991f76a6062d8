#ifndef coapt_flow_signal_h
#define coapt_flow_signal_h

#include <vector>

namespace coapt
{
  /** Figures of a signal over a window of time. */
  struct SignalFigures
  {
    double mean, least, largest;

    /** Mean rate (1/s) at which the signal rises through its mean, from the
     * first to the last such crossing; not a number with fewer than
     * two of them, or if the signal is steady: its range is less than 1 % of
     * its largest magnitude. */
    double frequency;
  };

  /** Figures of the samples @p values at @p times (s, increasing) from the
   * time @p from on; of the last sample alone if it is earlier. The mean is
   * that of the trapezoidal rule. */
  SignalFigures
  signal_figures(const std::vector<double> &times,
                 const std::vector<double> &values,
                 const double from);
} // namespace coapt

#endif
