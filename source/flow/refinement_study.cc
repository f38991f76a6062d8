#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/base/version.h>
#include <coapt/flow/refinement_study.h>
#include <coapt/io/summary.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace coapt
{
  namespace
  {
    /** A number of at most @p digits digits; nothing if it is not a number. */
    std::string
    text_of(const double value, const unsigned int digits)
    {
      if (std::isnan(value))
        return "";
      char text[32];
      std::snprintf(
        text, sizeof(text), "%.*g", static_cast<int>(digits), value);
      return text;
    }

    bool
    is_whole(const double value)
    {
      return value == std::round(value);
    }

    /** Sets the parameter "Section/Entry" and returns what it was. */
    std::string
    exchange(dealii::ParameterHandler &prm,
             const std::string &parameter,
             const std::string &text)
    {
      auto path = dealii::Utilities::split_string_list(parameter, '/');
      const std::string entry = path.back();
      path.pop_back();
      try
        {
          for (const std::string &section : path)
            prm.enter_subsection(section);
          const std::string before = prm.get(entry);
          prm.set(entry, text);
          for (unsigned int i = 0; i < path.size(); ++i)
            prm.leave_subsection();
          return before;
        }
      catch (const dealii::ExceptionBase &)
        {
          throw InputError("Study/Parameter = " + parameter +
                           " cannot be set to " + text +
                           ", expected is Section/Entry and a value that it "
                           "allows");
        }
    }

    /** The measures of error with their names. */
    const std::vector<std::pair<std::string, double FlowErrors::*>>
      error_columns = {{"velocity_l2", &FlowErrors::velocity_l2},
                       {"velocity_max", &FlowErrors::velocity_max},
                       {"pressure_l2", &FlowErrors::pressure_l2},
                       {"pressure_means_l2", &FlowErrors::pressure_means_l2}};
  } // namespace



  template <int dim>
  RefinementStudy<dim>::RefinementStudy(const FlowParameters &parameters,
                                        dealii::ParameterHandler &prm,
                                        const std::string &folder_of_file,
                                        Log &log,
                                        MPI_Comm communicator)
    : parameters(parameters), log(log), communicator(communicator)
  {
    if (!parameters.reference_values.empty())
      reference = read_reference_values<dim>(folder_of_file.empty()
                                               ? parameters.reference_values
                                               : folder_of_file + "/" +
                                                 parameters.reference_values);
    if (parameters.varied_parameter.empty())
      for (const unsigned int level : parameters.refinements)
        cases.push_back(
          {"level " + std::to_string(level), 1. * level, level, parameters});
    else
      for (const double value : parameters.varied_values)
        cases.push_back({parameters.varied_parameter + " " + text_of(value, 6),
                         value,
                         parameters.refinements[0],
                         with_value(prm, value)});
    // the coarsest shows what is wrong with all
    FlowRun<dim>(cases[0].parameters,
                 cases[0].level,
                 cases[0].label,
                 reference,
                 log,
                 communicator);
  }



  template <int dim>
  FlowParameters
  RefinementStudy<dim>::with_value(dealii::ParameterHandler &prm,
                                   const double value) const
  {
    FlowParameters result      = parameters;
    const std::string &name    = parameters.varied_parameter;
    const std::string original = exchange(prm, name, text_of(value, 16));
    result.parse_parameters(prm);
    exchange(prm, name, original);
    return result;
  }



  template <int dim>
  void
  RefinementStudy<dim>::run(const OutputFolder &folder)
  {
    for (unsigned int i = 0; i < cases.size(); ++i)
      {
        const OutputFolder own(folder.file("run_" + std::to_string(i + 1)),
                               true,
                               communicator);
        own.create();
        FlowRun<dim> flow(cases[i].parameters,
                          cases[i].level,
                          cases[i].label,
                          reference,
                          log,
                          communicator);
        all_results.push_back(flow.run(own));
        if (is_first_rank(communicator))
          {
            write_table(folder.file("study.csv"));
            write_summary(folder.file("summary.json"));
          }
      }
    print_table();
  }



  template <int dim>
  double
  RefinementStudy<dim>::order(const unsigned int i,
                              double FlowErrors::*error) const
  {
    if (i == 0)
      return std::numeric_limits<double>::quiet_NaN();
    const double ratio = parameters.varied_parameter.empty()
      ? all_results[i - 1].cell_size / all_results[i].cell_size
      : cases[i].value / cases[i - 1].value;
    return std::log(all_results[i - 1].errors.*error /
                    all_results[i].errors.*error) /
      std::log(ratio);
  }



  template <int dim>
  double
  RefinementStudy<dim>::last_velocity_order() const
  {
    return order(all_results.size() - 1, &FlowErrors::velocity_l2);
  }



  template <int dim>
  typename RefinementStudy<dim>::Row
  RefinementStudy<dim>::row(const unsigned int i) const
  {
    const FlowResult &result = all_results[i];
    const std::string name   = parameters.varied_parameter.empty()
        ? "level"
        : parameters.varied_parameter;
    Row row                  = {{name, cases[i].value},
                                {"cells", result.cells},
                                {"h_m", result.cell_size},
                                {"steps", result.steps},
                                {"wall_s", result.wall_seconds}};
    for (const auto &column : error_columns)
      {
        row.emplace_back(column.first, result.errors.*column.second);
        row.emplace_back(column.first + "_order", order(i, column.second));
      }
    row.insert(row.end(), result.figures.begin(), result.figures.end());
    return row;
  }



  template <int dim>
  void
  RefinementStudy<dim>::write_table(const std::string &file) const
  {
    std::ofstream stream(file);
    for (unsigned int i = 0; i < all_results.size(); ++i)
      {
        std::string header, line;
        for (const auto &entry : row(i))
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



  template <int dim>
  void
  RefinementStudy<dim>::write_summary(const std::string &file) const
  {
    Summary summary;
    summary.set("task", parameters.immersed ? "immersed" : "flow");
    summary.set("version", version());
    summary.set("revision", revision());
    summary.set("dimension", static_cast<unsigned int>(dim));
    summary.set("ranks", dealii::Utilities::MPI::n_mpi_processes(communicator));
    summary.set("runs_planned", static_cast<unsigned long>(cases.size()));
    for (unsigned int i = 0; i < all_results.size(); ++i)
      {
        Summary run;
        for (const auto &entry : row(i))
          run.set(entry.first, entry.second);
        summary.set("run_" + std::to_string(i + 1), run);
      }
    summary.write(file);
  }



  template <int dim>
  void
  RefinementStudy<dim>::print_table() const
  {
    const auto print = [this](const Row &row, const bool is_header) {
      std::string line;
      for (const auto &entry : row)
        {
          char cell[64];
          std::snprintf(
            cell,
            sizeof(cell),
            "%*s",
            static_cast<int>(std::max<std::size_t>(9, entry.first.size())) + 2,
            is_header
              ? entry.first.c_str()
              : text_of(entry.second, is_whole(entry.second) ? 9 : 4).c_str());
          line += cell;
        }
      log.line(line);
    };
    for (unsigned int i = 0; i < all_results.size(); ++i)
      {
        // what is known in this study
        Row known;
        const Row last = row(all_results.size() - 1), mine = row(i);
        for (unsigned int k = 0; k < mine.size(); ++k)
          if (!std::isnan(last[k].second))
            known.push_back(mine[k]);
        if (i == 0)
          print(known, true);
        print(known, false);
      }
  }

  template class RefinementStudy<2>;
  template class RefinementStudy<3>;
} // namespace coapt
