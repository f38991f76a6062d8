#include <deal.II/base/mpi.h>

#include <coapt/immersion/coupling_points.h>

#include <algorithm>
#include <array>

// The parts of CouplingPoints that give the points to ranks, and choose those
// that carry the coupling.
namespace coapt
{
  using dealii::Point;

  template <int dim>
  void
  CouplingPoints<dim>::distribute(const FluidOperator<dim> &fluid,
                                  const double *X,
                                  std::vector<double> &multiplier)
  {
    // Re-distribution is rare (re-adaptation, or a point that has crossed the
    // whole ghost layer), so the simple way is good enough: every rank sees
    // all multipliers and picks those of the points that are now its own.
    std::vector<double> all = all_multipliers(multiplier);
    if (!stand_in.empty())
      {
        std::vector<Lanes> positions(mesh.points.size());
        to_lanes(X, positions);
        make_dense(fluid, positions, all);
      }
    distribute_all(fluid, X, all, multiplier);
  }



  template <int dim>
  std::vector<double>
  CouplingPoints<dim>::all_multipliers(
    const std::vector<double> &multiplier) const
  {
    std::vector<double> all(dim * points.size(), 0.);
    for (unsigned int q = 0; q < multiplier.size() / dim; ++q)
      for (unsigned int d = 0; d < dim; ++d)
        all[dim * ids[q] + d] = multiplier[dim * q + d];
    dealii::Utilities::MPI::sum(all, communicator, all);
    return all;
  }



  template <int dim>
  void
  CouplingPoints<dim>::distribute_all(const FluidOperator<dim> &fluid,
                                      const double *X,
                                      const std::vector<double> &all,
                                      std::vector<double> &multiplier)
  {
    const int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    ids.clear();
    stencils.clear();
    multiplier.clear();
    std::vector<Lanes> positions(mesh.points.size());
    to_lanes(X, positions);
    for (unsigned int id = 0; id < points.size(); ++id)
      {
        if (!active[id])
          continue;
        Stencil stencil = unplaced_stencil(id);
        if (!place(stencil, id, fluid, positions) ||
            fluid.cell(stencil.cell).owner_rank != rank)
          continue;
        ids.push_back(id);
        stencils.push_back(stencil);
        for (unsigned int d = 0; d < dim; ++d)
          multiplier.push_back(stencil.scale > 0 ? all[dim * id + d] : 0.);
      }
    sort_by_cell(multiplier.data());
    find_runs(fluid);
  }



  template <int dim>
  bool
  CouplingPoints<dim>::is_amid_large_cells(const FluidOperator<dim> &fluid,
                                           const Stencil &stencil) const
  {
    const auto is_large = [&](const int number) {
      return number < 0 || fluid.cell(number).size > 1.5 * dense_cell;
    };
    if (!is_large(stencil.cell))
      return false;
    // Just outside the cell on all sides, where a rank knows the cells.
    const auto &cell                   = fluid.cell(stencil.cell);
    const unsigned int n_neighbourhood = dim == 2 ? 9 : 27;
    for (unsigned int i = 0; i < n_neighbourhood; ++i)
      {
        Point<dim> beside;
        for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= 3)
          beside[d] = cell.lower[d] +
            std::array<double, 3>{{-0.25, stencil.local[d], 1.25}}[rest % 3] *
              cell.size;
        if (!is_large(fluid.locate(beside)))
          return false;
      }
    return true;
  }



  template <int dim>
  void
  CouplingPoints<dim>::make_dense(const FluidOperator<dim> &fluid,
                                  const std::vector<Lanes> &positions,
                                  std::vector<double> &multiplier)
  {
    const int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    std::vector<int> is_dense(points.size(), 0);
    for (unsigned int id = 0; id < stand_in.size(); ++id)
      {
        Stencil stencil = unplaced_stencil(id);
        if (active[stand_in[id]] && place(stencil, id, fluid, positions) &&
            fluid.cell(stencil.cell).owner_rank == rank &&
            !is_amid_large_cells(fluid, stencil))
          is_dense[stand_in[id]] = 1;
      }
    dealii::Utilities::MPI::max(is_dense, communicator, is_dense);

    for (unsigned int id = 0; id < stand_in.size(); ++id)
      if (is_dense[stand_in[id]])
        {
          active[id] = true;
          if (!releases.empty())
            releases[id] = releases[stand_in[id]];
          std::copy_n(multiplier.begin() + dim * stand_in[id],
                      dim,
                      multiplier.begin() + dim * id);
        }
    for (unsigned int id = stand_in.size(); id < points.size(); ++id)
      active[id] = active[id] && !is_dense[id];
  }



  template void
  CouplingPoints<2>::distribute(const FluidOperator<2> &,
                                const double *,
                                std::vector<double> &);
  template std::vector<double>
  CouplingPoints<2>::all_multipliers(const std::vector<double> &) const;
  template void
  CouplingPoints<2>::distribute_all(const FluidOperator<2> &,
                                    const double *,
                                    const std::vector<double> &,
                                    std::vector<double> &);
  template void
  CouplingPoints<3>::distribute(const FluidOperator<3> &,
                                const double *,
                                std::vector<double> &);
  template std::vector<double>
  CouplingPoints<3>::all_multipliers(const std::vector<double> &) const;
  template void
  CouplingPoints<3>::distribute_all(const FluidOperator<3> &,
                                    const double *,
                                    const std::vector<double> &,
                                    std::vector<double> &);
} // namespace coapt
