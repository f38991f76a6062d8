#include <coapt/base/exceptions.h>
#include <coapt/base/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>
#include <vector>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    /** The reason that a deal.II exception gives, on one line. */
    std::string
    reason(const ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      std::istringstream words(text.str());
      std::string line;
      for (std::string word; words >> word;)
        line += (line.empty() ? "" : " ") + word;
      return line;
    }

    /** Single-letter edits from @p a to @p b (Levenshtein 1966). */
    unsigned int
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0u);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          unsigned int diagonal = row[0];
          row[0]                = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const unsigned int replaced =
                diagonal + (std::tolower(a[i]) == std::tolower(b[j]) ? 0 : 1);
              diagonal   = row[j + 1];
              row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
            }
        }
      return row.back();
    }

    /** " Did you mean ...?" for the declared name nearest to @p wanted. */
    std::string
    suggestion(const ParameterHandler &prm, const std::string &wanted)
    {
      std::stringstream text;
      prm.print_parameters(text, ParameterHandler::ShortText);
      std::string nearest;
      unsigned int least = 1 + wanted.size() / 3;
      for (std::string line; std::getline(text, line);)
        {
          std::istringstream words(line);
          std::string keyword, name;
          words >> keyword >> std::ws;
          if (keyword != "set" && keyword != "subsection")
            continue;
          std::getline(words, name, '=');
          name.erase(name.find_last_not_of(' ') + 1);
          const unsigned int distance = edit_distance(wanted, name);
          // the same name, known elsewhere, would help nobody here
          if (name != wanted && distance <= least)
            {
              least   = distance;
              nearest = name;
            }
        }
      return nearest.empty() ? "" : " (did you mean '" + nearest + "'?)";
    }

    /** The entry or subsection that @p message finds undeclared, if any. */
    std::string
    unknown_name(const std::string &message)
    {
      static const std::regex pattern(
        "No entry with name <([^>]*)>|no such subsection to be entered: (.*)");
      std::smatch match;
      if (!std::regex_search(message, match, pattern))
        return "";
      return match[1].str() + match[2].str();
    }
  } // namespace

  void
  read_parameter_file(ParameterHandler &prm,
                      const std::string &file,
                      const UnknownEntries unknown)
  {
    if (std::filesystem::is_directory(file))
      throw InputError(file + ": is a folder, expected is a parameter file");
    std::ifstream stream(file);
    if (!stream)
      throw InputError(file + ": cannot be opened (parameter file)");
    try
      {
        prm.parse_input(stream, file, "", unknown == UnknownEntries::skip);
      }
    catch (const ExceptionBase &exception)
      {
        const std::string message = reason(exception);
        const std::string name    = unknown_name(message);
        static const std::regex place("^Line <(\\d+)> of file <([^>:]*)>?:");
        throw InputError(std::regex_replace(message, place, "$2, line $1:") +
                         (name.empty() ? "" : suggestion(prm, name)));
      }
  }
} // namespace coapt
