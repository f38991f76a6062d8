#include <coapt/base/exceptions.h>
#include <coapt/io/console.h>
#include <coapt/valve_study.h>

#include <limits>

namespace coapt
{
  namespace
  {
    /** What a run costs. */
    const std::vector<std::string> costs = {"fluid_cells",
                                            "solid_tets",
                                            "coupling_points",
                                            "steps",
                                            "wall_s"};

    /** What is measured of the valve. */
    const std::vector<std::string> figures = {"sealed",
                                              "closing_time_s",
                                              "leak_mL_per_s",
                                              "stress_mean_kPa",
                                              "strain_mean",
                                              "bulging_volume_mL",
                                              "coaptation_area_mm2",
                                              "coaptation_force_N",
                                              "energy_error_relative",
                                              "work_of_adaptation_relative"};

    /** Relative change to a value of the row before, if there is one. */
    double
    change(const std::vector<Study::Row> &before,
           const std::string &name,
           const double now)
    {
      if (!before.empty())
        for (const auto &entry : before.back())
          if (entry.first == name && entry.second != 0)
            return now / entry.second - 1;
      return std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  ValveStudy::ValveStudy(const SimulationParameters &parameters,
                         const VariedParameters &varied,
                         dealii::ParameterHandler &prm,
                         Log &log,
                         MPI_Comm communicator)
    : varied(varied), log(log), communicator(communicator)
  {
    for (unsigned int i = 0; i < varied.n_runs(); ++i)
      try
        {
          cases.push_back(parameters);
          varied.with_values(prm, i, [&]() {
            cases.back().parse_parameters(prm);
          });
          make_valve_run(cases.back(), log, communicator);
        }
      catch (const InputError &error)
        {
          throw InputError("run " + std::to_string(i + 1) + " of the study (" +
                           varied.label(i) + "): " + error.what());
        }
  }



  void
  ValveStudy::run(const OutputFolder &folder)
  {
    Summary header;
    header.set("task", "valve");
    Study(log, communicator)
      .run(
        plan(),
        [this](const unsigned int i,
               const OutputFolder &own,
               const std::vector<Study::Row> &before) {
          return run_one(i, own, before);
        },
        header,
        folder);
  }



  void
  ValveStudy::check_checkpoint(const OutputFolder &folder) const
  {
    Study::check_plan(folder, plan(), communicator);
  }



  std::vector<std::string>
  ValveStudy::plan() const
  {
    std::vector<std::string> result;
    for (unsigned int i = 0; i < cases.size(); ++i)
      result.push_back(varied.label(i) + ", " + cases[i].run.until());
    return result;
  }



  Study::Row
  ValveStudy::run_one(const unsigned int i,
                      const OutputFolder &folder,
                      const std::vector<Study::Row> &before)
  {
    log.line("run " + std::to_string(i + 1) + " of " +
             std::to_string(cases.size()) + ": " + varied.label(i));
    Log own_log(communicator);
    const auto valve = make_valve_run(cases[i], own_log, communicator);
    valve->check_checkpoint(folder);
    own_log.open(folder.file("coapt.log"), folder.continues());
    own_log.line(Console::banner(communicator));
    const Summary result = valve->run(folder);

    Study::Row row = varied.columns(i);
    for (const std::string &name : costs)
      row.emplace_back(name, result.number(name));
    for (const std::string &name : figures)
      {
        const double value = result.number(name);
        row.emplace_back(name, value);
        if (name != "sealed")
          row.emplace_back(name + "_change", change(before, name, value));
      }
    return row;
  }
} // namespace coapt
