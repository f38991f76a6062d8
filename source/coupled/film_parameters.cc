#include <coapt/base/exceptions.h>
#include <coapt/coupled/film_parameters.h>

namespace coapt
{
  using dealii::Patterns::Double;

  void
  FilmParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Film");
    prm.declare_entry("Drainage",
                      "false",
                      dealii::Patterns::Bool(),
                      "Whether fluid that is trapped between leaflets in films "
                      "thinner than the cells is let go, so that contact and "
                      "not the film carries the load.");
    prm.declare_entry("Treated width",
                      "1.5",
                      Double(0., 2.),
                      "Films below this width are treated fully (in units of "
                      "the finest fluid cell).");
    prm.declare_entry("Largest width",
                      "2",
                      Double(0., 3.),
                      "Films above this width are left alone (in units of the "
                      "finest fluid cell).");
    prm.declare_entry("Rate",
                      "0.028",
                      Double(0., 1.),
                      "Part of a film's fluid that drains each second for each "
                      "pascal above the atrial pressure (1/(Pa s)).");
    prm.leave_subsection();
  }



  void
  FilmParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Film");
    drains        = prm.get_bool("Drainage");
    treated_width = prm.get_double("Treated width");
    largest_width = prm.get_double("Largest width");
    drainage      = prm.get_double("Rate");
    prm.leave_subsection();
    if (!(treated_width < largest_width))
      throw InputError(
        "Film: Treated width is " + std::to_string(treated_width) +
        ", but must be below Largest width, " + std::to_string(largest_width));
  }
} // namespace coapt
