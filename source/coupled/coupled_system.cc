#include <deal.II/base/mpi.h>

#include <coapt/coupled/coupled_system.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;

  template <int dim>
  CoupledSystem<dim>::CoupledSystem(FluidOperator<dim> &fluid,
                                    const SolidOperator<dim> &solid,
                                    CouplingPoints<dim> &points,
                                    const std::vector<bool> &pinned,
                                    const ImmersionParameters &parameters,
                                    const double solid_density,
                                    const double fluid_density,
                                    Timing &timing,
                                    MPI_Comm communicator)
    : fluid(fluid)
    , solid(solid)
    , points(points)
    , pinned(pinned)
    , parameters(parameters)
    , solid_density(solid_density)
    , fluid_density(fluid_density)
    , communicator(communicator)
    , timing(timing)
    , sections({timing.section("Waiting"),
                timing.section("Fluid nodes"),
                timing.section("Ghost exchange"),
                timing.section("Point exchange"),
                timing.section("Solid exchange"),
                timing.section("Fluid"),
                timing.section("Coupling"),
                timing.section("Solid"),
                timing.section("Chordae"),
                timing.section("Contact"),
                timing.section("Coupling weights")})
    , nodes(solid.n_nodes(), dim, communicator)
    , X(dim * solid.n_nodes())
    , V(dim * solid.n_nodes())
    , solid_force(dim * solid.n_nodes())
    , coupling_impulse(dim * solid.n_nodes(), 0.)
  {
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_load(const SolidLoad &load)
  {
    loads.push_back(load);
  }



  template <int dim>
  void
  CoupledSystem<dim>::set_impulse(const SolidImpulse &impulse)
  {
    this->impulse = impulse;
    impulse_force.assign(X.size(), 0.);
    impulse_start.assign(X.size(), 0.);
  }



  template <int dim>
  void
  CoupledSystem<dim>::set_motion(const HeldMotion &motion)
  {
    this->motion = motion;
  }



  template <int dim>
  void
  CoupledSystem<dim>::rhs(const double t, const double *y, double *y_dot)
  {
    const StateLayout<dim> &at = state_layout;
    gather_inputs(y);
    add_fluid_forces(t, y + at.pressure(), y_dot + at.pressure());
    add_coupling(y + at.multiplier(), y_dot + at.multiplier());
    add_fluid_within(y + at.pressure(), y_dot + at.pressure());
    add_solid_forces();
    add_loads(t);
    add_impulse();
    finish_solid(y_dot + at.position(), y_dot + at.solid_velocity());
    finish_fluid(t, y_dot + at.velocity());
  }



  template <int dim>
  void
  CoupledSystem<dim>::gather_inputs(const double *y)
  {
    wait_for_others();
    {
      const auto scope = timing.scope(sections.solid_exchange);
      nodes.gather(y + state_layout.position(), X.data());
      nodes.gather(y + state_layout.solid_velocity(), V.data());
    }
    // as FluidOperator::gather(), with a time for each part; so finish_fluid()
    const auto scope = timing.scope(sections.fluid_nodes);
    std::copy_n(y + state_layout.velocity(),
                dim * state_layout.n_fluid_nodes,
                fluid_velocity.data());
    {
      const auto exchange = timing.scope(sections.ghost_exchange);
      fluid.numbering().update_ghosts(fluid_velocity.data());
    }
    fluid.numbering().interpolate_hanging_nodes(fluid_velocity.data());
  }



  template <int dim>
  void
  CoupledSystem<dim>::wait_for_others() const
  {
    const auto scope = timing.scope(sections.waiting);
    MPI_Barrier(communicator);
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_fluid_forces(const double t,
                                       const double *pressure,
                                       double *pressure_rate)
  {
    const auto scope = timing.scope(sections.fluid);
    std::fill(fluid_force.begin(), fluid_force.end(), 0.);
    fluid.add_forces(
      t, fluid_velocity.data(), pressure, fluid_force.data(), pressure_rate);
    if (sink)
      sink->add_rate(pressure, pressure_rate);
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_coupling(const double *multiplier,
                                   double *multiplier_rate)
  {
    const auto scope = timing.scope(sections.coupling);
    std::fill(solid_force.begin(), solid_force.end(), 0.);
    points.add_forces(stage == 0 ? first_coefficients : coefficients,
                      fluid_velocity.data(),
                      V.data(),
                      multiplier,
                      fluid_force.data(),
                      solid_force.data(),
                      multiplier_rate);
    accumulate_coupling_impulse();
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_fluid_within(const double *pressure,
                                       double *pressure_rate)
  {
    const auto scope = timing.scope(sections.coupling);
    if (within)
      within->add(pressure, V.data(), solid_force.data(), pressure_rate);
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_solid_forces()
  {
    const auto scope = timing.scope(sections.solid);
    solid.add_forces(X.data(), V.data(), solid_force.data());
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_loads(const double t)
  {
    const auto scope = timing.scope(sections.loads);
    for (const SolidLoad &load : loads)
      load(t, X.data(), V.data(), solid_force.data());
  }



  template <int dim>
  void
  CoupledSystem<dim>::add_impulse()
  {
    // The same on all ranks, whose forces are summed.
    if (!impulse_force.empty())
      for (unsigned int i = dim * nodes.begin(), n = 0;
           n < dim * nodes.n_owned();
           ++i, ++n)
        solid_force[i] += impulse_force[i];
  }



  template <int dim>
  void
  CoupledSystem<dim>::finish_solid(double *position_rate, double *velocity_rate)
  {
    wait_for_others();
    const auto scope = timing.scope(sections.solid_exchange);
    nodes.sum_owned(solid_force.data(), velocity_rate);
    const unsigned int begin = nodes.begin();
    for (unsigned int n = 0; n < nodes.n_owned(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        {
          // of held nodes zero, unless they are moved
          position_rate[dim * n + d] = V[dim * (begin + n) + d];
          velocity_rate[dim * n + d] = pinned[begin + n]
            ? 0.
            : velocity_rate[dim * n + d] / solid.mass()[begin + n];
        }
  }



  template <int dim>
  void
  CoupledSystem<dim>::finish_fluid(const double t, double *acceleration)
  {
    const auto scope = timing.scope(sections.fluid_nodes);
    fluid.numbering().condense_hanging_nodes(fluid_force.data());
    {
      const auto exchange = timing.scope(sections.ghost_exchange);
      fluid.numbering().add_ghosts(fluid_force.data());
    }
    fluid.divide_by_mass(fluid_force.data(), acceleration);
    fluid.set_boundary_acceleration(t, acceleration);
  }



  template <int dim>
  void
  CoupledSystem<dim>::finish_step(const double t, double *y)
  {
    // ERKStep evaluates the first stage of the next step right after this.
    stage              = 0;
    first_coefficients = coefficients;
    if (motion)
      move_held_nodes(t, y);

    const StateLayout<dim> &at = state_layout;
    nodes.gather(y + at.position(), X.data());
    if (impulse)
      update_impulse(y);
    const auto scope = timing.scope(sections.weights);
    bool found       = points.update(fluid, X.data(), y + at.multiplier());
    if (within && !within->update(fluid, X.data()))
      found = false;
    points_left = dealii::Utilities::MPI::max(found ? 0 : 1, communicator);
  }



  template <int dim>
  void
  CoupledSystem<dim>::update_impulse(const double *y)
  {
    const auto scope = timing.scope(sections.contact);
    nodes.gather(y + state_layout.solid_velocity(), V.data());
    const std::vector<double> before = V;
    impulse(X.data(), V.data(), step_length);
    for (unsigned int i = 0; i < V.size(); ++i)
      {
        impulse_work += impulse_force[i] * (X[i] - impulse_start[i]);
        impulse_force[i] =
          solid.mass()[i / dim] * (V[i] - before[i]) / step_length;
      }
    impulse_start = X;
  }



  template <int dim>
  void
  CoupledSystem<dim>::move_held_nodes(const double t, double *y)
  {
    const StateLayout<dim> &at = state_layout;
    nodes.gather(y + at.position(), X.data());
    nodes.gather(y + at.solid_velocity(), V.data());
    const std::vector<double> before = V;
    motion(t, X.data(), V.data());
    std::vector<double> force = solid_force;
    nodes.sum(force.data());
    // What holds a node gives it its kinetic energy, and moves it against the
    // forces, which are those of the last stage.
    for (unsigned int i = 0; i < V.size(); ++i)
      if (pinned[i / dim])
        motion_work += 0.5 * (V[i] + before[i]) *
          (solid.mass()[i / dim] * (V[i] - before[i]) - step_length * force[i]);
    const unsigned int begin = dim * nodes.begin(), n = dim * nodes.n_owned();
    std::copy_n(X.data() + begin, n, y + at.position());
    std::copy_n(V.data() + begin, n, y + at.solid_velocity());
  }



  template <int dim>
  void
  CoupledSystem<dim>::begin_step(const double dt)
  {
    const double relaxation_time = parameters.relaxation_steps * dt;
    begin_step(dt,
               relaxation_coefficients(solid_density,
                                       fluid_density,
                                       relaxation_time,
                                       parameters.damping_ratio));
    tau = relaxation_time;
  }



  template <int dim>
  void
  CoupledSystem<dim>::begin_step(const double dt,
                                 const RelaxationCoefficients &coefficients)
  {
    if (step_length == 0)
      first_coefficients = coefficients;
    step_length        = dt;
    tau                = 0;
    this->coefficients = coefficients;
  }



  template <int dim>
  void
  CoupledSystem<dim>::accumulate_coupling_impulse()
  {
    // At this point of the evaluation solid_force holds the coupling alone.
    // Of the five stages of KG5(3), the first and the last enter the step. The
    // first is kept until the last, for it is evaluated twice where the
    // integration starts anew, and before the length of the step is known.
    if (stage == 0)
      first_stage_force = solid_force;
    else if (stage == 4)
      for (unsigned int i = 0; i < solid_force.size(); ++i)
        coupling_impulse[i] +=
          step_length * (0.25 * first_stage_force[i] + 0.75 * solid_force[i]);
    ++stage;
  }



  template <int dim>
  std::vector<double>
  CoupledSystem<dim>::take_coupling_impulse()
  {
    std::vector<double> result = coupling_impulse;
    nodes.sum(result.data());
    std::fill(coupling_impulse.begin(), coupling_impulse.end(), 0.);
    return result;
  }



  template <int dim>
  void
  CoupledSystem<dim>::update_layout()
  {
    state_layout.n_fluid_nodes = fluid.n_owned_nodes();
    state_layout.n_fluid_cells = fluid.n_owned_cells();
    state_layout.n_solid_nodes = nodes.n_owned();
    state_layout.n_points      = points.n_owned();
    fluid_velocity.resize(dim * fluid.n_local_nodes());
    fluid_force.resize(dim * fluid.n_local_nodes());
    stage = 0;
  }



  template <int dim>
  void
  CoupledSystem<dim>::distribute_points(const double *positions,
                                        std::vector<double> &multiplier)
  {
    points.distribute(fluid, positions, multiplier);
    if (within)
      within->update(fluid, positions);
  }



  template <int dim>
  std::vector<double>
  CoupledSystem<dim>::state_at_rest(
    const std::vector<Point<dim>> &reference_points)
  {
    for (unsigned int n = 0; n < reference_points.size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        X[dim * n + d] = reference_points[n][d];
    std::vector<double> multiplier;
    distribute_points(X.data(), multiplier);
    update_layout();

    std::vector<double> y(state_layout.size(), 0.);
    std::copy_n(X.data() + dim * nodes.begin(),
                dim * nodes.n_owned(),
                y.data() + state_layout.position());
    return y;
  }



  template <int dim>
  void
  CoupledSystem<dim>::redistribute_points(std::vector<double> &y)
  {
    const auto scope                    = timing.scope(sections.point_exchange);
    const std::vector<double> positions = solid_positions(y.data());
    std::vector<double> multiplier(y.begin() + state_layout.multiplier(),
                                   y.end());
    distribute_points(positions.data(), multiplier);
    y.resize(state_layout.multiplier());
    y.insert(y.end(), multiplier.begin(), multiplier.end());
    update_layout();
    points_left = false;
  }



  template <int dim>
  bool
  CoupledSystem<dim>::adapt(
    FluidGrid<dim> &grid,
    const typename FluidGrid<dim>::WantedLevel &wanted_level,
    std::vector<double> &y)
  {
    const auto at = state_layout;
    std::vector<double> velocity(y.begin(), y.begin() + at.pressure());
    std::vector<double> pressure(y.begin() + at.pressure(),
                                 y.begin() + at.position());
    if (!grid.adapt(wanted_level, fluid, velocity, pressure))
      return false;

    const std::vector<double> rest(y.begin() + at.position(), y.end());
    y = velocity;
    y.insert(y.end(), pressure.begin(), pressure.end());
    y.insert(y.end(), rest.begin(), rest.end());
    update_layout();
    redistribute_points(y);
    return true;
  }



  template <int dim>
  std::vector<double>
  CoupledSystem<dim>::solid_positions(const double *y) const
  {
    std::vector<double> result(X.size());
    nodes.gather(y + state_layout.position(), result.data());
    return result;
  }



  template <int dim>
  std::vector<double>
  CoupledSystem<dim>::solid_velocities(const double *y) const
  {
    std::vector<double> result(V.size());
    nodes.gather(y + state_layout.solid_velocity(), result.data());
    return result;
  }



  template <int dim>
  std::vector<double>
  CoupledSystem<dim>::local_velocity(const double *y) const
  {
    std::vector<double> result(dim * fluid.n_local_nodes());
    fluid.gather(y + state_layout.velocity(), result.data());
    return result;
  }



  template <int dim>
  double
  CoupledSystem<dim>::load_power(const double t, const double *y) const
  {
    const std::vector<double> X_all = solid_positions(y);
    const std::vector<double> V_all = solid_velocities(y);
    std::vector<double> F(X_all.size(), 0.);
    for (const SolidLoad &load : loads)
      load(t, X_all.data(), V_all.data(), F.data());
    double power = 0;
    for (unsigned int i = 0; i < F.size(); ++i)
      power += F[i] * V_all[i];
    return dealii::Utilities::MPI::sum(power, communicator);
  }



  template <int dim>
  double
  CoupledSystem<dim>::driving_power(const double t, const double *y) const
  {
    const std::vector<double> u     = local_velocity(y);
    const std::vector<double> V_all = solid_velocities(y);
    std::vector<double> force(u.size(), 0.), solid_reaction(V_all.size());
    std::vector<double> rate(
      std::max(state_layout.n_fluid_cells, dim * state_layout.n_points));
    fluid.add_forces(
      t, u.data(), y + state_layout.pressure(), force.data(), rate.data());
    points.add_forces(coefficients,
                      u.data(),
                      V_all.data(),
                      y + state_layout.multiplier(),
                      force.data(),
                      solid_reaction.data(),
                      rate.data());
    fluid.sum_forces(force.data());
    return fluid.driving_power(t, u.data(), force.data());
  }



  template class CoupledSystem<2>;
  template class CoupledSystem<3>;
} // namespace coapt
