#ifndef coapt_flow_flow_sampler_h
#define coapt_flow_flow_sampler_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace coapt
{
  template <int dim>
  class FlowModel;

  /** A flow at points. */
  template <int dim>
  struct FlowSamples
  {
    std::vector<dealii::Tensor<1, dim>> velocity; // m/s
    std::vector<double> pressure;                 // Pa
  };

  /**
   * Velocity and pressure of the state @p y at @p points (m) of the box. The
   * pressure is averaged over the fluid cells around each node, weighted by
   * volume, and then interpolated like the velocity. All ranks get all
   * values. Throws InputError if a point is outside the box. Collective.
   */
  template <int dim>
  FlowSamples<dim>
  sample_flow(const FlowModel<dim> &model,
              const double *y,
              const std::vector<dealii::Point<dim>> &points);

  /** A component of the velocity that is known at a point. */
  template <int dim>
  struct ReferenceValue
  {
    dealii::Point<dim> point; // m
    unsigned int component;
    double value; // m/s
  };

  /** Reads lines "x, y[, z], component, value"; lines that begin with # and
   * a header are skipped. Throws InputError with file and line. */
  template <int dim>
  std::vector<ReferenceValue<dim>>
  read_reference_values(const std::string &file);
} // namespace coapt

#endif
