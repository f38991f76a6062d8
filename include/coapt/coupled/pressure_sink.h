#ifndef coapt_coupled_pressure_sink_h
#define coapt_coupled_pressure_sink_h

namespace coapt
{
  /** Something that takes fluid out of cells, or puts it in. */
  class PressureSink
  {
  public:
    virtual ~PressureSink() = default;

    /** Adds to the pressure rates (Pa/s) of this rank's cells. */
    virtual void
    add_rate(const double *pressure, double *pressure_rate) = 0;

    /** Power (W) that it takes out of the fluid of this rank's cells. */
    virtual double
    power(const double *pressure) const = 0;
  };
} // namespace coapt

#endif
