#ifndef coapt_base_eight_doubles_h
#define coapt_base_eight_doubles_h

#ifdef __AVX512F__
#  include <immintrin.h>
#endif

namespace coapt
{
  /** Eight numbers, one a cell, that are worked on together (a vector type of
   * GCC: arithmetic and comparison act on all, as does the ternary
   * operator). */
  typedef double EightDoubles __attribute__((vector_size(64)));

  /**
   * The vectors of dim components of eight nodes, x[c] = component c of all
   * of them; @p offset are the places of their first components in
   * @p values.
   */
  template <int dim>
  inline __attribute__((always_inline)) void
  load_nodes(const double *values, const int *offset, EightDoubles *x)
  {
    for (int lane = 0; lane < 8; ++lane)
      for (int c = 0; c < dim; ++c)
        x[c][lane] = values[offset[lane] + c];
  }

  /** Adds the first @p n of eight node vectors to their places, one after the
   * other since cells share nodes. */
  template <int dim>
  inline __attribute__((always_inline)) void
  add_to_nodes(double *values,
               const int *offset,
               const int n,
               const EightDoubles *x)
  {
    for (int lane = 0; lane < n; ++lane)
      for (int c = 0; c < dim; ++c)
        values[offset[lane] + c] += x[c][lane];
  }

#if defined(__AVX512F__) && defined(__AVX512VL__)
  namespace internal
  {
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

    /** Adds a pair and a single number to a node triple. */
    inline __attribute__((always_inline)) void
    add_triple(double *values, const __m128d pair, const double last)
    {
      _mm_storeu_pd(values, _mm_add_pd(_mm_loadu_pd(values), pair));
      values[2] += last;
    }
  } // namespace internal

  /** The same for triples, loaded whole and transposed. */
  template <>
  inline __attribute__((always_inline)) void
  load_nodes<3>(const double *values, const int *offset, EightDoubles *x)
  {
    using namespace internal;
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

  /** The same for triples, which are transposed first. */
  template <>
  inline __attribute__((always_inline)) void
  add_to_nodes<3>(double *values,
                  const int *offset,
                  const int n,
                  const EightDoubles *x)
  {
    using namespace internal;
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
} // namespace coapt

#endif
