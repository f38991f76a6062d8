#ifndef coapt_flow_immersed_bodies_h
#define coapt_flow_immersed_bodies_h

#include <coapt/base/log.h>
#include <coapt/contact/facet_contact.h>
#include <coapt/coupled/coupled_system.h>
#include <coapt/coupled/enclosed_fluid.h>
#include <coapt/flow/flow_model.h>
#include <coapt/geometry/body_shapes.h>
#include <coapt/geometry/material_point.h>
#include <coapt/io/statistics.h>
#include <coapt/metrics/energy_audit.h>
#include <coapt/solid/largest_frequency.h>
#include <coapt/time/step_control.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  /**
   * The elastic bodies in a flow, and the coupled system that they make with
   * its fluid. A state is that of FlowModel, followed by positions and
   * velocities of the solid and the multiplier.
   */
  template <int dim>
  class ImmersedBodies
  {
  public:
    using Row = std::vector<Statistics::Entry>;

    /** Builds the bodies of @p parameters in the fluid of @p model. Throws
     * InputError, for example for a body outside of the box. Collective. */
    ImmersedBodies(const FlowParameters &parameters, FlowModel<dim> &model);

    ImmersedBodies(const ImmersedBodies &) = delete;

    /** The state at time 0: the fluid of FlowModel, bodies at rest. */
    std::vector<double>
    initial_state();

    /** What the coming step of length @p dt (s) needs to know. */
    void
    begin_step(const double dt);

    /** y' = f(t, y). Collective. */
    void
    rhs(const double t, const double *y, double *y_dot);

    /** Acts on the state after a step. Collective. */
    void
    finish_step(const double t, double *y);

    /** Due after each step, at time @p t: sums up the flow through the box, and
     * now and then energies. Gives coupling points that have left their rank
     * to others and returns whether there were any, for @p y is of another
     * length then. Collective. */
    bool
    follow(const double t, std::vector<double> &y);

    /** Limits of the step of all parts. Collective. */
    std::vector<StepLimit>
    step_limits(const double *y);

    /** Warns @p log of coupling points that are too far apart in bodies coupled
     * throughout, where these let fluid through (more than 0.9 cells), and of
     * more mass at a node of the fluid than steps are stable with. Collective.
     */
    void
    warn(const double *y, Log &log) const;

    /** The figures of the bodies at time @p t, forces and leak as means since
     * the last call. Collective. */
    Row
    sample(const double t, const double *y);

    /** The mean force of the fluid on the bodies (N) over the interval of the
     * last sample(). */
    const dealii::Tensor<1, dim> &
    force() const
    {
      return mean_force;
    }

    /** Adds a file of the bodies to those in @p folder. Collective. */
    void
    write_fields(const std::string &folder, const double t, const double *y);

    /** What the bodies need to go on from the state @p y, without the fluid and
     * without serialize(); right after sample(). Collective. */
    SystemSnapshot
    snapshot(const double *y) const
    {
      return system.snapshot(y);
    }

    /** The state with this @p snapshot and with the state @p fluid of
     * FlowModel. Collective. */
    std::vector<double>
    restore(const SystemSnapshot &snapshot, const std::vector<double> &fluid);

    /** Saves or restores what is the same on all ranks. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &solid_frequency &audit &steps_since_audit &step_length;
      archive &last_sample &outflow &last_volume &contact_impulse;
      archive &mean_force &last_momentum &field_files;
      if (contact)
        archive &*contact;
    }

    /** Numbers of nodes, of coupling points, of surfaces in contact and of
     * points with a displacement. */
    std::vector<std::size_t>
    sizes() const
    {
      return {body.mesh.points.size(),
              points.active_points().size(),
              contact.has_value(),
              displacement_points.size()};
    }

  private:
    /** Cells [begin, end) of one body. */
    using CellRange = std::pair<unsigned int, unsigned int>;

    ShapedBody<dim>
    make_bodies();

    /** Where the bodies are coupled with the fluid. */
    std::vector<SamplePoint<dim>>
    coupling_lattice() const;

    void
    add_damping();

    void
    add_contact();

    std::vector<bool>
    held_nodes() const;

    void
    check_inside() const;

    void
    add_shape_figures(Row &row, const std::vector<double> &X) const;

    void
    add_leak(Row &row, const double interval, const std::vector<double> &X);

    /** Samples the powers. */
    void
    take_audit(const double t, const double *y);

    void
    measure_force(const double interval, const std::vector<double> &V);

    /** Volume between the plane x = 0 and the strips. */
    double
    volume_behind_strips(const std::vector<double> &X) const;

    FlowParameters parameters;
    FlowModel<dim> &model;
    std::vector<CellRange> ranges;
    ShapedBody<dim> body;
    SolidOperator<dim> solid;
    CouplingPoints<dim> points;
    std::optional<FluidWithin<dim>> within;
    std::optional<EnclosedFluid<dim>> enclosed;
    Timing timing;
    CoupledSystem<dim> system;
    std::vector<bool> held;
    LargestFrequency<dim> solid_frequency;
    EnergyAudit<dim> audit;
    std::optional<FacetContact<dim>> contact;
    std::vector<MaterialPoint<dim>> displacement_points;
    std::vector<double> initial_volumes; // of the bodies

    unsigned int steps_since_audit = 0;
    double step_length             = 0;
    double last_sample             = 0; // time
    double outflow                 = 0; // since the last sample, m^3
    double last_volume             = 0; // behind the strips
    double contact_impulse         = 0; // since the last sample, N s
    dealii::Tensor<1, dim> mean_force, last_momentum;
    std::vector<std::pair<double, std::string>> field_files;
  };
} // namespace coapt

#endif
