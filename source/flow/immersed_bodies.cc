#include <coapt/base/exceptions.h>
#include <coapt/base/first_rank.h>
#include <coapt/flow/immersed_bodies.h>
#include <coapt/flow/number_lists.h>
#include <coapt/io/fluid_piece.h>
#include <coapt/time/stability_limit.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    template <int dim>
    StripShape<dim>
    strip_shape(const BodyParameters &body, const FlowParameters &flow)
    {
      StripShape<dim> shape;
      shape.begin                  = to_point<2>(body.begin);
      shape.end                    = to_point<2>(body.end);
      const Tensor<1, 2> along     = shape.end - shape.begin;
      const Tensor<1, 2> direction = body.thickness_direction.empty()
        ? Tensor<1, 2>({-along[1], along[0]})
        : Tensor<1, 2>(
            {body.thickness_direction[0], body.thickness_direction[1]});
      shape.thickness = body.thickness / direction.norm() * direction;
      shape.bow       = body.bow;
      if (dim == 3)
        {
          shape.z_lower = flow.lower[2];
          shape.z_upper = flow.upper[2];
        }
      return shape;
    }

    template <int dim>
    ShapedBody<dim>
    make_body(const BodyParameters &body,
              const FlowParameters &flow,
              const double size)
    {
      if constexpr (dim == 2)
        {
          if (body.shape == "disc")
            return disc_body(to_point<2>(body.center), body.radius, size);
          if (body.shape == "ring")
            return ring_body(to_point<2>(body.center),
                             body.radius,
                             body.width,
                             size);
        }
      return strip_body(strip_shape<dim>(body, flow),
                        size,
                        flow.immersed->quadratic);
    }

    template <int dim>
    Point<dim>
    node_position(const unsigned int node, const std::vector<double> &X)
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = X[dim * node + d];
      return x;
    }

    template <int dim>
    std::vector<Point<dim>>
    node_positions(const std::vector<double> &X)
    {
      std::vector<Point<dim>> result;
      for (unsigned int n = 0; n < X.size() / dim; ++n)
        result.push_back(node_position<dim>(n, X));
      return result;
    }

    /** The letter of a direction. */
    std::string
    axis(const unsigned int d)
    {
      return std::string(1, "xyz"[d]);
    }
  } // namespace



  template <int dim>
  ImmersedBodies<dim>::ImmersedBodies(const FlowParameters &parameters,
                                      FlowModel<dim> &model)
    : parameters(parameters)
    , model(model)
    , body(make_bodies())
    , solid(body.mesh,
            parameters.immersed->solid,
            body.fibre,
            {},
            model.communicator)
    , points(body.mesh, coupling_lattice(), model.communicator)
    , system(model.fluid(),
             solid,
             points,
             held_nodes(),
             parameters.immersed->coupling,
             parameters.immersed->solid.density,
             parameters.fluid.density,
             timing,
             model.communicator)
    , held(held_nodes())
    , solid_frequency(solid, body.mesh, held, model.communicator)
    , audit(system, model.fluid(), solid, points)
  {
    check_inside();
    if (!parameters.immersed->has_pressure_within)
      system.set_within(&within.emplace(body.mesh, points));
    if (parameters.immersed->couples_surface)
      system.set_sink(&enclosed.emplace(body.mesh,
                                        model.fluid(),
                                        model.smallest_cell_size(),
                                        model.communicator));
    if (parameters.immersed->damping_rate > 0)
      add_damping();
    if (parameters.immersed->has_contact)
      add_contact();
    for (const auto &coordinates : parameters.immersed->displacement_points)
      displacement_points.push_back(find_material_point(
        body.mesh, to_point<dim>(coordinates), "Body/Displacement points"));
    for (const CellRange &range : ranges)
      initial_volumes.push_back(
        std::accumulate(solid.cell_volumes().begin() + range.first,
                        solid.cell_volumes().begin() + range.second,
                        0.));
  }



  template <int dim>
  ShapedBody<dim>
  ImmersedBodies<dim>::make_bodies()
  {
    const double size =
      parameters.immersed->element_size * model.smallest_cell_size();
    ShapedBody<dim> all;
    for (const BodyParameters &one : parameters.immersed->bodies)
      {
        const unsigned int begin = all.mesh.cells.size();
        append(all, make_body<dim>(one, parameters, size));
        ranges.emplace_back(begin, all.mesh.cells.size());
      }
    return all;
  }



  template <int dim>
  std::vector<SamplePoint<dim>>
  ImmersedBodies<dim>::coupling_lattice() const
  {
    const ImmersedParameters &immersed = *parameters.immersed;
    const double h                     = model.smallest_cell_size();
    std::vector<SamplePoint<dim>> all;
    for (const CellRange &range : ranges)
      {
        // one body at a time: the surface of another may cross it
        SimplexMesh<dim> mesh;
        mesh.points = body.mesh.points;
        mesh.cells.assign(body.mesh.cells.begin() + range.first,
                          body.mesh.cells.begin() + range.second);
        const double spacing = immersed.coupling.spacing * h;
        auto samples         = immersed.couples_surface
                  ? surface_lattice(mesh, spacing, h)
                  : simplex_lattice(mesh, spacing);
        for (SamplePoint<dim> &sample : samples)
          sample.cell += range.first;
        all.insert(all.end(), samples.begin(), samples.end());
      }
    return all;
  }



  template <int dim>
  void
  ImmersedBodies<dim>::add_damping()
  {
    system.add_load([this](double, const double *, const double *V, double *F) {
      // the loads of all ranks are summed up
      if (!is_first_rank(model.communicator))
        return;
      for (unsigned int n = 0; n < solid.n_nodes(); ++n)
        for (unsigned int d = 0; d < dim; ++d)
          F[dim * n + d] -= parameters.immersed->damping_rate *
            solid.mass()[n] * V[dim * n + d];
    });
  }



  template <int dim>
  void
  ImmersedBodies<dim>::add_contact()
  {
    const ImmersedParameters &immersed = *parameters.immersed;
    const double h                     = model.smallest_cell_size();
    ContactParameters law;
    law.clearance     = immersed.clearance * h;
    law.friction      = immersed.friction;
    law.max_stiffness = std::numeric_limits<double>::max();
    law.search_margin = h;
    double thinnest   = std::numeric_limits<double>::max();
    for (const BodyParameters &one : immersed.bodies)
      thinnest = std::min(thinnest,
                          one.shape == "disc"     ? 2 * one.radius
                            : one.shape == "ring" ? one.width
                                                  : one.thickness);
    contact.emplace(body.mesh,
                    outer_facets(body.mesh),
                    solid.mass(),
                    held,
                    law,
                    0.5 * thinnest,
                    model.communicator);
    system.set_impulse([this](const double *X, double *V, const double dt) {
      contact_impulse += dt * contact->apply_impulse(X, V, dt).normal_force;
    });
  }



  template <int dim>
  std::vector<bool>
  ImmersedBodies<dim>::held_nodes() const
  {
    const ScalarField<dim> held =
      scalar_field<dim>("Body/Held",
                        parameters.immersed->held,
                        parameters.named_constants());
    std::vector<bool> result;
    for (const Point<dim> &x : body.mesh.points)
      result.push_back(held && held(x, 0.) > 0);
    return result;
  }



  template <int dim>
  void
  ImmersedBodies<dim>::check_inside() const
  {
    const double tolerance = 1e-6 * model.smallest_cell_size();
    for (const Point<dim> &x : body.mesh.points)
      for (unsigned int d = 0; d < dim; ++d)
        if (x[d] < model.grid().lower()[d] - tolerance ||
            x[d] > model.grid().upper()[d] + tolerance)
          {
            std::ostringstream message;
            message << "Body: it reaches to " << axis(d) << " = " << x[d]
                    << " m, outside of the box, which is from "
                    << model.grid().lower()[d] << " to "
                    << model.grid().upper()[d] << " m";
            throw InputError(message.str());
          }
  }



  template <int dim>
  std::vector<double>
  ImmersedBodies<dim>::initial_state()
  {
    std::vector<double> y           = system.state_at_rest(body.mesh.points);
    const std::vector<double> fluid = model.initial_state();
    std::copy(fluid.begin(), fluid.end(), y.begin());
    const std::vector<double> X = system.solid_positions(y.data());
    last_volume                 = volume_behind_strips(X);
    if (enclosed)
      enclosed->update(X.data());
    return y;
  }



  template <int dim>
  void
  ImmersedBodies<dim>::begin_step(const double dt)
  {
    step_length = dt;
    system.begin_step(dt);
  }



  template <int dim>
  void
  ImmersedBodies<dim>::rhs(const double t, const double *y, double *y_dot)
  {
    system.rhs(t, y, y_dot);
  }



  template <int dim>
  void
  ImmersedBodies<dim>::finish_step(const double t, double *y)
  {
    system.finish_step(t, y);
  }



  template <int dim>
  bool
  ImmersedBodies<dim>::follow(const double t, std::vector<double> &y)
  {
    const unsigned int steps_between_audits = 10;
    if (++steps_since_audit >= steps_between_audits)
      take_audit(t, y.data());
    const unsigned int upper_x_side = 1;
    if (parameters.immersed->measures_leak)
      outflow += step_length *
        model.fluid().flux(upper_x_side, model.local_velocity(y.data()).data());
    if (!system.points_have_left())
      return false;
    system.redistribute_points(y);
    return true;
  }



  template <int dim>
  std::vector<StepLimit>
  ImmersedBodies<dim>::step_limits(const double *y)
  {
    const std::vector<double> X         = system.solid_positions(y);
    const auto bound                    = solid_frequency.update(X.data());
    const ImmersionParameters &coupling = parameters.immersed->coupling;
    // Without the fluid's pressure within, changes of volume of the solid drive
    // that pressure besides those of the fluid itself.
    const double faster = within
      ? std::sqrt(1 +
                  parameters.fluid.density / parameters.immersed->solid.density)
      : 1;
    return {{"fluid", model.fluid().max_stable_step() / faster},
            {"solid", kinnmark_gray_limit(bound.xi) / bound.omega},
            {"coupling",
             coupling.max_relaxation_time / coupling.relaxation_steps /
               parameters.step_safety}};
  }



  template <int dim>
  void
  ImmersedBodies<dim>::warn(const double *y, Log &log) const
  {
    const ImmersionParameters &coupling = parameters.immersed->coupling;
    const double density                = parameters.immersed->solid.density;
    coupling.warn_of_mass(points.largest_mass_ratio(model.fluid(), density),
                          density / parameters.fluid.density,
                          log);
    // Points of a surface are meant to be about one cell apart.
    if (parameters.immersed->couples_surface)
      return;
    const double h = model.smallest_cell_size();
    const double cells =
      deformed_spacing(body.mesh,
                       coupling.spacing * h,
                       node_positions<dim>(system.solid_positions(y))) /
      h;
    if (cells > 0.9)
      log.warn("stretched points",
               "coupling points are " + std::to_string(cells) +
                 " cells apart in the stretched bodies (above 0.9 fluid passes "
                 "through them): lower Coupling/Point spacing");
  }



  template <int dim>
  typename ImmersedBodies<dim>::Row
  ImmersedBodies<dim>::sample(const double t, const double *y)
  {
    const std::vector<double> X = system.solid_positions(y);
    const std::vector<double> V = system.solid_velocities(y);
    const double interval       = t - last_sample;
    last_sample                 = t;
    measure_force(interval, V);

    take_audit(t, y);
    const auto energies = audit.energies(y);
    Row row             = EnergyAudit<dim>::entries(audit.work(), energies);
    row.emplace_back("closure_error_J", audit.closure_error(energies));
    row.emplace_back("energy_error_relative", audit.relative_error(energies));
    for (unsigned int d = 0; d < dim; ++d)
      row.emplace_back("body_force_" + axis(d) + "_N", mean_force[d]);
    if (contact)
      {
        row.emplace_back("contact_force_N",
                         interval > 0 ? contact_impulse / interval : 0.);
        contact_impulse = 0;
      }
    for (unsigned int i = 0; i < displacement_points.size(); ++i)
      {
        const auto u = displacement(body.mesh, displacement_points[i], X);
        for (unsigned int d = 0; d < dim; ++d)
          row.emplace_back("displacement_" + std::to_string(i + 1) + "_" +
                             axis(d) + "_m",
                           u[d]);
      }
    add_shape_figures(row, X);
    if (parameters.immersed->measures_leak)
      add_leak(row, interval, X);
    return row;
  }



  template <int dim>
  std::vector<double>
  ImmersedBodies<dim>::restore(const SystemSnapshot &snapshot,
                               const std::vector<double> &fluid)
  {
    const auto pressure = fluid.begin() + dim * model.fluid().n_owned_nodes();
    const std::vector<double> y = system.restore(snapshot,
                                                 {fluid.begin(), pressure},
                                                 {pressure, fluid.end()});
    if (enclosed)
      enclosed->update(snapshot.positions.data());
    return y;
  }



  template <int dim>
  void
  ImmersedBodies<dim>::take_audit(const double t, const double *y)
  {
    steps_since_audit = 0;
    audit.sample(t, y);
    if (enclosed)
      enclosed->update(system.solid_positions(y).data());
  }



  template <int dim>
  void
  ImmersedBodies<dim>::measure_force(const double interval,
                                     const std::vector<double> &V)
  {
    // The fluid outside pushes the fluid that fills the body, too: what the
    // coupling takes from that is increased by the change of its momentum.
    const std::vector<double> impulse = system.take_coupling_impulse();
    const double ratio =
      parameters.fluid.density / parameters.immersed->solid.density;
    Tensor<1, dim> sum, momentum;
    for (unsigned int n = 0; n < solid.n_nodes(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        {
          sum[d] += impulse[dim * n + d];
          momentum[d] += ratio * solid.mass()[n] * V[dim * n + d];
        }
    mean_force = Tensor<1, dim>();
    if (interval > 0)
      mean_force = (sum + momentum - last_momentum) / interval;
    last_momentum = momentum;
  }



  template <int dim>
  void
  ImmersedBodies<dim>::add_shape_figures(Row &row,
                                         const std::vector<double> &X) const
  {
    SimplexMesh<dim> deformed         = body.mesh;
    deformed.points                   = node_positions<dim>(X);
    const std::vector<double> volumes = signed_volumes(deformed);
    for (unsigned int b = 0; b < ranges.size(); ++b)
      {
        double volume = 0;
        Tensor<1, dim> moment;
        for (unsigned int c = ranges[b].first; c < ranges[b].second; ++c)
          {
            volume += volumes[c];
            for (const unsigned int node : deformed.cells[c])
              moment += volumes[c] / (dim + 1) * deformed.points[node];
          }
        const std::string name = "body_" + std::to_string(b + 1) + "_";
        row.emplace_back(name + "volume_change",
                         volume / initial_volumes[b] - 1);
        for (unsigned int d = 0; d < dim; ++d)
          row.emplace_back(name + "centroid_" + axis(d) + "_m",
                           moment[d] / volume);
      }
  }



  template <int dim>
  double
  ImmersedBodies<dim>::volume_behind_strips(const std::vector<double> &X) const
  {
    return (volume_behind<dim>(body.lower_face, X) +
            volume_behind<dim>(body.upper_face, X)) /
      2;
  }



  template <int dim>
  void
  ImmersedBodies<dim>::add_leak(Row &row,
                                const double interval,
                                const std::vector<double> &X)
  {
    const double volume = volume_behind_strips(X);
    const double leaked = outflow - (volume - last_volume);
    row.emplace_back("outflow_m3_per_s",
                     interval > 0 ? outflow / interval : 0.);
    row.emplace_back("leak_m3_per_s", interval > 0 ? leaked / interval : 0.);
    outflow     = 0;
    last_volume = volume;
  }



  template <int dim>
  void
  ImmersedBodies<dim>::write_fields(const std::string &folder,
                                    const double t,
                                    const double *y)
  {
    const std::vector<double> X = system.solid_positions(y);
    const std::vector<double> V = system.solid_velocities(y);
    const CellResults cells     = solid.cell_results(X.data());
    const std::string file = numbered("bodies", field_files.size()) + ".vtu";
    field_files.emplace_back(t, file);
    if (!is_first_rank(model.communicator))
      return;

    std::vector<Point<3>> positions;
    std::vector<double> displacements, velocities;
    for (unsigned int n = 0; n < body.mesh.points.size(); ++n)
      {
        positions.emplace_back();
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int i = dim * n + d % dim;
            if (d < dim)
              positions.back()[d] = X[i];
            displacements.push_back(
              d < dim ? X[i] - body.mesh.points[n][d % dim] : 0.);
            velocities.push_back(d < dim ? V[i] : 0.);
          }
      }
    std::vector<unsigned int> connectivity;
    for (const auto &cell : body.mesh.cells)
      connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    VtuFile grid(positions,
                 connectivity,
                 dim == 2 ? VtuFile::CellType::triangle
                          : VtuFile::CellType::tetrahedron);
    grid.add_point_data("displacement", 3, displacements);
    grid.add_point_data("velocity", 3, velocities);
    grid.add_cell_data("von_mises", 1, cells.von_mises);
    grid.add_cell_data("max_principal_stress", 1, cells.principal_stress);
    grid.add_cell_data("max_log_strain", 1, cells.largest_strain);
    grid.add_cell_data("volume_ratio", 1, cells.volume_ratio);
    grid.write(folder + "/" + file);
    write_collection(folder + "/bodies.pvd", field_files);
  }

  template class ImmersedBodies<2>;
  template class ImmersedBodies<3>;
} // namespace coapt
