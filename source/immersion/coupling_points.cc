#include <deal.II/base/mpi.h>

#include <coapt/immersion/coupling_points.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Point;

  template <int dim>
  CouplingPoints<dim>::CouplingPoints(
    const SimplexMesh<dim> &mesh,
    const std::vector<SamplePoint<dim>> &points,
    MPI_Comm communicator)
    : mesh(mesh), points(points), communicator(communicator)
  {
  }



  template <int dim>
  typename CouplingPoints<dim>::Stencil
  CouplingPoints<dim>::unplaced_stencil(const unsigned int id) const
  {
    Stencil stencil;
    stencil.solid_nodes = mesh.cells[points[id].cell];
    stencil.volume      = points[id].volume;
    stencil.cell        = -1;
    stencil.active      = false;
    stencil.fluid_nodes.fill(0);
    stencil.fluid_weights.fill(0);
    std::copy(points[id].barycentric.begin(),
              points[id].barycentric.end(),
              stencil.solid_weights.begin());
    return stencil;
  }



  template <int dim>
  Point<dim>
  CouplingPoints<dim>::position(const Stencil &stencil, const double *X) const
  {
    Point<dim> x;
    for (unsigned int a = 0; a < n_solid; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        x[d] += stencil.solid_weights[a] * X[dim * stencil.solid_nodes[a] + d];
    return x;
  }



  template <int dim>
  std::vector<Point<dim>>
  CouplingPoints<dim>::positions(const double *X) const
  {
    std::vector<Point<dim>> result(points.size());
    for (unsigned int id = 0; id < points.size(); ++id)
      result[id] = position(unplaced_stencil(id), X);
    return result;
  }



  template <int dim>
  void
  CouplingPoints<dim>::distribute(const FluidOperator<dim> &fluid,
                                  const double *X,
                                  std::vector<double> &multiplier)
  {
    // Re-distribution is rare (re-adaptation, or a point that has crossed the
    // whole ghost layer), so the simple way is good enough: every rank sees
    // all multipliers and picks those of the points that are now its own.
    std::vector<double> all(dim * points.size(), 0.);
    for (unsigned int q = 0; q < multiplier.size() / dim; ++q)
      for (unsigned int d = 0; d < dim; ++d)
        all[dim * ids[q] + d] = multiplier[dim * q + d];
    dealii::Utilities::MPI::sum(all, communicator, all);

    const int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    ids.clear();
    stencils.clear();
    multiplier.clear();
    for (unsigned int id = 0; id < points.size(); ++id)
      {
        Stencil stencil = unplaced_stencil(id);
        if (!place(stencil, fluid, X) ||
            fluid.cell(stencil.cell).owner_rank != rank)
          continue;
        ids.push_back(id);
        stencils.push_back(stencil);
        for (unsigned int d = 0; d < dim; ++d)
          multiplier.push_back(stencil.active ? all[dim * id + d] : 0.);
      }
  }



  template <int dim>
  bool
  CouplingPoints<dim>::place(Stencil &stencil,
                             const FluidOperator<dim> &fluid,
                             const double *X)
  {
    const Point<dim> x = position(stencil, X);
    stencil.cell       = fluid.locate(x, stencil.cell);
    if (stencil.cell < 0)
      return false;

    const auto &cell = fluid.cell(stencil.cell);
    double sum       = 0;
    for (unsigned int i = 0; i < n_fluid; ++i)
      {
        double weight = 1;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double xi = (x[d] - cell.lower[d]) / cell.size;
            weight *= ((i >> d) & 1) ? xi : 1 - xi;
          }
        stencil.fluid_nodes[i] = cell.nodes[i];
        if (fluid.is_constrained_node(cell.nodes[i]))
          weight = 0;
        stencil.fluid_weights[i] = weight;
        sum += weight;
      }

    // A point whose free weight is nearly nothing would move a far node by a
    // huge lever, so it counts as lying in the rigid wall.
    stencil.active = sum > 1e-3;
    for (double &weight : stencil.fluid_weights)
      weight = stencil.active ? weight / sum : 0.;
    return true;
  }



  template <int dim>
  bool
  CouplingPoints<dim>::update(const FluidOperator<dim> &fluid,
                              const double *X,
                              double *multiplier)
  {
    bool all_found = true;
    for (unsigned int q = 0; q < stencils.size(); ++q)
      {
        if (!place(stencils[q], fluid, X))
          {
            // The old weights stay until the points are distributed anew.
            all_found = false;
            continue;
          }
        if (!stencils[q].active)
          std::fill_n(multiplier + dim * q, dim, 0.);
      }
    return all_found;
  }



  template <int dim>
  std::array<double, dim>
  CouplingPoints<dim>::slip(const Stencil &s,
                            const double *fluid_velocity,
                            const double *V) const
  {
    std::array<double, dim> slip{};
    for (unsigned int a = 0; a < n_solid; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        slip[d] += s.solid_weights[a] * V[dim * s.solid_nodes[a] + d];
    for (unsigned int i = 0; i < n_fluid; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        slip[d] -=
          s.fluid_weights[i] * fluid_velocity[dim * s.fluid_nodes[i] + d];
    return slip;
  }



  template <int dim>
  void
  CouplingPoints<dim>::add_forces(const RelaxationCoefficients &coefficients,
                                  const double *fluid_velocity,
                                  const double *V,
                                  const double *multiplier,
                                  double *fluid_force,
                                  double *solid_force,
                                  double *multiplier_rate) const
  {
    for (unsigned int q = 0; q < stencils.size(); ++q)
      {
        const Stencil &s = stencils[q];
        if (!s.active)
          {
            std::fill_n(multiplier_rate + dim * q, dim, 0.);
            continue;
          }
        const std::array<double, dim> w = slip(s, fluid_velocity, V);
        std::array<double, dim> force;
        for (unsigned int d = 0; d < dim; ++d)
          {
            force[d] =
              s.volume * (multiplier[dim * q + d] + coefficients.drag * w[d]);
            multiplier_rate[dim * q + d] = coefficients.stiffness * w[d];
          }
        for (unsigned int i = 0; i < n_fluid; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            fluid_force[dim * s.fluid_nodes[i] + d] +=
              s.fluid_weights[i] * force[d];
        for (unsigned int a = 0; a < n_solid; ++a)
          for (unsigned int d = 0; d < dim; ++d)
            solid_force[dim * s.solid_nodes[a] + d] -=
              s.solid_weights[a] * force[d];
      }
  }



  template <int dim>
  typename CouplingPoints<dim>::EnergyAndPower
  CouplingPoints<dim>::energy_and_power(
    const RelaxationCoefficients &coefficients,
    const double *fluid_velocity,
    const double *V,
    const double *multiplier) const
  {
    std::vector<double> sums(4, 0.);
    for (unsigned int q = 0; q < stencils.size(); ++q)
      {
        const Stencil &s = stencils[q];
        if (!s.active)
          continue;
        const std::array<double, dim> w = slip(s, fluid_velocity, V);
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double lambda = multiplier[dim * q + d];
            sums[0] +=
              s.volume * lambda * lambda / (2 * coefficients.stiffness);
            sums[1] += s.volume * coefficients.drag * w[d] * w[d];
            sums[2] += s.volume * w[d] * w[d];
          }
        sums[3] += s.volume;
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
    for (const Stencil &s : stencils)
      for (unsigned int i = 0; i < n_fluid; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          coupled[dim * s.fluid_nodes[i] + d] +=
            s.fluid_weights[i] * s.volume * solid_density;
    fluid.finish(coupled.data(), ratio.data());
    const double largest =
      ratio.empty() ? 0. : *std::max_element(ratio.begin(), ratio.end());
    return dealii::Utilities::MPI::max(largest, communicator);
  }



  template class CouplingPoints<2>;
  template class CouplingPoints<3>;
} // namespace coapt
