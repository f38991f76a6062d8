#include <deal.II/base/mpi.h>

#include <coapt/immersion/coupling_points.h>
#include <coapt/immersion/wall_offset.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  template <int dim>
  CouplingPoints<dim>::CouplingPoints(
    const SimplexMesh<dim> &mesh,
    const std::vector<SamplePoint<dim>> &points,
    MPI_Comm communicator)
    : CouplingPoints(mesh, NestedLattice<dim>{points, {}}, 0, communicator)
  {
  }



  template <int dim>
  CouplingPoints<dim>::CouplingPoints(const SimplexMesh<dim> &mesh,
                                      const NestedLattice<dim> &lattice,
                                      const double dense_cell,
                                      MPI_Comm communicator)
    : mesh(mesh)
    , points(lattice.points)
    , stand_in(lattice.stand_in)
    , dense_cell(dense_cell)
    , active(points.size(), true)
    , on_surface(!points.empty() && points[0].outwards.norm_square() > 0)
    , communicator(communicator)
    , solid_input(mesh.points.size())
    , solid_output(mesh.points.size())
  {
    std::fill_n(active.begin(), stand_in.size(), false);
  }



  template <int dim>
  typename CouplingPoints<dim>::Stencil
  CouplingPoints<dim>::unplaced_stencil(const unsigned int id) const
  {
    Stencil stencil;
    stencil.solid_nodes = mesh.cells[points[id].cell];
    stencil.volume      = points[id].volume;
    stencil.cell        = -1;
    stencil.scale       = 0;
    stencil.local.fill(0);
    std::copy(points[id].barycentric.begin(),
              points[id].barycentric.end(),
              stencil.solid_weights.begin());
    return stencil;
  }



  template <int dim>
  Point<dim>
  CouplingPoints<dim>::to_point(const Register &x)
  {
    Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = x[d];
    return point;
  }



  template <int dim>
  inline double
  CouplingPoints<dim>::dot(const Register &a, const Register &b)
  {
    const Register products = a * b;
    double sum              = 0;
    for (unsigned int d = 0; d < dim; ++d)
      sum += products[d];
    return sum;
  }



  template <int dim>
  void
  CouplingPoints<dim>::to_lanes(const double *x, std::vector<Lanes> &result)
  {
    for (unsigned int n = 0; n < result.size(); ++n)
      result[n].values = Node::load(x + dim * n);
  }



  template <int dim>
  inline typename CouplingPoints<dim>::Register
  CouplingPoints<dim>::solid_value(const Stencil &s,
                                   const std::vector<Lanes> &field)
  {
    Register value{};
    for (unsigned int a = 0; a < n_solid; ++a)
      value += s.solid_weights[a] * field[s.solid_nodes[a]].values;
    return value;
  }



  template <int dim>
  [[gnu::always_inline]] inline typename CouplingPoints<dim>::FluidWeights
  CouplingPoints<dim>::fluid_weights(const Stencil &s, const FluidWeights &free)
  {
    // 1 - x at the lower nodes and x at the upper ones in each direction
    FluidWeights weights = s.scale * free;
    for (unsigned int d = 0; d < dim; ++d)
      {
        FluidWeights at_zero, slope;
        for (unsigned int i = 0; i < n_fluid; ++i)
          {
            at_zero[i] = (i >> d) & 1 ? 0 : 1;
            slope[i]   = (i >> d) & 1 ? 1 : -1;
          }
        weights *= at_zero + s.local[d] * slope;
      }
    return weights;
  }



  template <int dim>
  inline typename CouplingPoints<dim>::FluidWeights
  CouplingPoints<dim>::free_nodes(const unsigned char constrained)
  {
    FluidWeights free{};
    for (unsigned int i = 0; i < n_fluid; ++i)
      free[i] = (constrained >> i) & 1 ? 0 : 1;
    return free;
  }



  template <int dim>
  std::vector<Point<dim>>
  CouplingPoints<dim>::positions(const double *X) const
  {
    std::vector<Lanes> nodes(mesh.points.size());
    to_lanes(X, nodes);
    std::vector<Point<dim>> result;
    for (unsigned int id = 0; id < points.size(); ++id)
      result.push_back(to_point(solid_value(unplaced_stencil(id), nodes)));
    return result;
  }



  template <int dim>
  void
  CouplingPoints<dim>::sort_by_cell(double *multiplier)
  {
    std::vector<unsigned int> order(stencils.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [this](const auto a, const auto b) {
      return std::make_pair(stencils[a].cell, ids[a]) <
        std::make_pair(stencils[b].cell, ids[b]);
    });
    const std::vector<Stencil> old_stencils = stencils;
    const std::vector<unsigned int> old_ids = ids;
    const std::vector<double> old_multiplier(multiplier,
                                             multiplier + dim * order.size());
    for (unsigned int q = 0; q < order.size(); ++q)
      {
        stencils[q] = old_stencils[order[q]];
        ids[q]      = old_ids[order[q]];
        std::copy_n(old_multiplier.data() + dim * order[q],
                    dim,
                    multiplier + dim * q);
      }
    updates_since_sorting = 0;
  }



  template <int dim>
  unsigned char
  CouplingPoints<dim>::constrained_nodes(const FluidOperator<dim> &fluid,
                                         const int cell)
  {
    unsigned char constrained = 0;
    for (unsigned int i = 0; i < n_fluid; ++i)
      {
        const unsigned int node = fluid.cell(cell).nodes[i];
        constrained |=
          (fluid.is_constrained_node(node) && !fluid.is_driven_node(node)) << i;
      }
    return constrained;
  }



  template <int dim>
  void
  CouplingPoints<dim>::find_runs(const FluidOperator<dim> &fluid)
  {
    runs.clear();
    int cell = -1;
    for (unsigned int q = 0; q < stencils.size(); ++q)
      if (stencils[q].cell == cell)
        runs.back().end = q + 1;
      else
        {
          cell = stencils[q].cell;
          runs.push_back({fluid.cell(cell).nodes,
                          constrained_nodes(fluid, cell),
                          false,
                          q,
                          q + 1});
        }
    mark_released_runs();
  }



  template <int dim>
  void
  CouplingPoints<dim>::mark_released_runs()
  {
    for (Run &run : runs)
      {
        run.released = false;
        for (unsigned int q = run.begin; q < run.end && !releases.empty(); ++q)
          {
            const Register &m = releases[ids[q]].values;
            run.released      = run.released || dot(m, m) > 0;
          }
      }
  }



  template <int dim>
  void
  CouplingPoints<dim>::set_release(
    const std::vector<dealii::Tensor<1, dim>> &directions)
  {
    releases.resize(directions.size());
    for (unsigned int id = 0; id < directions.size(); ++id)
      releases[id].values = Node::load(directions[id].begin_raw());
    mark_released_runs();
  }



  template <int dim>
  void
  CouplingPoints<dim>::rescale(Stencil &stencil,
                               const unsigned char constrained)
  {
    stencil.scale = 1;
    if (constrained == 0)
      return;
    const FluidWeights weights =
      fluid_weights(stencil, free_nodes(constrained));
    double sum = 0;
    for (unsigned int i = 0; i < n_fluid; ++i)
      sum += weights[i];
    // A point whose free weight is nearly nothing would move a far node by a
    // huge lever, so it counts as lying in the rigid wall.
    stencil.scale = sum > 1e-3 ? 1 / sum : 0.;
  }



  template <int dim>
  typename CouplingPoints<dim>::Register
  CouplingPoints<dim>::coupled_position(
    const unsigned int id,
    const Register &x,
    const typename FluidOperator<dim>::Cell &cell,
    const std::vector<Lanes> &nodes) const
  {
    const Tensor<1, dim> &N = points[id].outwards;
    // n ~ F^-T N with F = (edges now) (edges in the reference)^-1
    const auto &corners = mesh.cells[points[id].cell];
    Tensor<2, dim> edges;
    Tensor<1, dim> along;
    for (unsigned int a = 0; a < dim; ++a)
      {
        const Register edge =
          nodes[corners[a + 1]].values - nodes[corners[0]].values;
        for (unsigned int d = 0; d < dim; ++d)
          edges[a][d] = edge[d];
        along[a] = N * (mesh.points[corners[a + 1]] - mesh.points[corners[0]]);
      }
    Tensor<1, dim> normal = invert(edges) * along;
    normal /= normal.norm();
    Point<dim> wall;
    for (unsigned int d = 0; d < dim; ++d)
      wall[d] = (x[d] - cell.lower[d]) / cell.size;
    const double depth = cell.size * wall_offset(wall, normal);
    Register result    = x;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] -= depth * normal[d];
    return result;
  }



  template <int dim>
  bool
  CouplingPoints<dim>::place(Stencil &stencil,
                             const unsigned int id,
                             const FluidOperator<dim> &fluid,
                             const std::vector<Lanes> &nodes) const
  {
    Register x     = solid_value(stencil, nodes);
    const int wall = fluid.locate(to_point(x));
    if (wall < 0)
      return false;
    if (on_surface)
      x = coupled_position(id, x, fluid.cell(wall), nodes);
    const int found = on_surface ? fluid.locate(to_point(x)) : wall;
    if (found < 0)
      return false;
    const auto &cell = fluid.cell(found);
    stencil.cell     = found;
    for (unsigned int d = 0; d < dim; ++d)
      stencil.local[d] = (x[d] - cell.lower[d]) / cell.size;
    rescale(stencil, constrained_nodes(fluid, found));
    return true;
  }



  template <int dim>
  bool
  CouplingPoints<dim>::move(const FluidOperator<dim> &fluid)
  {
    bool all_found = true;
    for (const Run &run : runs)
      {
        const auto &cell          = fluid.cell(stencils[run.begin].cell);
        const double inverse_size = 1 / cell.size;
        for (unsigned int q = run.begin; q < run.end; ++q)
          {
            Stencil &s = stencils[q];
            Register x = solid_value(s, solid_input);
            if (on_surface)
              x = coupled_position(ids[q], x, cell, solid_input);
            std::array<double, dim> local;
            bool inside = true;
            for (unsigned int d = 0; d < dim; ++d)
              {
                local[d] = (x[d] - cell.lower[d]) * inverse_size;
                inside   = inside && local[d] >= 0 && local[d] < 1;
              }
            if (inside)
              {
                s.local = local;
                rescale(s, run.constrained);
              }
            // Otherwise the old weights stay until points are distributed.
            else if (!place(s, ids[q], fluid, solid_input) ||
                     is_too_sparse(ids[q], fluid.cell(s.cell).size))
              all_found = false;
          }
      }
    return all_found;
  }



  template <int dim>
  bool
  CouplingPoints<dim>::update(const FluidOperator<dim> &fluid,
                              const double *X,
                              double *multiplier)
  {
    to_lanes(X, solid_input);
    const bool all_found = move(fluid);
    for (unsigned int q = 0; q < stencils.size(); ++q)
      if (stencils[q].scale == 0)
        std::fill_n(multiplier + dim * q, dim, 0.);

    // Few points change their cell in a step.
    const unsigned int updates_between_sorting = 50;
    if (++updates_since_sorting >= updates_between_sorting)
      sort_by_cell(multiplier);
    find_runs(fluid);
    return all_found;
  }



  template <int dim>
  void
  CouplingPoints<dim>::add_forces(const RelaxationCoefficients &coefficients,
                                  const double *fluid_velocity,
                                  const double *V,
                                  const double *multiplier,
                                  double *fluid_force,
                                  double *solid_force,
                                  double *multiplier_rate)
  {
    to_lanes(V, solid_input);
    std::fill(solid_output.begin(), solid_output.end(), Lanes{});
    for (const Run &run : runs)
      {
        if (run.constrained == all_nodes)
          {
            std::fill(multiplier_rate + dim * run.begin,
                      multiplier_rate + dim * run.end,
                      0.);
            continue;
          }
        const FluidWeights free = free_nodes(run.constrained);
        std::array<Register, n_fluid> u, f{};
        for (unsigned int i = 0; i < n_fluid; ++i)
          u[i] = Node::load(fluid_velocity + dim * run.nodes[i]);

        for (unsigned int q = run.begin; q < run.end; ++q)
          {
            const Stencil &s           = stencils[q];
            const FluidWeights weights = fluid_weights(s, free);
            // Two sums, since one would wait for each of its terms.
            Register even{}, odd{};
            for (unsigned int i = 0; i < n_fluid; i += 2)
              {
                even += weights[i] * u[i];
                odd += weights[i + 1] * u[i + 1];
              }
            Register slip = solid_value(s, solid_input) - (even + odd);
            if (s.scale == 0)
              slip = Register{};
            const Register lambda = Node::load(multiplier + dim * q);
            Register rate         = coefficients.stiffness * slip;
            Register force = s.volume * (lambda + coefficients.drag * slip);
            if (run.released)
              {
                const Register m = releases[ids[q]].values;
                rate -= m *
                  (coefficients.stiffness * dot(m, slip) +
                   coefficients.decay * dot(m, lambda));
                force -= m * dot(m, force);
              }
            Node::store(rate, multiplier_rate + dim * q);
            for (unsigned int i = 0; i < n_fluid; ++i)
              f[i] += weights[i] * force;
            for (unsigned int a = 0; a < n_solid; ++a)
              solid_output[s.solid_nodes[a]].values -=
                s.solid_weights[a] * force;
          }

        for (unsigned int i = 0; i < n_fluid; ++i)
          Node::add(f[i], fluid_force + dim * run.nodes[i]);
      }
    for (unsigned int n = 0; n < solid_output.size(); ++n)
      Node::add(solid_output[n].values, solid_force + dim * n);
  }



  template <int dim>
  typename CouplingPoints<dim>::EnergyAndPower
  CouplingPoints<dim>::energy_and_power(
    const RelaxationCoefficients &coefficients,
    const double *fluid_velocity,
    const double *V,
    const double *multiplier) const
  {
    std::vector<Lanes> solid_velocity(mesh.points.size());
    to_lanes(V, solid_velocity);
    std::vector<double> sums(4, 0.);
    for (const Run &run : runs)
      {
        const FluidWeights free = free_nodes(run.constrained);
        for (unsigned int q = run.begin; q < run.end; ++q)
          {
            const Stencil &s = stencils[q];
            if (s.scale == 0)
              continue;
            Register slip      = solid_value(s, solid_velocity);
            const auto weights = fluid_weights(s, free);
            for (unsigned int i = 0; i < n_fluid; ++i)
              slip -=
                weights[i] * Node::load(fluid_velocity + dim * run.nodes[i]);
            const Register lambda = Node::load(multiplier + dim * q);
            const double square   = dot(slip, slip);
            double drag           = coefficients.drag * square;
            if (run.released)
              {
                const Register m      = releases[ids[q]].values;
                const double released = dot(m, slip), decaying = dot(m, lambda);
                drag += coefficients.decay / coefficients.stiffness * decaying *
                    decaying -
                  coefficients.drag * released * released;
              }
            sums[0] +=
              s.volume * dot(lambda, lambda) / (2 * coefficients.stiffness);
            sums[1] += s.volume * drag;
            sums[2] += s.volume * square;
            sums[3] += s.volume;
          }
      }
    dealii::Utilities::MPI::sum(sums, communicator, sums);
    return {sums[0], sums[1], sums[3] > 0 ? std::sqrt(sums[2] / sums[3]) : 0.};
  }



  template <int dim>
  std::vector<double>
  CouplingPoints<dim>::solid_volume(const FluidOperator<dim> &fluid) const
  {
    // Points in the ghost layer count in no owned cell; they are few, and the
    // blood volume fraction is for looking at.
    std::vector<double> volume(fluid.n_owned_cells(), 0.);
    for (const Stencil &s : stencils)
      if (s.cell >= 0 && s.cell < static_cast<int>(volume.size()))
        volume[s.cell] += s.volume;
    return volume;
  }



  template <int dim>
  double
  CouplingPoints<dim>::largest_mass_ratio(const FluidOperator<dim> &fluid,
                                          const double solid_density) const
  {
    // What gathers forces and divides them by the mass does so with masses.
    std::vector<double> coupled(dim * fluid.n_local_nodes(), 0.);
    std::vector<double> ratio(dim * fluid.n_owned_nodes());
    for (const Run &run : runs)
      {
        const FluidWeights free = free_nodes(run.constrained);
        for (unsigned int q = run.begin; q < run.end; ++q)
          {
            const auto weights = fluid_weights(stencils[q], free);
            for (unsigned int i = 0; i < n_fluid; ++i)
              for (unsigned int d = 0; d < dim; ++d)
                coupled[dim * run.nodes[i] + d] +=
                  weights[i] * stencils[q].volume * solid_density;
          }
      }
    fluid.finish(coupled.data(), ratio.data());
    const double largest =
      ratio.empty() ? 0. : *std::max_element(ratio.begin(), ratio.end());
    return dealii::Utilities::MPI::max(largest, communicator);
  }



  template class CouplingPoints<2>;
  template class CouplingPoints<3>;
} // namespace coapt
