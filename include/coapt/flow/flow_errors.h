#ifndef coapt_flow_flow_errors_h
#define coapt_flow_flow_errors_h

#include <limits>

namespace coapt
{
  template <int dim>
  class FlowModel;

  /** Differences between a computed and the exact flow; not a number where
   * no exact solution is given. */
  struct FlowErrors
  {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    /** L2 norm (m/s times the root of the volume) and maximum (m/s) of the
     * error of the velocity. @{ */
    double velocity_l2  = unknown;
    double velocity_max = unknown;
    /** @} */

    /** L2 norm of the error of the piecewise constant pressure; it falls at
     * best with the first power of the cell size. */
    double pressure_l2 = unknown;

    /** L2 norm of the error of the cells' mean pressures. */
    double pressure_means_l2 = unknown;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &velocity_l2 &velocity_max &pressure_l2 &pressure_means_l2;
    }

    /** Replaces each error by the one of @p other if that is larger. */
    void
    take_larger(const FlowErrors &other);
  };

  /**
   * The errors of the state @p y, integrated with three Gauss points in each
   * direction; the maximum is over these points. Where no side gives the
   * pressure, its mean error is not counted. Collective.
   */
  template <int dim>
  FlowErrors
  flow_errors(const FlowModel<dim> &model, const double time, const double *y);
} // namespace coapt

#endif
