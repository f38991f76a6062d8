#include <coapt/base/csv_table.h>
#include <coapt/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace coapt
{
  namespace
  {
    const char *blanks = " \t\r\"";

    std::vector<std::string>
    entries_of(const std::string &line)
    {
      std::vector<std::string> entries;
      std::istringstream stream(line + ",");
      for (std::string entry; std::getline(stream, entry, ',');)
        {
          entry.erase(0,
                      std::min(entry.find_first_not_of(blanks), entry.size()));
          entry.erase(entry.find_last_not_of(blanks) + 1);
          entries.push_back(entry);
        }
      return entries;
    }
  } // namespace



  CsvTable::CsvTable(const std::string &file) : file(file)
  {
    std::ifstream stream(file);
    if (!stream)
      throw InputError(file + ": the file cannot be read");
    unsigned int number = 0;
    for (std::string line; std::getline(stream, line);)
      {
        ++number;
        line.erase(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(blanks) == std::string::npos)
          continue;
        const std::vector<std::string> entries = entries_of(line);
        if (names.empty())
          {
            names = entries;
            continue;
          }
        rows.push_back(entries);
        lines.push_back(number);
        if (entries.size() != names.size())
          throw InputError(
            place(rows.size() - 1) + ": " + std::to_string(entries.size()) +
            " entries, the header has " + std::to_string(names.size()));
      }
    if (rows.empty())
      throw InputError(file + ": there is no row below a header");
  }



  bool
  CsvTable::has(const std::string &name) const
  {
    return std::find(names.begin(), names.end(), name) != names.end();
  }



  unsigned int
  CsvTable::column(const std::string &name) const
  {
    std::string all;
    for (const std::string &known : names)
      all += (all.empty() ? "" : ", ") + known;
    if (!has(name))
      throw InputError(file + ": the column " + name +
                       " is missing; there are " + all);
    return std::find(names.begin(), names.end(), name) - names.begin();
  }



  std::vector<std::string>
  CsvTable::texts(const std::string &name) const
  {
    const unsigned int c = column(name);
    std::vector<std::string> result;
    for (const auto &row : rows)
      result.push_back(row[c]);
    return result;
  }



  std::vector<double>
  CsvTable::numbers(const std::string &name) const
  {
    const unsigned int c = column(name);
    std::vector<double> result;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        const std::string &text = rows[i][c];
        char *end               = nullptr;
        result.push_back(std::strtod(text.c_str(), &end));
        if (text.empty() || *end != '\0' || !std::isfinite(result.back()))
          throw InputError(place(i) + ", column " + name + ": '" + text +
                           "' is not a finite number");
      }
    return result;
  }



  std::string
  CsvTable::place(const unsigned int row) const
  {
    return file + ", line " + std::to_string(lines[row]);
  }
} // namespace coapt
