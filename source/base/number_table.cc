#include <coapt/base/exceptions.h>
#include <coapt/base/number_table.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace coapt
{
  namespace
  {
    std::string
    trim(const std::string &text)
    {
      const std::string blank = " \t\r\n\"";
      const auto first        = text.find_first_not_of(blank);
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(blank) - first + 1);
    }

    /** Cells of a line without its comment; empty if nothing is left. */
    std::vector<std::string>
    cells_of(const std::string &line)
    {
      const std::string text = trim(line.substr(0, line.find('#')));
      std::vector<std::string> cells;
      if (text.empty())
        return cells;
      std::size_t begin = 0;
      for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
        {
          end = text.find(',', begin);
          cells.push_back(trim(text.substr(begin, end - begin)));
        }
      return cells;
    }

    bool
    is_number(const std::string &text, double &number)
    {
      char *end = nullptr;
      number    = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0';
    }

    std::string
    line_name(const std::string &file, const unsigned int line)
    {
      return file + ", line " + std::to_string(line);
    }

    std::string
    joined(const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
      return text;
    }

    /** Places of the wanted @p columns among the @p names of the file. */
    std::vector<unsigned int>
    find_columns(const std::vector<std::string> &names,
                 const std::vector<std::string> &columns,
                 const std::string &where)
    {
      std::vector<unsigned int> places;
      for (const std::string &column : columns)
        {
          const auto found = std::find(names.begin(), names.end(), column);
          if (found == names.end())
            throw InputError(where + ": the column '" + column +
                             "' is missing; there are " + joined(names));
          places.push_back(found - names.begin());
        }
      return places;
    }

    NumberTable::Row
    read_row(const std::vector<std::string> &cells,
             const std::vector<unsigned int> &places,
             const std::vector<std::string> &columns,
             const std::string &file,
             const unsigned int line)
    {
      NumberTable::Row row;
      row.line = line;
      for (unsigned int c = 0; c < places.size(); ++c)
        {
          const std::string where = line_name(file, line) + ", column " +
            std::to_string(places[c] + 1) + " (" + columns[c] + ")";
          if (places[c] >= cells.size())
            throw InputError(where + ": there are only " +
                             std::to_string(cells.size()) + " column(s)");
          double number;
          if (!is_number(cells[places[c]], number))
            throw InputError(where + ": '" + cells[places[c]] +
                             "' is not a number");
          if (!std::isfinite(number))
            throw InputError(where + ": '" + cells[places[c]] +
                             "' is not finite");
          row.values.push_back(number);
        }
      return row;
    }
  } // namespace

  NumberTable
  NumberTable::from_file(const std::string &file,
                         const std::vector<std::string> &columns)
  {
    std::ifstream stream(file);
    if (!stream)
      throw InputError(file + ": cannot be opened (table with the columns " +
                       joined(columns) + ")");
    NumberTable table;
    table.file = file;
    std::vector<unsigned int> places;
    unsigned int number = 0;
    for (std::string line; std::getline(stream, line);)
      {
        ++number;
        const auto cells = cells_of(line);
        if (cells.empty())
          continue;
        double ignored;
        if (places.empty() && !is_number(cells[0], ignored))
          {
            places = find_columns(cells, columns, line_name(file, number));
            continue;
          }
        if (places.empty())
          for (unsigned int c = 0; c < columns.size(); ++c)
            places.push_back(c);
        table.rows.push_back(read_row(cells, places, columns, file, number));
      }
    if (table.rows.empty())
      throw InputError(file + ": the table has no row of numbers");
    return table;
  }



  std::vector<std::string>
  NumberTable::column_names(const std::string &file)
  {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
      {
        const auto cells = cells_of(line);
        double ignored;
        if (!cells.empty())
          return is_number(cells[0], ignored) ? std::vector<std::string>()
                                              : cells;
      }
    return {};
  }



  std::string
  NumberTable::place(const unsigned int i) const
  {
    return line_name(file, rows[i].line);
  }



  int
  NumberTable::whole_number(const unsigned int i, const unsigned int c) const
  {
    const double value = rows[i].values[c];
    if (value != std::floor(value) || std::abs(value) >= 1e9)
      throw InputError(place(i) + ": " + std::to_string(value) +
                       " is not a whole number of less than ten digits");
    return static_cast<int>(value);
  }
} // namespace coapt
