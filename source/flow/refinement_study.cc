#include <coapt/base/exceptions.h>
#include <coapt/base/time_table.h>
#include <coapt/flow/refinement_study.h>

#include <cmath>
#include <limits>

namespace coapt
{
  namespace
  {
    /** The measures of error with their names. */
    const std::vector<std::pair<std::string, double FlowErrors::*>>
      error_columns = {{"velocity_l2", &FlowErrors::velocity_l2},
                       {"velocity_max", &FlowErrors::velocity_max},
                       {"pressure_l2", &FlowErrors::pressure_l2},
                       {"pressure_means_l2", &FlowErrors::pressure_means_l2}};

    /** What a row of the table tells of its run. */
    FlowResult
    result_of(const Study::Row &row)
    {
      FlowResult result;
      for (const auto &entry : row)
        {
          if (entry.first == "h_m")
            result.cell_size = entry.second;
          for (const auto &column : error_columns)
            if (entry.first == column.first)
              result.errors.*column.second = entry.second;
        }
      return result;
    }
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
      reference = read_reference_values<dim>(
        find_input_file(parameters.reference_values, folder_of_file));
    if (parameters.varied.n_runs() == 0)
      for (const unsigned int level : parameters.refinements)
        cases.push_back({"level " + std::to_string(level),
                         {{"level", 1. * level}},
                         level,
                         parameters});
    for (unsigned int i = 0; i < parameters.varied.n_runs(); ++i)
      {
        FlowParameters own = parameters;
        parameters.varied.with_values(prm, i, [&]() {
          own.parse_parameters(prm);
        });
        cases.push_back({parameters.varied.label(i),
                         parameters.varied.columns(i),
                         own.refinements[0],
                         own});
      }
    // the coarsest shows what is wrong with all
    FlowRun<dim>(cases[0].parameters,
                 cases[0].level,
                 cases[0].label,
                 reference,
                 log,
                 communicator);
  }



  template <int dim>
  void
  RefinementStudy<dim>::check_checkpoint(const OutputFolder &folder) const
  {
    Study::check_plan(folder, plan(), communicator);
  }



  template <int dim>
  std::vector<std::string>
  RefinementStudy<dim>::plan() const
  {
    std::vector<std::string> result;
    for (const Case &one : cases)
      result.push_back(one.label + ", " + one.parameters.run.until());
    return result;
  }



  template <int dim>
  void
  RefinementStudy<dim>::run(const OutputFolder &folder)
  {
    Summary header;
    header.set("task", parameters.immersed ? "immersed" : "flow");
    header.set("dimension", static_cast<unsigned int>(dim));
    Study(log, communicator)
      .run(
        plan(),
        [this](const unsigned int i,
               const OutputFolder &own,
               const std::vector<Study::Row> &before) {
          for (std::size_t k = all_results.size(); k < i; ++k)
            all_results.push_back(result_of(before[k]));
          FlowRun<dim> flow(cases[i].parameters,
                            cases[i].level,
                            cases[i].label,
                            reference,
                            log,
                            communicator);
          all_results.push_back(flow.run(own));
          return row(i);
        },
        header,
        folder);
  }



  template <int dim>
  double
  RefinementStudy<dim>::order(const unsigned int i,
                              double FlowErrors::*error) const
  {
    if (i == 0)
      return std::numeric_limits<double>::quiet_NaN();
    const double ratio = parameters.varied.n_runs() == 0
      ? all_results[i - 1].cell_size / all_results[i].cell_size
      : cases[i].columns[0].second / cases[i - 1].columns[0].second;
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
  Study::Row
  RefinementStudy<dim>::row(const unsigned int i) const
  {
    const FlowResult &result = all_results[i];
    Study::Row row           = cases[i].columns;
    row.insert(row.end(),
               {{"cells", result.cells},
                {"h_m", result.cell_size},
                {"steps", result.steps},
                {"wall_s", result.wall_seconds}});
    for (const auto &column : error_columns)
      {
        row.emplace_back(column.first, result.errors.*column.second);
        row.emplace_back(column.first + "_order", order(i, column.second));
      }
    row.insert(row.end(), result.figures.begin(), result.figures.end());
    return row;
  }

  template class RefinementStudy<2>;
  template class RefinementStudy<3>;
} // namespace coapt
