#ifndef coapt_base_run_parameters_h
#define coapt_base_run_parameters_h

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** Whether a run goes on from the checkpoint of an earlier one. */
  enum class Resume
  {
    never,
    if_possible,
    always
  };

  /** How long to run, and what to write where. Subsections Time and Output. */
  struct RunParameters
  {
    /** The run covers the times from 0 to this (s). */
    double end_time = 0.1;

    /** Steps after which it ends even before that, zero for no such end. */
    unsigned long max_steps = 0;

    /** Time between two rows of the statistics (s). */
    double output_interval = 1e-3;

    /** Time between two sets of field files (s), zero for none. */
    double fields_interval = 5e-3;

    /** Whether to write the load of the blood on the leaflets at each output
     * interval. */
    bool surface_load = false;

    /** Planes through which the flow of blood is measured: a point (m), and a
     * normal of any length. */
    std::vector<std::array<double, 6>> flow_planes;

    /** Folder for all results. */
    std::string output_folder = "output";

    /** Whether the folder may hold the results of an earlier run. */
    bool overwrite = false;

    /** Whether to go on from the checkpoint in the folder. */
    Resume resume = Resume::never;

    /** Wall time between two checkpoints (s), zero for none. */
    double checkpoint_interval = 600;

    /** Whether a run that has come to time @p t (s) in @p steps steps is at
     * its end. */
    bool
    is_over(const double t, const unsigned long steps) const;

    /** Declares all parameters with their defaults. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** "to T s": the end of the run in words. */
    std::string
    until() const;

    /** Throws InputError if a run cannot go on from @p time (s), for it is past
     * its end. */
    void
    check_end_time(const double time) const;

    /** Declares those of checkpoints, for what can go on from them. */
    static void
    declare_checkpoints(dealii::ParameterHandler &prm);

    /** Reads them. */
    void
    parse_checkpoints(dealii::ParameterHandler &prm);

    /**
     * Reads the declared parameters.
     *
     * @throws InputError if an interval exceeds what can be resolved.
     */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };
} // namespace coapt

#endif
