#ifndef coapt_time_step_control_h
#define coapt_time_step_control_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace coapt
{
  /** Parameters of the step length (in subsection "Time"). */
  struct StepParameters
  {
    /** Step over the smallest stability limit. */
    double safety = 0.8;

    /** Largest step (s). */
    double max_step = 1e-4;

    /** Steps between two evaluations of the limits. */
    unsigned int interval = 10;

    /** Steps between two samples of the flow and of the powers. */
    unsigned int sampling = 20;

    /** Declares the parameters. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

  /** The step length that one part of the computation allows (s). */
  struct StepLimit
  {
    std::string part;
    double length;
  };

  /**
   * Length of the next step: a safe fraction of the smallest limit, falling at
   * once and growing slowly, since the relaxed multiplier follows the step.
   */
  class StepControl
  {
  public:
    explicit StepControl(const StepParameters &parameters);

    /** Takes new @p limits; throws NumericalError if one of them is not a
     * positive number. */
    void
    update(const std::vector<StepLimit> &limits);

    /** Step length (s), shortened a little so that whole steps end after
     * @p time_left (s). */
    double
    step(const double time_left) const;

    /** The part that sets the step. */
    const std::string &
    limiter() const
    {
      return limiting_part;
    }

    /** Saves or restores the length and its reason. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &length &limiting_part;
    }

  private:
    StepParameters parameters;
    double length = 0;
    std::string limiting_part;
  };
} // namespace coapt

#endif
