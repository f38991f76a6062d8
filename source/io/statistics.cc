#include <coapt/base/first_rank.h>
#include <coapt/io/statistics.h>

#include <iomanip>
#include <stdexcept>

namespace coapt
{
  Statistics::Statistics(const std::string &file,
                         const MPI_Comm communicator,
                         const bool continues)
    : file(file), is_first_rank(coapt::is_first_rank(communicator))
  {
    if (!is_first_rank)
      return;
    table.open(file, continues);
    table.stream() << std::setprecision(12);
  }



  void
  Statistics::write_row(const std::vector<Entry> &row)
  {
    if (!is_first_rank)
      return;
    std::ostream &stream = table.stream();
    const bool is_header = names.empty();
    for (unsigned int i = 0; i < row.size() && is_header; ++i)
      {
        names.push_back(row[i].first);
        stream << (i == 0 ? "" : ",") << row[i].first;
      }
    if (is_header)
      stream << '\n';

    bool same_names = row.size() == names.size();
    for (unsigned int i = 0; i < row.size() && same_names; ++i)
      same_names = row[i].first == names[i];
    if (!same_names)
      throw std::logic_error(file +
                             ": a row has other columns than the header");

    for (unsigned int i = 0; i < row.size(); ++i)
      stream << (i == 0 ? "" : ",") << row[i].second;
    stream << '\n';
    table.flush();
  }
} // namespace coapt
