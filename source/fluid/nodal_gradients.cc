#include <coapt/fluid/fluid_operator.h>
#include <coapt/fluid/nodal_gradients.h>

namespace coapt
{
  template <int dim>
  NodalGradients<dim>
  nodal_gradients(const FluidOperator<dim> &op,
                  const std::vector<double> &velocity_local)
  {
    constexpr unsigned int n_corners = 1 << dim;
    const unsigned int n_entries     = dim * op.n_local_nodes();
    NodalGradients<dim> sums;
    for (auto &sum : sums)
      sum.assign(n_entries, 0.);
    std::vector<double> weights(n_entries, 0.); // one a direction
    for (unsigned int c = 0; c < op.n_owned_cells(); ++c)
      if (op.is_active_cell(c))
        {
          const auto &cell    = op.cell(c);
          const double weight = 1 / cell.size;
          for (unsigned int i = 0; i < n_corners; ++i)
            for (unsigned int d = 0; d < dim; ++d)
              {
                const unsigned int node = cell.nodes[i];
                if (op.nodal_mass(node) == 0) // it hangs
                  continue;
                const unsigned int other = cell.nodes[i ^ (1 << d)];
                const double sign        = (i >> d & 1) ? -1 : 1;
                weights[dim * node + d] += weight;
                for (unsigned int k = 0; k < dim; ++k)
                  sums[d][dim * node + k] += weight * sign / cell.size *
                    (velocity_local[dim * other + k] -
                     velocity_local[dim * node + k]);
              }
        }
    op.sum_forces(weights.data());
    NodalGradients<dim> gradients;
    for (unsigned int d = 0; d < dim; ++d)
      {
        op.sum_forces(sums[d].data());
        for (unsigned int i = 0; i < op.n_owned_nodes(); ++i)
          for (unsigned int k = 0; k < dim; ++k)
            sums[d][dim * i + k] /=
              weights[dim * i + d] > 0 ? weights[dim * i + d] : 1.;
        gradients[d].resize(n_entries);
        op.gather(sums[d].data(), gradients[d].data());
      }
    return gradients;
  }

  template NodalGradients<2>
  nodal_gradients<2>(const FluidOperator<2> &, const std::vector<double> &);
  template NodalGradients<3>
  nodal_gradients<3>(const FluidOperator<3> &, const std::vector<double> &);
} // namespace coapt
