#include <deal.II/base/mpi.h>

#include <coapt/base/csv_table.h>
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

    /** Not-a-number if the row has no such column. */
    double
    value_in(const Study::Row &row, const std::string &name)
    {
      const auto entry =
        std::find_if(row.begin(), row.end(), [&](const auto &candidate) {
          return candidate.first == name;
        });
      return entry != row.end() ? entry->second
                                : std::numeric_limits<double>::quiet_NaN();
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

    const char *const table     = "study.csv";
    const char *const plan_file = "plan.txt";

    /** The lines of a file; none if it cannot be read. */
    std::vector<std::string>
    lines_of(const std::string &file)
    {
      std::vector<std::string> result;
      std::ifstream in(file);
      for (std::string line; std::getline(in, line);)
        result.push_back(line);
      return result;
    }

    /** Writes a file in one go: what was there before stays until it is
     * complete. Throws std::runtime_error. */
    void
    write_lines(const std::string &file, const std::vector<std::string> &lines)
    {
      std::ofstream out(file + ".new");
      for (const std::string &line : lines)
        out << line << '\n';
      if (!out.flush())
        throw std::runtime_error(file + ": writing failed; is the disk full?");
      std::filesystem::rename(file + ".new", file);
    }
  } // namespace



  Study::Study(Log &log, const MPI_Comm communicator)
    : log(log), communicator(communicator)
  {
  }



  void
  Study::run(const std::vector<std::string> &plan,
             const Run &run,
             const Summary &header,
             const OutputFolder &folder)
  {
    rows.clear();
    if (folder.continues())
      rows = dealii::Utilities::MPI::broadcast(communicator,
                                               is_first_rank(communicator)
                                                 ? rows_in(folder.file(table))
                                                 : std::vector<Row>());
    if (!rows.empty())
      log.line("runs 1 to " + std::to_string(rows.size()) +
               " are there already");
    if (is_first_rank(communicator))
      write_lines(folder.file(plan_file), plan);
    const auto write_results = [&]() {
      if (is_first_rank(communicator) && !rows.empty())
        {
          write_table(folder.file(table));
          write_summary(header, plan.size(), folder.file("summary.json"));
        }
    };
    write_results();
    for (unsigned int i = rows.size(); i < plan.size(); ++i)
      {
        const OutputFolder own(folder.file("run_" + std::to_string(i + 1)),
                               true,
                               communicator,
                               folder.continues() ? Resume::if_possible
                                                  : Resume::never);
        own.create();
        rows.push_back(run(i, own, rows));
        write_results();
      }
    if (is_first_rank(communicator))
      print_table();
  }



  void
  Study::check_plan(const OutputFolder &folder,
                    const std::vector<std::string> &plan,
                    MPI_Comm communicator)
  {
    if (!folder.continues())
      return;
    on_first_rank(communicator, [&]() -> std::string {
      const std::string file              = folder.file(plan_file);
      const std::vector<std::string> then = lines_of(file);
      // those in the table, and the one that was interrupted
      const std::size_t n = rows_in(folder.file(table)).size() + 1;
      for (std::size_t i = 0; i < n && i < then.size(); ++i)
        if (i >= plan.size() || plan[i] != then[i])
          return file + ": run " + std::to_string(i + 1) + " was \"" + then[i] +
            "\", but is " + (i < plan.size() ? "\"" + plan[i] + "\"" : "none") +
            " now: a study goes on with the same runs";
      return "";
    });
  }



  std::vector<std::string>
  Study::columns() const
  {
    std::vector<std::string> result;
    for (const Row &row : rows)
      for (const auto &entry : row)
        if (std::find(result.begin(), result.end(), entry.first) ==
            result.end())
          result.push_back(entry.first);
    return result;
  }



  void
  Study::write_table(const std::string &file) const
  {
    std::vector<std::string> lines(1 + rows.size());
    std::string separator;
    for (const std::string &name : columns())
      {
        lines[0] += separator + name;
        for (unsigned int i = 0; i < rows.size(); ++i)
          lines[1 + i] += separator + text_of(value_in(rows[i], name), 9);
        separator = ",";
      }
    write_lines(file, lines);
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
    for (const auto &[name, last] : rows.back())
      if (!std::isnan(last))
        {
          header += right_aligned(name, name);
          for (unsigned int i = 0; i < rows.size(); ++i)
            lines[i] += right_aligned(cell_text(value_in(rows[i], name)), name);
        }
    log.line(header);
    for (const std::string &line : lines)
      log.line(line);
  }
} // namespace coapt
