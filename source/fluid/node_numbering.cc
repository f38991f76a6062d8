#include <coapt/base/exceptions.h>
#include <coapt/base/node_register.h>
#include <coapt/fluid/node_numbering.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <stdexcept>

namespace coapt
{
  using dealii::ArrayView;
  using dealii::IndexSet;
  using dealii::types::global_dof_index;
  using dealii::Utilities::MPI::Partitioner;

  namespace
  {
    constexpr unsigned int max_masters = 4;

    /** The index set with dim consecutive indices for each index of @p set. */
    template <int dim>
    IndexSet
    repeated(const IndexSet &set)
    {
      IndexSet result(dim * set.size());
      for (auto range = set.begin_intervals(); range != set.end_intervals();
           ++range)
        result.add_range(dim * *range->begin(), dim * (range->last() + 1));
      result.compress();
      return result;
    }
  } // namespace



  template <int dim>
  void
  NodeNumbering<dim>::reinit(
    const dealii::Triangulation<dim, dim> &triangulation)
  {
    dofs = std::make_shared<dealii::DoFHandler<dim>>(triangulation);
    dofs->distribute_dofs(dealii::FE_Q<dim>(1));

    IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(*dofs, relevant);
    const std::vector<double> global_masters = find_masters(relevant);

    std::vector<global_dof_index> ghosts;
    relevant.fill_index_vector(ghosts);
    for (const double master : global_masters)
      if (master >= 0)
        ghosts.push_back(static_cast<global_dof_index>(master));
    std::sort(ghosts.begin(), ghosts.end());
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    IndexSet known(dofs->n_dofs());
    known.add_indices(ghosts.begin(), ghosts.end());
    known.compress();

    const IndexSet &owned = dofs->locally_owned_dofs();
    const MPI_Comm comm   = triangulation.get_communicator();
    nodes                 = std::make_unique<Partitioner>(owned, known, comm);
    vectors               = std::make_unique<Partitioner>(repeated<dim>(owned),
                                            repeated<dim>(known),
                                            comm);
    send_buffer.resize(vectors->n_import_indices());
    build_hanging_rows(relevant, global_masters);
  }



  template <int dim>
  std::vector<double>
  NodeNumbering<dim>::find_masters(const IndexSet &relevant) const
  {
    dealii::AffineConstraints<double> constraints(relevant);
    dealii::DoFTools::make_hanging_node_constraints(*dofs, constraints);
    constraints.close();

    const Partitioner partitioner(dofs->locally_owned_dofs(),
                                  relevant,
                                  dofs->get_triangulation().get_communicator());
    const unsigned int n_owned = partitioner.locally_owned_size();
    const unsigned int n_ghost = partitioner.n_ghost_indices();
    std::vector<double> result(max_masters * (n_owned + n_ghost), -1.);
    std::vector<double> column(n_owned), ghost(n_ghost);
    std::vector<double> buffer(partitioner.n_import_indices());
    for (unsigned int m = 0; m < max_masters; ++m)
      {
        for (unsigned int i = 0; i < n_owned; ++i)
          {
            const auto *row = constraints.get_constraint_entries(
              partitioner.local_to_global(i));
            if (row != nullptr && row->size() != 2 &&
                row->size() != max_masters)
              throw std::runtime_error("A hanging node has " +
                                       std::to_string(row->size()) +
                                       " masters: the octree is not balanced.");
            column[i] = (row != nullptr && m < row->size())
              ? static_cast<double>((*row)[m].first)
              : -1.;
          }
        std::vector<MPI_Request> open;
        partitioner.template export_to_ghosted_array_start<double>(
          0,
          ArrayView<const double>(column.data(), n_owned),
          ArrayView<double>(buffer.data(), buffer.size()),
          ArrayView<double>(ghost.data(), n_ghost),
          open);
        partitioner.template export_to_ghosted_array_finish<double>(
          ArrayView<double>(ghost.data(), n_ghost), open);
        for (unsigned int i = 0; i < n_owned; ++i)
          result[max_masters * i + m] = column[i];
        for (unsigned int i = 0; i < n_ghost; ++i)
          result[max_masters * (n_owned + i) + m] = ghost[i];
      }
    return result;
  }



