#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <coapt/base/first_rank.h>
#include <coapt/io/checkpoint_folder.h>
#include <coapt/io/output_folder.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

namespace coapt
{
  namespace
  {
    namespace fs = std::filesystem;

    // what tells a run's folder
    const std::array<const char *, 6> result_files = {
      {"coapt.log",
       "statistics.csv",
       "study.csv",
       "summary.json",
       "parameters.prm",
       "parameters-as-read.prm"}};

    /** Why results cannot go to @p path, empty if they can. */
    std::string
    objection(const std::string &path, const bool overwrite)
    {
      std::error_code code;
      if (!fs::exists(path, code))
        return "";
      if (!fs::is_directory(path, code))
        return "output folder '" + path + "' is not a folder";
      if (!overwrite)
        for (const std::string name : result_files)
          if (fs::exists(path + "/" + name, code))
            return "output folder '" + path + "' holds another run (" + name +
              "); choose another Output/Folder or set Output/Overwrite "
              "to true";
      return "";
    }

    /** Whether a file of this name is one that a run leaves in its folder. */
    bool
    is_result(const std::string &name)
    {
      static const std::regex others(
        "(chordae|contact_map|coaptation|sections|pressure_distribution|"
        "surface_load|quasi_static|dynamic|profile_.*|fit_.*)\\.csv|"
        "contact_map\\.vtu|plan\\.txt|material_.*\\.prm|report\\.html");
      return std::find(result_files.begin(), result_files.end(), name) !=
        result_files.end() ||
        std::regex_match(name, others);
    }

    /** Removes what an earlier run has left, with the folders of the runs of a
     * study if nothing else is in them. */
    void
    remove_earlier_results(const std::string &path)
    {
      static const std::regex run_folder("run_\\d+");
      // a copy, since entries go while it is read
      std::vector<fs::path> entries;
      for (const auto &entry : fs::directory_iterator(path))
        entries.push_back(entry.path());
      remove_checkpoints(path);
      for (const fs::path &entry : entries)
        if (!fs::is_directory(entry) && is_result(entry.filename().string()))
          fs::remove(entry);
        else if (fs::is_directory(entry) &&
                 std::regex_match(entry.filename().string(), run_folder))
          {
            remove_earlier_results(entry.string());
            std::error_code not_empty;
            fs::remove(entry / "fields", not_empty);
            fs::remove(entry, not_empty);
          }
      if (fs::is_directory(path + "/fields"))
        for (const auto &entry : fs::directory_iterator(path + "/fields"))
          {
            const auto extension = entry.path().extension();
            if (extension == ".vtu" || extension == ".pvtu" ||
                extension == ".pvd")
              fs::remove(entry.path());
          }
    }
  } // namespace

  OutputFolder::OutputFolder(const std::string &path,
                             const bool overwrite,
                             const MPI_Comm communicator,
                             const Resume resume)
    : path(path), communicator(communicator)
  {
    if (resume != Resume::never)
      from_checkpoint =
        dealii::Utilities::MPI::broadcast(communicator,
                                          is_first_rank(communicator)
                                            ? last_checkpoint(path)
                                            : std::string());
    on_first_rank(communicator, [&]() -> std::string {
      if (continues())
        return "";
      if (resume == Resume::always)
        return "output folder '" + path +
          "' has no checkpoint to go on from, which Output/Resume asks for";
      return objection(path, overwrite);
    });
  }



  void
  OutputFolder::create() const
  {
    on_first_rank(communicator, [&]() -> std::string {
      try
        {
          fs::create_directories(path + "/fields");
          if (continues())
            remove_unfinished_checkpoint(path);
          else
            remove_earlier_results(path);
        }
      catch (const fs::filesystem_error &error)
        {
          return "output folder '" + path +
            "' cannot be prepared: " + error.code().message();
        }
      return "";
    });
  }



  void
  OutputFolder::write_parameters(const dealii::ParameterHandler &prm,
                                 const std::string &source) const
  {
    on_first_rank(communicator, [&]() -> std::string {
      // deal.II ends the program with a trace of its calls if its stream fails.
      std::ostringstream given, all;
      given << std::ifstream(source).rdbuf();
      prm.print_parameters(all, dealii::ParameterHandler::PRM);
      for (const auto &[name, text] :
           {std::pair("parameters-as-read.prm", given.str()),
            std::pair("parameters.prm", all.str())})
        {
          std::ofstream out(file(name));
          if (!(out << text << std::flush))
            return file(name) + ": writing failed; is the disk full?";
        }
      return "";
    });
  }
} // namespace coapt
