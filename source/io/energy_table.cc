#include <coapt/io/energy_table.h>

#include <algorithm>
#include <cstdio>

namespace coapt
{
  namespace
  {
    /** A name without "_J". */
    std::string
    without_unit(const std::string &name)
    {
      return name.substr(0, name.size() - 2);
    }
  } // namespace



  std::string
  energy_table(const std::vector<Statistics::Entry> &books,
               const double relative_error)
  {
    std::string table;
    char text[128];
    std::snprintf(text, sizeof(text), "%-28s %12s\n", "energy", "[J]");
    table += text;
    for (const auto &[name, value] : books)
      {
        if (value == 0)
          continue;
        std::string words = without_unit(name);
        std::replace(words.begin(), words.end(), '_', ' ');
        std::snprintf(
          text, sizeof(text), "%-28.28s %12.5g\n", words.c_str(), value);
        table += text;
      }
    std::snprintf(text,
                  sizeof(text),
                  "%-28s %12.2g %%\n",
                  "closure error over the work",
                  100 * relative_error);
    return table + text;
  }



  Summary
  energy_summary(const std::vector<Statistics::Entry> &books)
  {
    Summary result;
    for (const auto &[name, value] : books)
      result.set(without_unit(name), value);
    return result;
  }
} // namespace coapt
