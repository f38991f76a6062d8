#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/base/serialization.h>
#include <coapt/flow/flow_run.h>
#include <coapt/io/checkpoint_file.h>

#include <fstream>
#include <sstream>

// How a flow writes checkpoints and goes on from them. Its octree does not
// change, so each rank writes its own part of the fluid as it is.
namespace coapt
{
  namespace
  {
    const std::string kind = "flow";

    std::string
    fluid_in(const std::string &folder, MPI_Comm communicator)
    {
      return folder + "/fluid_" +
        std::to_string(dealii::Utilities::MPI::this_mpi_process(communicator));
    }

    void
    write(const std::string &file, const std::vector<double> &values)
    {
      std::ofstream out(file, std::ios::binary);
      out.write(reinterpret_cast<const char *>(values.data()),
                values.size() * sizeof(double));
      if (!out.flush())
        throw std::runtime_error(file + ": writing failed; is the disk full?");
    }

    void
    read(const std::string &file, std::vector<double> &values)
    {
      std::ifstream in(file, std::ios::binary);
      in.read(reinterpret_cast<char *>(values.data()),
              values.size() * sizeof(double));
      if (!in)
        throw std::runtime_error(file + ": cannot be read");
    }
  } // namespace



  template <int dim>
  std::vector<std::size_t>
  FlowRun<dim>::sizes() const
  {
    std::vector<std::size_t> result = {
      dealii::Utilities::MPI::n_mpi_processes(model.communicator),
      n_cells,
      dealii::Utilities::MPI::sum(model.fluid().n_owned_nodes(),
                                  model.communicator),
      pressure_points.size(),
      parameters.records_dissipation};
    if (bodies)
      for (const std::size_t size : bodies->sizes())
        result.push_back(size);
    return result;
  }



  template <int dim>
  template <class Archive>
  void
  FlowRun<dim>::exchange(Archive &archive, Files &files)
  {
    double wall = wall_time();
    archive &wall &integrator &step_control &audit &times &rows;
    archive &errors &files;
    if (bodies)
      archive &*bodies;
    if (Archive::is_loading::value)
      earlier_wall += wall - wall_time();
  }



  template <int dim>
  void
  FlowRun<dim>::save(CheckpointFolder &checkpoints, Files &files)
  {
    const std::vector<std::size_t> own = sizes();
    const std::string folder           = checkpoints.begin(
      200. * dealii::Utilities::MPI::sum(state.size(), model.communicator) +
        200. * rows.size() * rows[0].size() + 1e6,
      log);
    if (folder.empty())
      return;
    const std::size_t n_fluid =
      dim * model.fluid().n_owned_nodes() + model.fluid().n_owned_cells();
    write(fluid_in(folder, model.communicator),
          {state.begin(), state.begin() + n_fluid});
    const SystemSnapshot snapshot =
      bodies ? bodies->snapshot(state.data()) : SystemSnapshot();
    MPI_Barrier(model.communicator); // the sizes of all files count
    if (is_first_rank(model.communicator))
      {
        std::ostringstream out;
        boost::archive::binary_oarchive archive(out);
        const double time = integrator.time();
        archive << own << time << snapshot;
        exchange(archive, files);
        write_checkpoint_file(folder, kind, out.str());
      }
    checkpoints.finish(log);
  }



  template <int dim>
  void
  FlowRun<dim>::load(const std::string &folder, Files &files)
  {
    std::istringstream in(
      read_checkpoint_file(folder, kind, model.communicator));
    boost::archive::binary_iarchive archive(in);
    std::vector<std::size_t> found;
    double time = 0;
    SystemSnapshot snapshot;
    archive >> found >> time >> snapshot;
    if (found != sizes())
      throw InputError("the checkpoint in " + folder +
                       " is of another flow, or not of " +
                       std::to_string(sizes()[0]) + " process(es)");
    parameters.run.check_end_time(time);
    exchange(archive, files);
    if (!bodies)
      update_step_limits(); // whose parameters may have changed
    std::vector<double> fluid(dim * model.fluid().n_owned_nodes() +
                              model.fluid().n_owned_cells());
    read(fluid_in(folder, model.communicator), fluid);
    state = bodies ? bodies->restore(snapshot, fluid) : fluid;
    integrator.start(time, state);
    log.line(label + " goes on from " + folder + " at " + std::to_string(time) +
             " s");
  }



  template void
  FlowRun<2>::save(CheckpointFolder &, Files &);
  template void
  FlowRun<3>::save(CheckpointFolder &, Files &);
  template void
  FlowRun<2>::load(const std::string &, Files &);
  template void
  FlowRun<3>::load(const std::string &, Files &);
} // namespace coapt
