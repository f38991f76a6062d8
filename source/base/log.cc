#include <coapt/base/first_rank.h>
#include <coapt/base/log.h>

#include <algorithm>
#include <iostream>

namespace coapt
{
  Log::Log(const MPI_Comm communicator) : Log(communicator, std::cout)
  {
  }



  Log::Log(const MPI_Comm communicator, std::ostream &terminal)
    : is_first_rank(coapt::is_first_rank(communicator)), terminal(terminal)
  {
  }



  void
  Log::open(const std::string &name, const bool continues)
  {
    if (!is_first_rank)
      return;
    file.open(name, continues ? std::ios::app : std::ios::out);
    file << lines_before_open << std::flush;
    if (!file)
      throw std::runtime_error(name + ": cannot be written");
    lines_before_open.clear();
  }



  void
  Log::line(const std::string &text)
  {
    if (!is_first_rank)
      return;
    terminal << text << std::endl;
    file_line(text);
  }



  void
  Log::file_line(const std::string &text)
  {
    if (!is_first_rank)
      return;
    if (file.is_open())
      file << text << std::endl;
    else
      lines_before_open += text + '\n';
  }



  void
  Log::warn(const std::string &key, const std::string &text)
  {
    if (!is_first_rank)
      return;
    const auto found =
      std::find_if(all_warnings.begin(),
                   all_warnings.end(),
                   [&](const Warning &warning) { return warning.key == key; });
    if (found != all_warnings.end())
      {
        ++found->count;
        return;
      }
    all_warnings.push_back({key, text, 1});
    line("warning: " + text);
  }



  void
  Log::put_before(const std::vector<Warning> &earlier)
  {
    const std::vector<Warning> own = all_warnings;
    all_warnings                   = earlier;
    for (const Warning &warning : own)
      if (std::none_of(earlier.begin(),
                       earlier.end(),
                       [&](const Warning &other) {
                         return other.key == warning.key;
                       }))
        all_warnings.push_back(warning);
  }
} // namespace coapt
