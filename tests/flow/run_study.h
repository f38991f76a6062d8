#ifndef coapt_tests_flow_run_study_h
#define coapt_tests_flow_run_study_h

#include <coapt/base/parameter_file.h>
#include <coapt/base/version.h>
#include <coapt/flow/refinement_study.h>

#include <sstream>
#include <string>
#include <vector>

/** An entry of a parameter file that is changed. */
struct ChangedEntry
{
  std::string section, name, value;
};

/** What the runs of a test log. */
inline coapt::Log &
study_log()
{
  static std::ostringstream terminal;
  static coapt::Log log(MPI_COMM_WORLD, terminal);
  return log;
}

/** Runs a verification file without fields, with some entries changed. */
template <int dim>
coapt::RefinementStudy<dim>
run_study(const std::string &name,
          const coapt::FlowContents contents,
          const std::vector<ChangedEntry> &changes)
{
  const bool has_bodies = contents == coapt::FlowContents::bodies;
  dealii::ParameterHandler prm;
  prm.declare_entry("Task", has_bodies ? "immersed" : "flow");
  coapt::FlowParameters::declare_parameters(prm, contents);
  const std::string folder = coapt::parameter_files_folder() + "/verification";
  coapt::read_parameter_file(prm, folder + "/" + name + ".prm");
  const auto change = [&](const ChangedEntry &entry) {
    prm.enter_subsection(entry.section);
    prm.set(entry.name, entry.value);
    prm.leave_subsection();
  };
  change({"Output", "Fields interval", "0"});
  for (const ChangedEntry &entry : changes)
    change(entry);
  coapt::FlowParameters parameters;
  if (has_bodies)
    parameters.immersed.emplace();
  parameters.parse_parameters(prm);
  coapt::RefinementStudy<dim> study(
    parameters, prm, folder, study_log(), MPI_COMM_WORLD);
  const coapt::OutputFolder output(name, true, MPI_COMM_WORLD);
  output.create();
  study.run(output);
  return study;
}

/** A figure by its name; not a number if there is none. */
inline double
figure(const coapt::FlowResult &result, const std::string &name)
{
  for (const auto &entry : result.figures)
    if (entry.first == name)
      return entry.second;
  return std::nan("");
}

#endif
