#include <coapt/base/exceptions.h>
#include <coapt/solid/materials/ogden.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <sstream>

namespace coapt
{
  namespace
  {
    std::vector<double>
    numbers(const std::string &list)
    {
      return dealii::Utilities::string_to_double(
        dealii::Utilities::split_string_list(list));
    }
  } // namespace

  void
  Ogden::declare_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Ogden");
    prm.declare_entry("Convention",
                      "Abaqus",
                      Selection("Abaqus|classical"),
                      "Meaning of the coefficients: the weight of the i-th "
                      "term is 2 mu_i/alpha_i^2 (Abaqus) or mu_i/alpha_i "
                      "(classical).");
    prm.declare_entry("Mu",
                      "0.002, 1010.038, 1230.418",
                      List(Double(), 1),
                      "Coefficients mu_i (Pa), separated by commas. The "
                      "default is fitted to a posterior leaflet. The set "
                      "-481836.3, 484166.6, 742.8 replaces HGO without "
                      "fibre direction.");
    prm.declare_entry("Alpha",
                      "63.659, 9.471, 22.412",
                      List(Double(), 1),
                      "Exponents alpha_i (-), as many as mu_i. To the "
                      "set -481836.3, 484166.6, 742.8 belong -19.4, -19.3, "
                      "-25.");
    prm.declare_entry("Bulk factor",
                      "200",
                      Double(1e-3, 1e9),
                      "Bulk modulus over the initial shear modulus "
                      "(-).");
    prm.leave_subsection();
  }

  void
  Ogden::parse_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Ogden");
    convention  = prm.get("Convention");
    mu          = numbers(prm.get("Mu"));
    alpha       = numbers(prm.get("Alpha"));
    bulk_factor = prm.get_double("Bulk factor");
    prm.leave_subsection();
    check();
  }

  void
  Ogden::check() const
  {
    std::ostringstream message;
    if (convention != "Abaqus" && convention != "classical")
      message << "the convention is \"" << convention
              << "\", allowed are Abaqus and classical";
    else if (mu.empty() || mu.size() != alpha.size())
      message << mu.size() << " values of mu and " << alpha.size()
              << " of alpha are given, there must be as many of both, at "
                 "least one";
    else
      {
        for (const double a : alpha)
          if (a == 0)
            message << "an exponent alpha is zero, which is not allowed; ";
        if (message.str().empty() && !(shear_modulus() > 0))
          message << "the initial shear modulus is " << shear_modulus()
                  << " Pa in the convention " << convention
                  << ", it must be positive";
        else if (message.str().empty() && !(bulk_factor > 0))
          message << "the bulk factor is " << bulk_factor
                  << ", it must be positive";
      }
    if (!message.str().empty())
      throw InputError("Material Ogden: " + message.str() +
                       " (subsection Solid/Ogden).");
  }
} // namespace coapt
