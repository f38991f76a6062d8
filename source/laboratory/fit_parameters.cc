#include <coapt/base/exceptions.h>
#include <coapt/laboratory/fit_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <cmath>

namespace coapt
{
  using namespace dealii;

  void
  FitParameters::declare_parameters(ParameterHandler &prm)
  {
    const FitParameters defaults;
    prm.enter_subsection("Fit");
    prm.declare_entry("Data",
                      defaults.data_file,
                      Patterns::FileName(),
                      "Table of a biaxial test, with the columns protocol, "
                      "stretch1, stretch2, stress1, stress2 (without a line "
                      "of names: in this order), the fibres along direction "
                      "1. The file is looked for beside the parameter file, "
                      "then among those that come with the program, and as it "
                      "stands.");
    prm.declare_entry("Stress measure",
                      "first Piola",
                      Patterns::Selection("first Piola|second Piola|Cauchy"),
                      "Which stress the data are.");
    prm.declare_entry("Stress unit",
                      defaults.unit,
                      Patterns::Selection("Pa|kPa|MPa"),
                      "Unit of the stress.");
    prm.declare_entry("Materials",
                      "HGO",
                      Patterns::MultipleSelection(
                        "HGO|Fung|Ogden|May-Newman-Yin"),
                      "Materials to fit, one after the other. Fung is planar "
                      "and without shear, Ogden has the convention Abaqus.");
    prm.declare_entry("Ogden order",
                      std::to_string(defaults.ogden_order),
                      Patterns::Integer(1, 4),
                      "Number of terms of Ogden's law (-).");
    prm.declare_entry("Bounds",
                      "",
                      Patterns::Anything(),
                      "Bounds of the search, as name:lowest:highest separated "
                      "by commas, such as K2:1:300, kappa:0:0.33, C10:100:1e6. "
                      "Stiffnesses (Pa) are C10, K1; c; mu1, ...; c0, whose "
                      "upper bound is ignored; the others (-) K2, kappa; "
                      "b1111, b2222, coupling; alpha1, ...; c1, c2.");
    prm.declare_entry("Grid points",
                      std::to_string(defaults.options.grid),
                      Patterns::Integer(5, 1000),
                      "Points along each side of the grid on which the best "
                      "of two parameters without unit are searched (-).");
    prm.declare_entry("Random starts",
                      std::to_string(defaults.options.starts),
                      Patterns::Integer(1, 100000),
                      "Starts of the search where there are other numbers of "
                      "such parameters (-).");
    prm.declare_entry("Seed",
                      std::to_string(defaults.options.seed),
                      Patterns::Integer(0),
                      "Seed of these starts (-).");
    prm.declare_entry("Confidence",
                      Patterns::Tools::to_string(defaults.options.confidence),
                      Patterns::Double(0.5, 0.9999),
                      "Probability of the confidence intervals (-).");
    prm.leave_subsection();
  }



  void
  FitParameters::parse_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Fit");
    data_file                = prm.get("Data");
    const std::string stress = prm.get("Stress measure");
    measure            = stress == "first Piola" ? StressMeasure::first_piola
                 : stress == "second Piola"      ? StressMeasure::second_piola
                                                 : StressMeasure::cauchy;
    unit               = prm.get("Stress unit");
    materials          = Utilities::split_string_list(prm.get("Materials"));
    ogden_order        = prm.get_integer("Ogden order");
    options.grid       = prm.get_integer("Grid points");
    options.starts     = prm.get_integer("Random starts");
    options.seed       = prm.get_integer("Seed");
    options.confidence = prm.get_double("Confidence");
    const auto entries = Utilities::split_string_list(prm.get("Bounds"));
    prm.leave_subsection();

    if (materials.empty())
      throw InputError("Fit/Materials is empty, at least one is needed");
    for (const std::string &entry : entries)
      {
        const auto parts = Utilities::split_string_list(entry, ':');
        double values[2];
        try
          {
            if (parts.size() != 3)
              throw InputError("");
            values[0] = Utilities::string_to_double(parts[1]);
            values[1] = Utilities::string_to_double(parts[2]);
          }
        catch (...)
          {
            throw InputError("Fit/Bounds: '" + entry +
                             "' is not name:lowest:highest");
          }
        if (!std::isfinite(values[0]) || !std::isfinite(values[1]))
          throw InputError("Fit/Bounds: in '" + entry +
                           "' a value is not finite");
        if (!(values[0] < values[1]))
          throw InputError("Fit/Bounds: in '" + entry +
                           "' the lowest value is not below the highest");
        bounds[parts[0]] = {{values[0], values[1]}};
      }
    for (const std::string &material : materials)
      model(material);
  }



  std::unique_ptr<TissueModel>
  FitParameters::model(const std::string &material) const
  {
    std::string known;
    auto unused = bounds;
    for (const std::string &other : materials)
      for (const auto &v : make_tissue_model(other, ogden_order)->variables())
        {
          known += (known.empty() ? "" : ", ") + v.name;
          unused.erase(v.name);
        }
    if (!unused.empty())
      throw InputError("Fit/Bounds names '" + unused.begin()->first +
                       "', which is no parameter; there are " + known);

    auto result      = make_tissue_model(material, ogden_order);
    const auto apply = [&](std::vector<FitVariable> &variables) {
      for (FitVariable &v : variables)
        {
          const auto found = bounds.find(v.name);
          if (found == bounds.end())
            continue;
          if (found->second[0] < 0 && (v.logarithmic || v.unit == "Pa"))
            throw InputError("Fit/Bounds: " + v.name + " cannot be negative");
          if (v.logarithmic && found->second[0] == 0)
            throw InputError("Fit/Bounds: " + v.name +
                             " must have a positive lowest value");
          v.lowest  = found->second[0];
          v.highest = found->second[1];
        }
    };
    apply(result->stiffnesses);
    apply(result->shapes);
    return result;
  }
} // namespace coapt
