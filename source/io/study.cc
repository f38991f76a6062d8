#include <deal.II/base/mpi.h>

#include <coapt/base/csv_table.h>
#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/base/serialization.h>
#include <coapt/base/version.h>
#include <coapt/io/study.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace coapt
{
  namespace
  {
    /** A number of at most @p digits digits; nothing if it is not a number. */
    std::string
    text_of(const double value, const int digits)
    {
      if (std::isnan(value))
        return "";
      char text[32];
      std::snprintf(text, sizeof(text), "%.*g", digits, value);
      return text;
    }

    /** Counts and levels are printed in full. */
    std::string
    cell_text(const double value)
    {
      return text_of(value, value == std::round(value) ? 9 : 4);
    }

    std::string
    right_aligned(const std::string &text, const std::string &name)
    {
      const std::size_t width = 2 + std::max<std::size_t>(9, name.size());
      return std::string(width - std::min(width, text.size()), ' ') + text;
    }

    /** The rows of a table in @p file; none if there is no such file. Throws
     * InputError. */
    std::vector<Study::Row>
    rows_in(const std::string &file)
    {
      if (!std::filesystem::exists(file))
        return {};
      const CsvTable table(file);
      std::vector<Study::Row> result(table.n_rows());
      for (const std::string &name : table.column_names())
        {
          const std::vector<std::string> column = table.texts(name);
          for (unsigned int i = 0; i < result.size(); ++i)
            result[i].emplace_back(name,
                                   column[i].empty()
                                     ? std::numeric_limits<double>::quiet_NaN()
                                     : std::strtod(column[i].c_str(), nullptr));
        }
      return result;
    }

    /** Whether two entries are the same, of which one has been written with
     * nine digits; what is no number is the same as another such thing. */
    bool
    is_same_entry(const std::pair<std::string, double> &a,
                  const std::pair<std::string, double> &b)
    {
      return a.first == b.first &&
        (std::isnan(a.second)
           ? std::isnan(b.second)
           : std::abs(a.second - b.second) <= 1e-8 * std::abs(a.second));
    }
  } // namespace



  Study::Study(Log &log, const MPI_Comm communicator)
    : log(log), communicator(communicator)
  {
  }



  void
  Study::run(const unsigned int n_runs,
             const Run &run,
             const Summary &header,
             const OutputFolder &folder)
  {
    rows.clear();
    if (folder.continues())
      rows = read_table(folder, communicator);
    if (!rows.empty())
      log.line("runs 1 to " + std::to_string(rows.size()) +
               " are there already");
    for (unsigned int i = rows.size(); i < n_runs; ++i)
      {
        const OutputFolder own(folder.file("run_" + std::to_string(i + 1)),
                               true,
                               communicator,
                               folder.continues() ? Resume::if_possible
                                                  : Resume::never);
        own.create();
        rows.push_back(run(i, own, rows));
        if (is_first_rank(communicator))
          {
            write_table(folder.file("study.csv"));
            write_summary(header, n_runs, folder.file("summary.json"));
          }
      }
    if (is_first_rank(communicator))
      print_table();
  }



  std::vector<Study::Row>
  Study::read_table(const OutputFolder &folder, MPI_Comm communicator)
  {
    std::vector<Row> result;
    on_first_rank(communicator, [&]() -> std::string {
      try
        {
          result = rows_in(folder.file("study.csv"));
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    });
    return dealii::Utilities::MPI::broadcast(communicator, result);
  }



  void
  Study::check_table(const OutputFolder &folder,
                     const std::vector<Row> &planned,
                     MPI_Comm communicator)
  {
    if (!folder.continues())
      return;
    const std::vector<Row> found = read_table(folder, communicator);
    bool fits                    = found.size() <= planned.size();
    for (unsigned int i = 0; i < found.size() && fits; ++i)
      fits = found[i].size() >= planned[i].size() &&
        std::equal(planned[i].begin(),
                   planned[i].end(),
                   found[i].begin(),
                   is_same_entry);
    if (!fits)
      throw InputError(folder.file("study.csv") +
                       " is the table of another study");
  }



  void
  Study::write_table(const std::string &file) const
  {
    std::ofstream stream(file);
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        std::string header, line;
        for (const auto &entry : rows[i])
          {
            header += (header.empty() ? "" : ",") + entry.first;
            line += (line.empty() ? "" : ",") + text_of(entry.second, 9);
          }
        if (i == 0)
          stream << header << '\n';
        stream << line << '\n';
      }
    stream.flush();
    if (!stream)
      throw std::runtime_error(file + ": writing failed; is the disk full?");
  }



  void
  Study::write_summary(Summary summary,
                       const unsigned int n_runs,
                       const std::string &file) const
  {
    summary.set("version", version());
    summary.set("revision", revision());
    summary.set("ranks", dealii::Utilities::MPI::n_mpi_processes(communicator));
    summary.set("runs_planned", n_runs);
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        Summary run;
        for (const auto &entry : rows[i])
          run.set(entry.first, entry.second);
        summary.set("run_" + std::to_string(i + 1), run);
      }
    summary.write(file);
  }



  void
  Study::print_table() const
  {
    std::string header;
    std::vector<std::string> lines(rows.size());
    for (unsigned int k = 0; k < rows.back().size(); ++k)
      if (!std::isnan(rows.back()[k].second))
        {
          const std::string &name = rows.back()[k].first;
          header += right_aligned(name, name);
          for (unsigned int i = 0; i < rows.size(); ++i)
            lines[i] += right_aligned(cell_text(rows[i][k].second), name);
        }
    log.line(header);
    for (const std::string &line : lines)
      log.line(line);
  }
} // namespace coapt
