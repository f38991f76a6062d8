#ifndef coapt_flow_expressions_h
#define coapt_flow_expressions_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <map>
#include <string>

namespace coapt
{
  /** Numbers by name that an expression may use. */
  using NamedConstants = std::map<std::string, double>;

  /** A function of position (m) and time (s). @{ */
  template <int dim>
  using ScalarField =
    std::function<double(const dealii::Point<dim> &, const double)>;
  template <int dim>
  using VectorField =
    std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &,
                                         const double)>;
  /** @} */

  /**
   * Adds to @p known the constants of a list "name = expression, ...", each
   * of which may use those before it, and pi. Throws InputError, which names
   * the parameter @p parameter, if one cannot be read.
   */
  NamedConstants
  read_constants(const std::string &parameter,
                 const std::string &list,
                 NamedConstants known);

  /**
   * The function that @p text gives in the syntax of muParser, in x, y, z (in
   * 3D), t and @p constants; an empty function for an empty text. A vector has
   * its components separated by semicolons. Throws InputError, which names
   * the parameter @p parameter, if the text has another number of
   * components or cannot be read. @{
   */
  template <int dim>
  ScalarField<dim>
  scalar_field(const std::string &parameter,
               const std::string &text,
               const NamedConstants &constants);

  template <int dim>
  VectorField<dim>
  vector_field(const std::string &parameter,
               const std::string &text,
               const NamedConstants &constants);
  /** @} */
} // namespace coapt

#endif
