#include <coapt/coupled/coupled_system.h>

#include <algorithm>

// What of CoupledSystem a run needs that goes on from a checkpoint.
namespace coapt
{
  template <int dim>
  SystemSnapshot
  CoupledSystem<dim>::snapshot(const double *y) const
  {
    SystemSnapshot result;
    result.positions  = solid_positions(y);
    result.velocities = solid_velocities(y);
    result.multiplier = points.all_multipliers(
      {y + state_layout.multiplier(), y + state_layout.size()});
    result.active        = points.active_points();
    result.impulse_force = impulse_force;
    result.impulse_start = impulse_start;
    result.impulse_work  = impulse_work;
    result.motion_work   = motion_work;
    result.step_length   = step_length;
    result.points_left   = points_left;
    return result;
  }



  template <int dim>
  std::vector<double>
  CoupledSystem<dim>::restore(const SystemSnapshot &snapshot,
                              const std::vector<double> &velocity,
                              const std::vector<double> &pressure)
  {
    impulse_force = snapshot.impulse_force;
    impulse_start = snapshot.impulse_start;
    impulse_work  = snapshot.impulse_work;
    motion_work   = snapshot.motion_work;
    points_left   = snapshot.points_left;
    begin_step(snapshot.step_length);

    std::vector<double> multiplier;
    points.set_active(snapshot.active);
    points.distribute_all(fluid,
                          snapshot.positions.data(),
                          snapshot.multiplier,
                          multiplier);
    if (within)
      within->update(fluid, snapshot.positions.data());
    update_layout();

    std::vector<double> y = velocity;
    y.insert(y.end(), pressure.begin(), pressure.end());
    for (const auto &field : {snapshot.positions, snapshot.velocities})
      y.insert(y.end(),
               field.begin() + dim * nodes.begin(),
               field.begin() + dim * (nodes.begin() + nodes.n_owned()));
    y.insert(y.end(), multiplier.begin(), multiplier.end());
    return y;
  }



  template SystemSnapshot
  CoupledSystem<2>::snapshot(const double *) const;
  template SystemSnapshot
  CoupledSystem<3>::snapshot(const double *) const;
  template std::vector<double>
  CoupledSystem<2>::restore(const SystemSnapshot &,
                            const std::vector<double> &,
                            const std::vector<double> &);
  template std::vector<double>
  CoupledSystem<3>::restore(const SystemSnapshot &,
                            const std::vector<double> &,
                            const std::vector<double> &);
} // namespace coapt
