#ifndef coapt_flow_number_lists_h
#define coapt_flow_number_lists_h

#include <coapt/base/exceptions.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace coapt
{
  /** The numbers of a list "0.1, 0.2". Throws InputError, which names the
   * parameter @p name. */
  std::vector<double>
  read_numbers(const std::string &name, const std::string &list);

  /** Points "0, 1; 2, 3" with @p dimension coordinates each. Throws
   * InputError, which names the parameter @p name. */
  std::vector<std::vector<double>>
  read_points(const std::string &name,
              const std::string &list,
              const unsigned int dimension);

  /** "0.1, 0.2". */
  std::string
  join_numbers(const std::vector<double> &numbers);

  /** The point with these coordinates, of which there are dim. */
  template <int dim>
  dealii::Point<dim>
  to_point(const std::vector<double> &coordinates)
  {
    dealii::Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = coordinates[d];
    return point;
  }

  /** Returns the @p list, the parameter @p name. Throws InputError unless it
   * has an entry for each dimension. */
  template <typename Number>
  const std::vector<Number> &
  checked_size(const std::string &name,
               const std::vector<Number> &list,
               const unsigned int dimension)
  {
    if (list.size() != dimension)
      throw InputError(name + " has " + std::to_string(list.size()) +
                       " coordinate(s), expected are " +
                       std::to_string(dimension) + " (Flow/Dimension)");
    return list;
  }
} // namespace coapt

#endif
