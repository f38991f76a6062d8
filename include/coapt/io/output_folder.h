#ifndef coapt_io_output_folder_h
#define coapt_io_output_folder_h

#include <coapt/base/run_parameters.h>

#include <mpi.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * The folder that takes the results of one run: coapt.log, statistics.csv or
   * study.csv, summary.json, parameters.prm, parameters-as-read.prm and
   * fields/. Construction only looks; nothing on the disk changes before
   * create(), so that bad input found in between leaves earlier results alone.
   */
  class OutputFolder
  {
  public:
    /**
     * Looks whether @p path can be used, and whether a run goes on there from a
     * checkpoint. Collective: all ranks throw alike.
     *
     * @throws InputError if the path is no folder, or holds another run and
     * @p overwrite is false, or if there is no checkpoint and @p resume needs
     * one.
     */
    OutputFolder(const std::string &path,
                 const bool overwrite,
                 const MPI_Comm communicator,
                 const Resume resume = Resume::never);

    /** Whether the run goes on from a checkpoint of an earlier one. */
    bool
    continues() const
    {
      return !from_checkpoint.empty();
    }

    /** Path of the checkpoint that the run goes on from. */
    const std::string &
    checkpoint() const
    {
      return from_checkpoint;
    }

    /**
     * Creates the folder and its subfolder fields, and removes what an earlier
     * run has left there (the files of the names above; no others), unless this
     * one continues it. Collective.
     *
     * @throws InputError on all ranks if that cannot be done.
     */
    void
    create() const;

    /** Path of the file @p name in the folder. */
    std::string
    file(const std::string &name) const
    {
      return path + "/" + name;
    }

    /**
     * Writes the parameters as read (a copy of @p source) and with all
     * defaults. Collective.
     *
     * @throws InputError on all ranks if the files cannot be written.
     */
    void
    write_parameters(const dealii::ParameterHandler &prm,
                     const std::string &source) const;

  private:
    std::string path;
    std::string from_checkpoint;
    MPI_Comm communicator;
  };
} // namespace coapt

#endif
