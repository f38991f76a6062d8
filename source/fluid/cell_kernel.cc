#include <coapt/fluid/cell_kernel.h>

namespace coapt
{
  namespace internal
  {
    template <int dim>
    void
    CellKernel<dim>::clear()
    {
      batches.clear();
    }



    template <int dim>
    void
    CellKernel<dim>::add_cell(const std::array<unsigned int, n_corners> &nodes,
                              const unsigned int pressure_index,
                              const double size)
    {
      if (batches.empty() || batches.back().n_filled == 8)
        {
          batches.emplace_back();
          batches.back().n_filled = 0;
        }
      Batch &batch         = batches.back();
      const int first_lane = batch.n_filled++;
      const int end_lane   = (first_lane == 0) ? 8 : first_lane + 1;
      for (int lane = first_lane; lane < end_lane; ++lane)
        {
          batch.size[lane]     = size;
          batch.pressure[lane] = pressure_index;
          for (int i = 0; i < n_corners; ++i)
            batch.offset[i][lane] = dim * nodes[i];
        }
    }



    template <int dim>
    void
    CellKernel<dim>::evaluate(const CellCoefficients &coefficients,
                              const double *velocity,
                              const double *pressure,
                              double *force,
                              double *pressure_rate) const
    {
      EightDoubles u[dim][n_corners], node[dim], p = {}, rate;
      for (const Batch &batch : batches)
        {
#pragma GCC unroll 8
          for (int i = 0; i < n_corners; ++i)
            {
              load_nodes<dim>(velocity, batch.offset[i], node);
              for (int c = 0; c < dim; ++c)
                u[c][i] = node[c];
            }
          for (int lane = 0; lane < 8; ++lane)
            p[lane] = pressure[batch.pressure[lane]];

          for (int c = 0; c < dim; ++c)
            corners_to_modes<dim>(u[c]);
          cell_forces<dim>(u, p, batch.size, coefficients, rate);
          for (int c = 0; c < dim; ++c)
            modes_to_corners<dim>(u[c]);

          for (int lane = 0; lane < batch.n_filled; ++lane)
            pressure_rate[batch.pressure[lane]] = rate[lane];
#pragma GCC unroll 8
          for (int i = 0; i < n_corners; ++i)
            {
              for (int c = 0; c < dim; ++c)
                node[c] = u[c][i];
              add_to_nodes<dim>(force, batch.offset[i], batch.n_filled, node);
            }
        }
    }

    template class CellKernel<2>;
    template class CellKernel<3>;
  } // namespace internal
} // namespace coapt
