#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_handler.h>

#include <algorithm>
#include <cmath>
#include <limits>

// The parts of FluidOperator that set it up for an octree.
namespace coapt
{
  template <int dim>
  void
  FluidOperator<dim>::reinit(const FluidGrid<dim> &grid)
  {
    comm = grid.triangulation().get_communicator();
    nodes.reinit(grid.triangulation());
    build_cells(grid);
    build_constraints(grid);
    build_kernel();
    build_mass();
    build_faces(grid);
    build_families(grid);
    build_prescribed_velocity(grid);
  }



  template <int dim>
  void
  FluidOperator<dim>::build_cells(const FluidGrid<dim> &grid)
  {
    cells.clear();
    index_of_active_cell.assign(grid.triangulation().n_active_cells(),
                                dealii::numbers::invalid_unsigned_int);
    locator.reinit(grid.lower(), grid.upper(), grid.cell_size(0));
    std::vector<dealii::types::global_dof_index> dofs(n_corners);
    const auto add_cell = [&](const auto &c) {
      c->get_dof_indices(dofs);
      locator.add_cell((c->vertex(0) + c->vertex(n_corners - 1)) / 2,
                       c->level());
      Cell cell;
      cell.lower      = locator.lower_corner(cells.size());
      cell.size       = grid.cell_size(c->level());
      cell.owner_rank = c->subdomain_id();
      for (unsigned int i = 0; i < n_corners; ++i)
        cell.nodes[i] = nodes.local_number(dofs[i]);
      index_of_active_cell[c->active_cell_index()] = cells.size();
      cells.push_back(cell);
    };
    for (const auto &c : nodes.dof_handler().active_cell_iterators())
      if (c->is_locally_owned())
        add_cell(c);
    n_owned = cells.size();
    for (const auto &c : nodes.dof_handler().active_cell_iterators())
      if (c->is_ghost())
        add_cell(c);
  }



  template <int dim>
  bool
  FluidOperator<dim>::is_in_wall(const dealii::Point<dim> &x,
                                 const FluidGrid<dim> &grid) const
  {
    return lumen && lumen(x) >= -1e-9 * grid.cell_size(0);
  }



  template <int dim>
  unsigned char
  FluidOperator<dim>::held_components(const dealii::Point<dim> &x,
                                      const FluidGrid<dim> &grid) const
  {
    constexpr unsigned char all = (1 << dim) - 1;
    if (is_in_wall(x, grid))
      return all;
    unsigned char result = 0;
    for (unsigned int side = 0; side < 2 * dim; ++side)
      {
        if (!grid.is_on_side(x, side))
          continue;
        const unsigned char normal = 1 << (side / 2);
        if (boundaries.type[side] == FluidBoundary::no_slip ||
            boundaries.type[side] == FluidBoundary::velocity)
          result = all;
        else if (boundaries.type[side] == FluidBoundary::slip)
          result |= normal;
        else
          result |= all & ~normal;
      }
    return result;
  }



  template <int dim>
  void
  FluidOperator<dim>::build_constraints(const FluidGrid<dim> &grid)
  {
    node_position.assign(nodes.n_owned(), dealii::Point<dim>());
    for (unsigned int c = 0; c < n_owned; ++c)
      for (unsigned int i = 0; i < n_corners; ++i)
        if (cells[c].nodes[i] < nodes.n_owned())
          {
            dealii::Point<dim> &x = node_position[cells[c].nodes[i]];
            for (unsigned int d = 0; d < dim; ++d)
              x[d] = cells[c].lower[d] + ((i >> d) & 1) * cells[c].size;
          }
    std::vector<double> bits(dim * nodes.n_local(), 0.);
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      bits[dim * i] = held_components(node_position[i], grid);
    nodes.update_ghosts(bits.data());
    held.resize(nodes.n_local());
    for (unsigned int i = 0; i < nodes.n_local(); ++i)
      held[i] = static_cast<unsigned char>(bits[dim * i]);
    // a hanging node moves with its masters, wherever it lies
    for (unsigned int row = 0; row < nodes.hanging_nodes().size(); ++row)
      {
        unsigned char common = (1 << dim) - 1;
        for (const unsigned int master : nodes.masters(row))
          common &= held[master];
        held[nodes.hanging_nodes()[row]] = common;
      }
  }



  template <int dim>
  bool
  FluidOperator<dim>::has_given_velocity(const dealii::Point<dim> &x,
                                         const FluidGrid<dim> &grid) const
  {
    bool is_given = false;
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (grid.is_on_side(x, side))
        {
          if (boundaries.type[side] == FluidBoundary::no_slip)
            return false;
          is_given =
            is_given || boundaries.type[side] == FluidBoundary::velocity;
        }
    return is_given && !is_in_wall(x, grid);
  }



