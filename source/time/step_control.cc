#include <coapt/base/exceptions.h>
#include <coapt/time/step_control.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  void
  StepParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;
    prm.enter_subsection("Time");
    prm.declare_entry("Step safety",
                      "0.8",
                      Double(0.01, 1.),
                      "Step length over the smallest stability limit (-).");
    prm.declare_entry("Largest step",
                      "1e-4",
                      Double(1e-12, 1.),
                      "Upper bound of the step length (s).");
    prm.declare_entry("Steps between limits",
                      "10",
                      Integer(1, 1000),
                      "Steps between two evaluations of the stability limits "
                      "(-).");
    prm.declare_entry("Steps between samples",
                      "20",
                      Integer(1, 1000),
                      "Steps between two samples of the flow and of the "
                      "powers, which are integrated over time (-).");
    prm.leave_subsection();
  }



  void
  StepParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    safety   = prm.get_double("Step safety");
    max_step = prm.get_double("Largest step");
    interval = prm.get_integer("Steps between limits");
    sampling = prm.get_integer("Steps between samples");
    prm.leave_subsection();
  }



  StepControl::StepControl(const StepParameters &parameters)
    : parameters(parameters)
  {
  }



  void
  StepControl::update(const std::vector<StepLimit> &limits)
  {
    double smallest  = parameters.max_step;
    std::string part = "largest step";
    for (const StepLimit &limit : limits)
      {
        if (!(limit.length > 0))
          throw NumericalError("the step limit of the " + limit.part + " is " +
                               std::to_string(limit.length) + " s");
        if (parameters.safety * limit.length < smallest)
          {
            smallest = parameters.safety * limit.length;
            part     = limit.part;
          }
      }
    const double largest_growth = 1.02;
    length =
      length > 0 ? std::min(smallest, largest_growth * length) : smallest;
    limiting_part = part;
  }



  double
  StepControl::step(const double time_left) const
  {
    // Equal steps rather than whole ones and a short one, which would stiffen
    // the relaxed multiplier for a moment.
    const double n_steps = std::ceil(time_left / length * (1 - 1e-9));
    return time_left / std::max(1., n_steps);
  }
} // namespace coapt