  template <int dim>
  void
  NodeNumbering<dim>::build_hanging_rows(
    const IndexSet &relevant,
    const std::vector<double> &global_masters)
  {
    hanging.clear();
    row_start.assign(1, 0);
    row_master.clear();
    IndexSet ghosts = relevant;
    ghosts.subtract_set(dofs->locally_owned_dofs());
    for (unsigned int i = 0; i < global_masters.size() / max_masters; ++i)
      {
        const double *master = &global_masters[max_masters * i];
        if (master[0] < 0)
          continue;
        hanging.push_back(
          i < n_owned() ? i
                        : local_number(ghosts.nth_index_in_set(i - n_owned())));
        for (unsigned int m = 0; m < max_masters && master[m] >= 0; ++m)
          row_master.push_back(
            local_number(static_cast<global_dof_index>(master[m])));
        row_start.push_back(row_master.size());
      }
  }



  template <int dim>
  unsigned int
  NodeNumbering<dim>::n_owned() const
  {
    return nodes->locally_owned_size();
  }



  template <int dim>
  unsigned int
  NodeNumbering<dim>::n_local() const
  {
    return nodes->locally_owned_size() + nodes->n_ghost_indices();
  }



  template <int dim>
  const dealii::DoFHandler<dim, dim> &
  NodeNumbering<dim>::dof_handler() const
  {
    return *dofs;
  }



  template <int dim>
  unsigned int
  NodeNumbering<dim>::local_number(const global_dof_index global) const
  {
    return nodes->global_to_local(global);
  }



  template <int dim>
  const std::vector<unsigned int> &
  NodeNumbering<dim>::hanging_nodes() const
  {
    return hanging;
  }



  template <int dim>
  std::vector<unsigned int>
  NodeNumbering<dim>::masters(const unsigned int row) const
  {
    return std::vector<unsigned int>(row_master.begin() + row_start[row],
                                     row_master.begin() + row_start[row + 1]);
  }



  template <int dim>
  void
  NodeNumbering<dim>::gather(const double *owned, double *local) const
  {
    std::copy(owned, owned + dim * n_owned(), local);
    update_ghosts(local);
    interpolate_hanging_nodes(local);
  }



  template <int dim>
  void
  NodeNumbering<dim>::update_ghosts(double *local) const
  {
    const unsigned int n = dim * n_owned();
    const ArrayView<double> ghosts(local + n, vectors->n_ghost_indices());
    vectors->template export_to_ghosted_array_start<double>(
      0,
      ArrayView<const double>(local, n),
      ArrayView<double>(send_buffer.data(), send_buffer.size()),
      ghosts,
      requests);
    vectors->template export_to_ghosted_array_finish<double>(ghosts, requests);
  }



  template <int dim>
  void
  NodeNumbering<dim>::collect(double *local) const
  {
    condense_hanging_nodes(local);
    add_ghosts(local);
  }



  template <int dim>
  void
  NodeNumbering<dim>::add_ghosts(double *local) const
  {
    const unsigned int n = dim * n_owned();
    const ArrayView<double> ghosts(local + n, vectors->n_ghost_indices());
    const ArrayView<double> buffer(send_buffer.data(), send_buffer.size());
    vectors->template import_from_ghosted_array_start<double>(
      dealii::VectorOperation::add, 1, ghosts, buffer, requests);
    vectors->template import_from_ghosted_array_finish<double>(
      dealii::VectorOperation::add,
      ArrayView<const double>(send_buffer.data(), send_buffer.size()),
      ArrayView<double>(local, n),
      ghosts,
      requests);
  }



  template <int dim>
  void
  NodeNumbering<dim>::interpolate_hanging_nodes(double *local) const
  {
    using Node = NodeRegister<dim>;
    for (unsigned int row = 0; row < hanging.size(); ++row)
      {
        const unsigned int begin = row_start[row], end = row_start[row + 1];
        typename Node::Register sum{};
        for (unsigned int m = begin; m < end; ++m)
          sum += Node::load(local + dim * row_master[m]);
        Node::store(sum / double(end - begin), local + dim * hanging[row]);
      }
  }



  template <int dim>
  void
  NodeNumbering<dim>::condense_hanging_nodes(double *local) const
  {
    using Node = NodeRegister<dim>;
    for (unsigned int row = 0; row < hanging.size(); ++row)
      {
        const unsigned int begin = row_start[row], end = row_start[row + 1];
        double *node     = local + dim * hanging[row];
        const auto share = Node::load(node) / double(end - begin);
        std::fill_n(node, dim, 0.);
        for (unsigned int m = begin; m < end; ++m)
          Node::add(share, local + dim * row_master[m]);
      }
  }

  template class NodeNumbering<2>;
  template class NodeNumbering<3>;
} // namespace coapt
