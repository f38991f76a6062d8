#ifndef coapt_flow_flow_run_h
#define coapt_flow_flow_run_h

#include <coapt/base/log.h>
#include <coapt/flow/flow_audit.h>
#include <coapt/flow/flow_errors.h>
#include <coapt/flow/flow_fields.h>
#include <coapt/flow/flow_model.h>
#include <coapt/flow/flow_sampler.h>
#include <coapt/flow/immersed_bodies.h>
#include <coapt/flow/obstacle_force.h>
#include <coapt/io/checkpoint_folder.h>
#include <coapt/io/output_folder.h>
#include <coapt/io/statistics.h>
#include <coapt/time/explicit_integrator.h>
#include <coapt/time/step_control.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  /** What a run of one flow cost and gave. */
  struct FlowResult
  {
    unsigned int cells  = 0;
    double cell_size    = 0; // m, outside the patch
    unsigned long steps = 0;
    double wall_seconds = 0;
    FlowErrors errors;

    /** Further figures by name with unit: the deviation from reference
     * values, and mean, range and frequency of recorded signals. */
    std::vector<std::pair<std::string, double>> figures;
  };

  /** One flow, with the bodies in it, at one level, from time 0 to the end
   * time. */
  template <int dim>
  class FlowRun
  {
  public:
    /** Builds the flow; @p label names it in lines of progress, and
     * @p reference is what the velocity is compared with. Throws InputError.
     * Writes nothing. Collective. */
    FlowRun(const FlowParameters &parameters,
            const unsigned int level,
            const std::string &label,
            const std::vector<ReferenceValue<dim>> &reference,
            Log &log,
            MPI_Comm communicator);

    /** Runs and writes statistics.csv, fields and profiles into @p folder.
     * Throws NumericalError if the state is not finite. Collective. */
    FlowResult
    run(const OutputFolder &folder);

  private:
    using Row = std::vector<Statistics::Entry>;

    /** Where the flow is recorded over time. */
    struct Files
    {
      Statistics statistics;
      FlowFields<dim> fields;
      double next_fields = 0;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &statistics &fields &next_fields;
      }
    };

    /** Takes a sample and writes what is due. */
    void
    record(const OutputFolder &folder, Files &files);

    /** Whether the run is at its end. */
    bool
    is_over() const;

    /** Writes a checkpoint. */
    void
    save(CheckpointFolder &checkpoints, Files &files);

    /** Goes on from the checkpoint in @p folder; throws InputError if it is of
     * another flow. */
    void
    load(const std::string &folder, Files &files);

    /** Saves or restores what is the same on all ranks. */
    template <class Archive>
    void
    exchange(Archive &archive, Files &files);

    /** What a checkpoint must have in common with this run: sizes, and what
     * there are columns of. */
    std::vector<std::size_t>
    sizes() const;

    /** A step, at most as long as @p time_left (s). */
    void
    advance(const double time_left);

    /** Length limits of the next steps. */
    void
    update_step_limits();

    /** What is recorded of the fluid at each output. */
    Row
    sample() const;

    /** Adds what is recorded of the bodies. */
    void
    add_bodies(Row &row);

    /** Adds the books of energy of a fluid without bodies. */
    void
    add_energy(Row &row);

    /** Logs what the last row says of energy. */
    void
    log_energy();

    /** Adds the forces on the obstacle, or their coefficients. */
    void
    add_forces(Row &row) const;

    /** Adds the powers that are dissipated. */
    void
    add_dissipation(Row &row) const;

    /** Throws NumericalError if the state is not finite. */
    void
    check_finite() const;

    /** Logs a line unless the last one is less than a second old. */
    void
    report_progress(const double largest_velocity);

    void
    write_profiles(const OutputFolder &folder) const;

    FlowResult
    result() const;

    /** Largest deviation from the reference values (m/s). */
    double
    deviation() const;

    /** Wall time since the construction (s). */
    double
    wall_time() const;

    FlowParameters parameters;
    std::string label;
    std::vector<ReferenceValue<dim>> reference;
    Log &log;
    FlowModel<dim> model;
    std::unique_ptr<ImmersedBodies<dim>> bodies; // if there are any
    FlowAudit<dim> audit;                        // without bodies
    ObstacleForce<dim> obstacle_force;
    std::vector<dealii::Point<dim>> pressure_points;
    ExplicitIntegrator integrator;
    StepControl step_control;
    std::vector<double> state;
    unsigned int n_cells = 0; // of all ranks
    std::vector<double> times;
    std::vector<Row> rows;
    FlowErrors errors;
    std::chrono::steady_clock::time_point start, last_line;
    double earlier_wall = 0; // s, of the runs that this one continues
  };
} // namespace coapt

#endif
