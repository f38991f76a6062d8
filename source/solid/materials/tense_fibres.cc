#include <coapt/base/exceptions.h>
#include <coapt/solid/materials/tense_fibres.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace coapt
{
  void
  TenseFibres::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Tense fibres");
    prm.declare_entry("Tension",
                      std::to_string(TenseFibres().mu),
                      dealii::Patterns::Double(1e-6, 1e12),
                      "Tension mu of the fibres at no stretch (Pa).");
    prm.leave_subsection();
  }

  void
  TenseFibres::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Tense fibres");
    mu = prm.get_double("Tension");
    prm.leave_subsection();
    check();
  }

  void
  TenseFibres::check() const
  {
    if (!(mu > 0))
      throw InputError("Material tense fibres: the tension is " +
                       std::to_string(mu) +
                       " Pa, it must be positive (subsection "
                       "Solid/Tense fibres).");
  }
} // namespace coapt
