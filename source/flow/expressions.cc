#include <coapt/base/exceptions.h>
#include <coapt/flow/expressions.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

namespace coapt
{
  using dealii::FunctionParser;
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** What muParser objects to, on one line. */
    std::string
    objection(const dealii::ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      std::string line;
      std::istringstream words(text.str());
      for (std::string word; words >> word;)
        line += (line.empty() ? "" : " ") + word;
      return line;
    }

    /** Keeps std::cerr quiet while it lives: deal.II writes there what is wrong
     * with an expression, before it throws. */
    class SilentErrors
    {
    public:
      SilentErrors() : before(std::cerr.rdbuf(nowhere.rdbuf()))
      {
      }
      ~SilentErrors()
      {
        std::cerr.rdbuf(before);
      }
      SilentErrors(const SilentErrors &) = delete;
      SilentErrors &
      operator=(const SilentErrors &) = delete;

    private:
      std::ostringstream nowhere;
      std::streambuf *before;
    };

    /** Throws InputError unless the constant can be called @p name. */
    void
    check_name(const std::string &parameter, const std::string &name)
    {
      static const std::regex allowed("[A-Za-z_][A-Za-z_0-9]*");
      static const std::set<std::string> taken = {"x", "y", "z", "t"};
      if (!std::regex_match(name, allowed) || taken.count(name) > 0)
        throw InputError(parameter + " has the name '" + name +
                         "', expected are letters, digits and underscores, "
                         "not a digit first, and not x, y, z or t");
    }

    template <int dim>
    std::shared_ptr<FunctionParser<dim>>
    make_parser(const std::string &parameter,
                const std::string &text,
                const unsigned int n_components,
                const NamedConstants &constants)
    {
      const auto parts = dealii::Utilities::split_string_list(text, ';');
      if (parts.size() != n_components)
        throw InputError(parameter + " = " + text + " has " +
                         std::to_string(parts.size()) +
                         " component(s) separated by ';', expected are " +
                         std::to_string(n_components));
      auto parser = std::make_shared<FunctionParser<dim>>(n_components);
      const SilentErrors silent;
      try
        {
          parser->initialize(dim == 2 ? "x,y,t" : "x,y,z,t",
                             parts,
                             constants,
                             true);
          for (unsigned int c = 0; c < n_components; ++c)
            parser->value(Point<dim>(), c);
        }
      catch (const dealii::ExceptionBase &exception)
        {
          throw InputError(parameter + " = " + text +
                           " cannot be read: " + objection(exception));
        }
      catch (...)
        {
          // muParser's own exception, which is no std::exception
          throw InputError(parameter + " = " + text + " cannot be read");
        }
      return parser;
    }
  } // namespace



  template <int dim>
  ScalarField<dim>
  scalar_field(const std::string &parameter,
               const std::string &text,
               const NamedConstants &constants)
  {
    if (text.empty())
      return {};
    const auto parser = make_parser<dim>(parameter, text, 1, constants);
    return [parser](const Point<dim> &x, const double t) {
      parser->set_time(t);
      return parser->value(x);
    };
  }



  template <int dim>
  VectorField<dim>
  vector_field(const std::string &parameter,
               const std::string &text,
               const NamedConstants &constants)
  {
    if (text.empty())
      return {};
    const auto parser = make_parser<dim>(parameter, text, dim, constants);
    return [parser](const Point<dim> &x, const double t) {
      parser->set_time(t);
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        value[c] = parser->value(x, c);
      return value;
    };
  }



  NamedConstants
  read_constants(const std::string &parameter,
                 const std::string &list,
                 NamedConstants known)
  {
    known["pi"] = std::acos(-1.);
    for (const std::string &entry :
         dealii::Utilities::split_string_list(list, ','))
      {
        const auto parts = dealii::Utilities::split_string_list(entry, '=');
        if (parts.size() != 2)
          throw InputError(parameter + " has the entry '" + entry +
                           "', expected is name = expression");
        check_name(parameter, parts[0]);
        known[parts[0]] =
          scalar_field<2>(parameter, parts[1], known)(Point<2>(), 0.);
      }
    return known;
  }

  template ScalarField<2>
  scalar_field<2>(const std::string &,
                  const std::string &,
                  const NamedConstants &);
  template ScalarField<3>
  scalar_field<3>(const std::string &,
                  const std::string &,
                  const NamedConstants &);
  template VectorField<2>
  vector_field<2>(const std::string &,
                  const std::string &,
                  const NamedConstants &);
  template VectorField<3>
  vector_field<3>(const std::string &,
                  const std::string &,
                  const NamedConstants &);
} // namespace coapt
