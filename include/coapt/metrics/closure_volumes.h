#ifndef coapt_metrics_closure_volumes_h
#define coapt_metrics_closure_volumes_h

#include <coapt/metrics/leaflet_monitor.h>

#include <functional>
#include <vector>

namespace coapt
{
  /** Whether and when a valve has closed, and the volume (m^3) that has left
   * the ventricle by then. */
  struct Closing
  {
    bool closed   = false;
    double time   = 0; // s
    double volume = 0;
  };

  /** Flows (m^3/s) past closed leaflets, by their ways: through gaps between
   * them, which is real, and through the tissue and by drainage of the films
   * between leaflets, which are errors of the method. */
  struct Leak
  {
    double gaps    = 0;
    double tissue  = 0;
    double drained = 0;

    double
    total() const
    {
      return gaps + tissue + drained;
    }
  };

  /** Volume (m^3) that has left the ventricle since the start: out of the
   * atrial end, and drained from films. */
  double
  volume_out(const ValveSample &sample);

  /** What of it has passed the leaflets, instead of being pushed by them. */
  double
  volume_past_leaflets(const ValveSample &sample);

  /** Flow (m^3/s) through a plane without what the leaflets sweep: what passes
   * them, if the plane does not cut them and its normal points to the atrium.
   * What is drained between the leaflets passes no plane. */
  double
  plane_flow_less_swept(const ValveSample &sample, const unsigned int plane);

  /** Closing is at the first of the samples from which on the widest path of
   * all is narrower than @p shut_width (m). */
  Closing
  closing(const std::vector<ValveSample> &samples, const double shut_width);

  /** Mean of a figure over the last @p window (s) of the samples, by the
   * trapezoidal rule; not-a-number if there is no time between them. */
  double
  window_mean(const std::vector<ValveSample> &samples,
              const double window,
              const std::function<double(const ValveSample &)> &figure);

  /** Mean leak over the last @p window (s) of the samples; not-a-number if
   * there is no time between them. */
  Leak
  mean_leak(const std::vector<ValveSample> &samples, const double window);

  /** Volume (m^3) that has passed the leaflets since they met: since closing,
   * or, in a valve that has not closed, since the outflow has fallen to a
   * tenth of its peak; not-a-number if it has not. */
  double
  regurgitant_volume(const std::vector<ValveSample> &samples,
                     const Closing &closing);
} // namespace coapt

#endif
