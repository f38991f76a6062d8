#include <coapt/base/exceptions.h>
#include <coapt/base/varied_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <limits>

namespace coapt
{
  using dealii::ParameterHandler;
  using dealii::Utilities::split_string_list;

  namespace
  {
    /** Sets the parameter of this full name, and returns the value before. */
    std::string
    exchange(ParameterHandler &prm,
             const std::string &name,
             const std::string &value)
    {
      const auto path = split_string_list(name, '/');
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        prm.enter_subsection(path[i]);
      const std::string before = prm.get(path.back());
      prm.set(path.back(), value);
      for (unsigned int i = 0; i + 1 < path.size(); ++i)
        prm.leave_subsection();
      return before;
    }
  } // namespace



  void
  VariedParameters::declare_parameters(ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    prm.enter_subsection("Study");
    prm.declare_entry("Parameter",
                      "",
                      Anything(),
                      "Parameter that changes from run to run, with its "
                      "section, such as Fluid/Sound speed; or several that "
                      "change together, separated by semicolons. Empty for no "
                      "study.");
    prm.declare_entry("Values",
                      "",
                      Anything(),
                      "Values of the parameter, a run for each of them, "
                      "separated by commas; of several parameters a list for "
                      "each, separated by semicolons.");
    prm.leave_subsection();
  }



  void
  VariedParameters::parse_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Study");
    const auto names = split_string_list(prm.get("Parameter"), ';');
    const auto lists = split_string_list(prm.get("Values"), ';');
    prm.leave_subsection();
    if (names.empty() != lists.empty())
      throw InputError("Study/Parameter and Study/Values belong together, "
                       "found is only one of them");
    if (names.size() != lists.size())
      throw InputError("Study/Parameter names " + std::to_string(names.size()) +
                       " parameter(s), but Study/Values has " +
                       std::to_string(lists.size()) + " list(s)");
    parameters.clear();
    for (unsigned int i = 0; i < names.size(); ++i)
      {
        if (names[i].empty() || names[i].compare(0, 6, "Study/") == 0 ||
            names[i] == "Output/Folder" || names[i] == "Task")
          throw InputError("Study/Parameter names '" + names[i] +
                           "', which cannot be varied");
        if (std::count(names.begin(), names.end(), names[i]) > 1)
          throw InputError("Study/Parameter names '" + names[i] + "' twice");
        parameters.push_back({names[i], split_string_list(lists[i], ',')});
        const auto n_values = parameters.back().values.size();
        if (n_values != n_runs() || n_values == 0)
          throw InputError("Study/Values has " + std::to_string(n_values) +
                           " value(s) of " + names[i] + ", expected " +
                           (i == 0 ? "is at least one"
                                   : "are " + std::to_string(n_runs()) +
                                " as for the first parameter"));
      }
  }



  unsigned int
  VariedParameters::n_runs() const
  {
    return parameters.empty() ? 0 : parameters[0].values.size();
  }



  std::string
  VariedParameters::label(const unsigned int run) const
  {
    std::string text;
    for (const Parameter &parameter : parameters)
      text += (text.empty() ? "" : ", ") + parameter.name + " " +
        parameter.values[run];
    return text;
  }



  std::vector<std::pair<std::string, double>>
  VariedParameters::columns(const unsigned int run) const
  {
    std::vector<std::pair<std::string, double>> result;
    for (const Parameter &parameter : parameters)
      {
        double value = std::numeric_limits<double>::quiet_NaN();
        try
          {
            value = dealii::Utilities::string_to_double(parameter.values[run]);
          }
        catch (const std::exception &)
          {
            // a word, which has no place among numbers
          }
        result.emplace_back(parameter.name, value);
      }
    return result;
  }



  void
  VariedParameters::with_values(ParameterHandler &prm,
                                const unsigned int run,
                                const std::function<void()> &read) const
  {
    std::vector<std::string> before;
    for (const Parameter &parameter : parameters)
      try
        {
          before.push_back(
            exchange(prm, parameter.name, parameter.values[run]));
        }
      catch (const dealii::ExceptionBase &)
        {
          throw InputError("Study/Parameter = " + parameter.name +
                           " cannot be set to " + parameter.values[run] +
                           ", expected is Section/Entry and a value that it "
                           "allows");
        }
    read();
    for (unsigned int i = 0; i < parameters.size(); ++i)
      exchange(prm, parameters[i].name, before[i]);
  }
} // namespace coapt
