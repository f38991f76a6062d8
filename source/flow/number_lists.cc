#include <coapt/flow/number_lists.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Utilities::split_string_list;

  std::vector<double>
  read_numbers(const std::string &name, const std::string &list)
  {
    try
      {
        const auto numbers =
          dealii::Utilities::string_to_double(split_string_list(list));
        if (std::all_of(numbers.begin(), numbers.end(), [](const double x) {
              return std::isfinite(x);
            }))
          return numbers;
      }
    catch (const std::exception &)
      {
        // refused below
      }
    throw InputError(name + " contains '" + list +
                     "', expected are numbers separated by commas");
  }



  std::vector<std::vector<double>>
  read_points(const std::string &name,
              const std::string &list,
              const unsigned int dimension)
  {
    std::vector<std::vector<double>> points;
    for (const std::string &text : split_string_list(list, ';'))
      points.push_back(checked_size(name, read_numbers(name, text), dimension));
    return points;
  }



  std::string
  join_numbers(const std::vector<double> &numbers)
  {
    std::string text;
    for (const double number : numbers)
      text += (text.empty() ? "" : ", ") + dealii::Utilities::to_string(number);
    return text;
  }
} // namespace coapt
