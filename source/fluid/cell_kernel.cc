#include <coapt/fluid/cell_kernel.h>

namespace coapt
{
  namespace internal
  {
    namespace
    {
      /** Loads the dim velocity components of eight nodes, x[c] = component
       * c of all nodes. */
      template <int dim>
      inline __attribute__((always_inline)) void
      load(const double *values, const int *offset, EightDoubles *x)
      {
        for (int lane = 0; lane < 8; ++lane)
          for (int c = 0; c < dim; ++c)
            x[c][lane] = values[offset[lane] + c];
      }

      /** Adds eight node vectors to their places, one after the other since
       * the cells of a batch share nodes. */
      template <int dim>
      inline __attribute__((always_inline)) void
      add(double *values, const int *offset, const int n, const EightDoubles *x)
      {
        for (int lane = 0; lane < n; ++lane)
          for (int c = 0; c < dim; ++c)
            values[offset[lane] + c] += x[c][lane];
      }

#if defined(__AVX512F__) && defined(__AVX512VL__)
      typedef long long Selection __attribute__((vector_size(64)));
      constexpr Selection first_of_pairs  = {0, 8, 2, 10, 4, 12, 6, 14};
      constexpr Selection second_of_pairs = {1, 9, 3, 11, 5, 13, 7, 15};
      constexpr Selection lower_pairs     = {0, 1, 8, 9, 4, 5, 12, 13};
      constexpr Selection upper_pairs     = {2, 3, 10, 11, 6, 7, 14, 15};

      /** Selects numbers from a (0 to 7) and b (8 to 15). */
      inline __attribute__((always_inline)) EightDoubles
      interleave(const EightDoubles a, const EightDoubles b, const Selection s)
      {
        return __builtin_shuffle(a, b, s);
      }

      /** A node triple; the mask keeps the load inside the array. */
      inline __attribute__((always_inline)) __m256d
      load_triple(const double *values)
      {
        return _mm256_maskz_loadu_pd(7, values);
      }

      template <>
      inline __attribute__((always_inline)) void
      load<3>(const double *values, const int *offset, EightDoubles *x)
      {
        // row[i]: node i in the lower, node i + 4 in the upper half
        EightDoubles row[4];
        for (int i = 0; i < 4; ++i)
          row[i] = (EightDoubles)_mm512_maskz_insertf64x4(
            0xff,
            _mm512_castpd256_pd512(load_triple(values + offset[i])),
            load_triple(values + offset[i + 4]),
            1);
        const EightDoubles xz01 = interleave(row[0], row[1], first_of_pairs);
        const EightDoubles xz23 = interleave(row[2], row[3], first_of_pairs);
        const EightDoubles y01  = interleave(row[0], row[1], second_of_pairs);
        const EightDoubles y23  = interleave(row[2], row[3], second_of_pairs);
        x[0]                    = interleave(xz01, xz23, lower_pairs);
        x[1]                    = interleave(y01, y23, lower_pairs);
        x[2]                    = interleave(xz01, xz23, upper_pairs);
      }

      /** Adds a pair and a single number to a node triple. */
      inline __attribute__((always_inline)) void
      add_triple(double *values, const __m128d pair, const double last)
      {
        _mm_storeu_pd(values, _mm_add_pd(_mm_loadu_pd(values), pair));
        values[2] += last;
      }

      template <>
      inline __attribute__((always_inline)) void
      add<3>(double *values,
             const int *offset,
             const int n,
             const EightDoubles *x)
      {
        // pairs (x, y) of the even and of the odd lanes
        alignas(64) double even[8], odd[8], last[8];
        *(EightDoubles *)even = interleave(x[0], x[1], first_of_pairs);
        *(EightDoubles *)odd  = interleave(x[0], x[1], second_of_pairs);
        *(EightDoubles *)last = x[2];
        const auto add_lane   = [&](const int lane) {
          const double *pair = (lane & 1) ? odd + (lane - 1) : even + lane;
          add_triple(values + offset[lane], _mm_load_pd(pair), last[lane]);
        };
        if (n == 8)
#  pragma GCC unroll 8
          for (int lane = 0; lane < 8; ++lane)
            add_lane(lane);
        else
          for (int lane = 0; lane < n; ++lane)
            add_lane(lane);
      }
#endif
    } // namespace



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
              load<dim>(velocity, batch.offset[i], node);
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
              add<dim>(force, batch.offset[i], batch.n_filled, node);
            }
        }
    }

    template class CellKernel<2>;
    template class CellKernel<3>;
  } // namespace internal
} // namespace coapt
