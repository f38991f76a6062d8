#include <coapt/base/exceptions.h>
#include <coapt/base/time_table.h>
#include <coapt/base/units.h>
#include <coapt/base/version.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace coapt
{
  namespace
  {
    std::string
    trim(const std::string &text)
    {
      const auto first = text.find_first_not_of(" \t\r\n\"");
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(" \t\r\n\"") - first + 1);
    }

    std::vector<std::string>
    split(const std::string &text, const char separator)
    {
      std::vector<std::string> parts;
      std::istringstream stream(text);
      for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(trim(part));
      if (!text.empty() && text.back() == separator)
        parts.push_back("");
      return parts;
    }

    /** Whether all of @p text is one number, which goes to @p number. */
    bool
    is_number(const std::string &text, double &number)
    {
      char *end = nullptr;
      number    = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0';
    }

    double
    parse_number(const std::string &text, const std::string &where)
    {
      double number;
      if (!is_number(text, number))
        throw InputError(where + ": '" + text + "' is not a number");
      if (!std::isfinite(number))
        throw InputError(where + ": '" + text + "' is not finite");
      return number;
    }

    /** Factor from @p unit to SI. */
    double
    unit_factor(const std::string &unit, const std::string &where)
    {
      if (unit == "Pa")
        return 1.;
      if (unit == "kPa")
        return units::kilopascal;
      if (unit == "mmHg")
        return units::mmHg;
      throw InputError(where + ": unknown unit '" + unit +
                       "', allowed are Pa, kPa, mmHg");
    }

    /** The letters that end a column's name: mmHg of `pressure_mmHg`. */
    std::string
    unit_of_column(const std::string &name)
    {
      const auto letter = [](const char c) { return std::isalpha(c) != 0; };
      const auto last   = std::find_if(name.rbegin(), name.rend(), letter);
      const auto before = std::find_if_not(last, name.rend(), letter);
      return std::string(before.base(), last.base());
    }

    /** Unit by header and by parameter, which must not contradict. */
    double
    agreed_unit(const std::string &in_header,
                const std::string &wanted,
                const std::string &where)
    {
      if (wanted == "from file")
        {
          if (in_header.empty())
            throw InputError(where +
                             ": no unit is given; begin the file with "
                             "a line such as time_s,pressure_mmHg, or "
                             "set the unit to Pa, kPa or mmHg");
          return unit_factor(in_header, where);
        }
      const double factor = unit_factor(wanted, where);
      if (!in_header.empty() && unit_factor(in_header, where) != factor)
        throw InputError(where + ": the header says " + in_header +
                         ", but the parameter says " + wanted);
      return factor;
    }

    /** Slope at the end of a monotone cubic from the two nearest intervals. */
    double
    end_slope(const double h0,
              const double h1,
              const double d0,
              const double d1)
    {
      const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
      if (slope * d0 <= 0)
        return 0;
      if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0))
        return 3 * d0;
      return slope;
    }
  } // namespace

  TimeTable::TimeTable(const std::vector<double> &times,
                       const std::vector<double> &values,
                       const std::string &origin)
    : times(times), values(values)
  {
    if (times.size() != values.size())
      throw InputError(origin + ": " + std::to_string(times.size()) +
                       " times but " + std::to_string(values.size()) +
                       " values");
    if (times.size() < 2)
      throw InputError(origin + ": " + std::to_string(times.size()) +
                       " row(s) found, at least two are needed");
    for (std::size_t i = 0; i < times.size(); ++i)
      if (!std::isfinite(times[i]) || !std::isfinite(values[i]))
        throw InputError(origin + ": row " + std::to_string(i + 1) +
                         " is not finite");
    for (std::size_t i = 1; i < times.size(); ++i)
      if (times[i] <= times[i - 1])
        {
          std::ostringstream message;
          message << origin << ": times must increase, but row " << i + 1
                  << " (" << times[i] << " s) follows " << times[i - 1] << " s";
          throw InputError(message.str());
        }
    compute_slopes();
  }



  TimeTable
  TimeTable::from_file(const std::string &file, const std::string &unit)
  {
    std::ifstream stream(file);
    if (!stream)
      throw InputError(file + ": cannot be opened (table of time and value)");

    std::vector<double> times, values;
    std::string header_unit;
    bool first_line     = true;
    unsigned int number = 0;
    for (std::string line; std::getline(stream, line);)
      {
        ++number;
        line = trim(line.substr(0, line.find('#')));
        if (line.empty())
          continue;
        const std::string where = file + ", line " + std::to_string(number);
        const auto columns      = split(line, ',');
        if (columns.size() != 2)
          throw InputError(where + ": " + std::to_string(columns.size()) +
                           " column(s) found, a row is 'time, value'");
        double ignored;
        if (first_line && !is_number(columns[0], ignored))
          header_unit = unit_of_column(columns[1]);
        else
          {
            times.push_back(parse_number(columns[0], where));
            values.push_back(parse_number(columns[1], where));
            const auto n = times.size();
            if (n > 1 && times[n - 1] <= times[n - 2])
              throw InputError(where + ": times must increase, but " +
                               columns[0] + " s follows a later or equal time");
          }
        first_line = false;
      }
    if (first_line)
      throw InputError(file + ": the table is empty");
    if (times.size() < 2)
      throw InputError(file + ": " + std::to_string(times.size()) +
                       " row(s) found, at least two are needed");

    const double factor = agreed_unit(header_unit, unit, file);
    for (double &value : values)
      value *= factor;
    return TimeTable(times, values, file);
  }



  TimeTable
  TimeTable::from_list(const std::string &list, const std::string &unit)
  {
    const std::string where = "'" + list + "'";
    const double factor     = unit_factor(unit, where);
    std::vector<double> times, values;
    for (const std::string &row : split(list, ','))
      {
        const auto columns = split(row, ':');
        if (columns.size() != 2)
          throw InputError(where + ": '" + row + "' is not 'time:value'");
        times.push_back(parse_number(columns[0], where));
        values.push_back(factor * parse_number(columns[1], where));
      }
    return TimeTable(times, values, where);
  }



  std::string
  TimeTable::unit_names()
  {
    return "from file|Pa|kPa|mmHg";
  }



  double
  TimeTable::largest_magnitude() const
  {
    double largest = 0;
    for (const double value : values)
      largest = std::max(largest, std::abs(value));
    return largest;
  }



  void
  TimeTable::compute_slopes()
  {
    const std::size_t n = times.size();
    std::vector<double> h(n - 1), d(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i)
      {
        h[i] = times[i + 1] - times[i];
        d[i] = (values[i + 1] - values[i]) / h[i];
      }

    slopes.assign(n, d[0]);
    if (n == 2)
      return;
    for (std::size_t i = 1; i + 1 < n; ++i)
      {
        const double w0 = 2 * h[i] + h[i - 1];
        const double w1 = h[i] + 2 * h[i - 1];
        slopes[i] =
          (d[i - 1] * d[i] <= 0) ? 0. : (w0 + w1) / (w0 / d[i - 1] + w1 / d[i]);
      }
    slopes[0]     = end_slope(h[0], h[1], d[0], d[1]);
    slopes[n - 1] = end_slope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
  }



  double
  TimeTable::value(const double time) const
  {
    if (time <= times.front())
      return values.front();
    if (time >= times.back())
      return values.back();
    const std::size_t i =
      std::upper_bound(times.begin(), times.end(), time) - times.begin() - 1;
    const double h = times[i + 1] - times[i];
    const double s = (time - times[i]) / h;
    const double r = 1 - s;
    return r * r * ((1 + 2 * s) * values[i] + s * h * slopes[i]) +
      s * s * ((1 + 2 * r) * values[i + 1] - r * h * slopes[i + 1]);
  }



  std::string
  find_input_file(const std::string &name, const std::string &folder)
  {
    namespace fs = std::filesystem;
    // An empty folder is the current one, and an absolute name stays.
    for (const fs::path place : {folder, parameter_files_folder()})
      if (fs::exists(place / name))
        return (place / name).string();
    return name;
  }
} // namespace coapt