  template <int dim>
  void
  FluidOperator<dim>::build_prescribed_velocity(const FluidGrid<dim> &grid)
  {
    std::vector<unsigned int> given;
    std::vector<dealii::Point<dim>> positions;
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      {
        const bool is_hanging = mass[i] == 0;
        if (!is_hanging && has_given_velocity(node_position[i], grid))
          {
            given.push_back(i);
            positions.push_back(node_position[i]);
          }
      }
    // two or three steps: short enough for sound of a few cells' length
    prescribed.reinit(given,
                      positions,
                      boundaries.velocity,
                      4 * smallest_size / fluid_parameters.sound_speed);

    std::vector<double> owned(dim * nodes.n_owned(), 0.);
    for (const unsigned int i : given)
      owned[dim * i] = 1;
    std::vector<double> local(dim * nodes.n_local());
    nodes.gather(owned.data(), local.data());
    driven.resize(nodes.n_local());
    for (unsigned int i = 0; i < nodes.n_local(); ++i)
      driven[i] = local[dim * i] > 0.999; // of a mean of ones
  }



  template <int dim>
  void
  FluidOperator<dim>::build_kernel()
  {
    kernel.clear();
    active.assign(n_owned, false);
    inactive.clear();
    smallest_size = std::numeric_limits<double>::max();
    for (unsigned int c = 0; c < n_owned; ++c)
      {
        active[c] = std::any_of(cells[c].nodes.begin(),
                                cells[c].nodes.end(),
                                [&](const unsigned int node) {
                                  return !is_constrained_node(node);
                                });
        if (active[c])
          {
            kernel.add_cell(cells[c].nodes, c, cells[c].size);
            smallest_size = std::min(smallest_size, cells[c].size);
          }
        else
          inactive.push_back(c);
      }
    smallest_size = dealii::Utilities::MPI::min(smallest_size, comm);
  }



  template <int dim>
  void
  FluidOperator<dim>::build_mass()
  {
    // as in deal.II's step-48: row sums of the condensed mass matrix
    std::vector<double> sums(dim * nodes.n_local(), 0.);
    for (unsigned int c = 0; c < n_owned; ++c)
      if (active[c])
        for (const unsigned int node : cells[c].nodes)
          sums[dim * node] +=
            fluid_parameters.density * std::pow(cells[c].size, dim) / n_corners;
    nodes.collect(sums.data());
    nodes.update_ghosts(sums.data());
    mass.resize(nodes.n_local());
    for (unsigned int i = 0; i < nodes.n_local(); ++i)
      mass[i] = sums[dim * i];
    for (const unsigned int node : nodes.hanging_nodes())
      mass[node] = 0;
    inverse_mass.assign(dim * nodes.n_owned(), 0.);
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        if (mass[i] > 0 && !((held[i] >> d) & 1))
          inverse_mass[dim * i + d] = 1 / mass[i];
  }



  template <int dim>
  void
  FluidOperator<dim>::build_faces(const FluidGrid<dim> &grid)
  {
    for (unsigned int side = 0; side < 2 * dim; ++side)
      {
        const unsigned int d = side / 2;
        const bool upper     = side % 2;
        faces[side].clear();
        for (unsigned int c = 0; c < n_owned; ++c)
          {
            dealii::Point<dim> corner = cells[c].lower;
            corner[d] += upper * cells[c].size;
            if (!active[c] || !grid.is_on_side(corner, side))
              continue;
            Face face;
            face.area_per_node =
              std::pow(cells[c].size, dim - 1) / n_face_corners;
            unsigned int n = 0;
            for (unsigned int i = 0; i < n_corners; ++i)
              if (((i >> d) & 1) == upper)
                face.nodes[n++] = cells[c].nodes[i];
            faces[side].push_back(face);
          }
      }
  }



  template <int dim>
  void
  FluidOperator<dim>::build_families(const FluidGrid<dim> &grid)
  {
    filter.clear();
    const auto &octree = grid.triangulation();
    for (const auto &first : octree.active_cell_iterators())
      {
        if (!first->is_locally_owned() || first->level() == 0 ||
            first->parent()->child(0) != first)
          continue;
        // p4est keeps families on one rank, but siblings may be refined
        typename CheckerboardFilter<dim>::Family family;
        bool complete = true;
        for (unsigned int i = 0; i < n_corners && complete; ++i)
          {
            const auto sibling = first->parent()->child(i);
            complete = sibling->is_active() && sibling->is_locally_owned() &&
              active[owned_cell_index(sibling->active_cell_index())];
            if (complete)
              family[i] = owned_cell_index(sibling->active_cell_index());
          }
        const double h = grid.cell_size(first->level());
        if (complete)
          filter.add_family(family,
                            fluid_parameters.checkerboard *
                              fluid_parameters.sound_speed / h,
                            h);
      }
  }

  template void
  FluidOperator<2>::reinit(const FluidGrid<2> &);
  template void
  FluidOperator<3>::reinit(const FluidGrid<3> &);
} // namespace coapt
