#ifndef coapt_base_node_register_h
#define coapt_base_node_register_h

#ifdef __AVX512VL__
#  include <immintrin.h>
#endif

namespace coapt
{
  /** A vector type of the compiler (arithmetic acts on all entries) of 2, 4 or
   * 8 numbers. @{ */
  template <int n>
  struct VectorOfDoubles;

  template <>
  struct VectorOfDoubles<2>
  {
    typedef double type __attribute__((vector_size(16)));
  };

  template <>
  struct VectorOfDoubles<4>
  {
    typedef double type __attribute__((vector_size(32)));
  };

  template <>
  struct VectorOfDoubles<8>
  {
    typedef double type __attribute__((vector_size(64)));
  };
  /** @} */

  /** The dim components of a vector at a node in one register; in 3D the
   * fourth number is idle. */
  template <int dim>
  struct NodeRegister
  {
    static_assert(dim == 2 || dim == 3, "Two or three dimensions.");

    using Register = typename VectorOfDoubles<dim == 2 ? 2 : 4>::type;

    /** The numbers that begin at @p x; the idle one is zero. */
    static inline __attribute__((always_inline)) Register
    load(const double *x)
    {
#ifdef __AVX512VL__
      // Entry by entry it would take three instructions more.
      if constexpr (dim == 3)
        return (Register)_mm256_maskz_loadu_pd(7, x);
#endif
      Register result{};
      for (int d = 0; d < dim; ++d)
        result[d] = x[d];
      return result;
    }

    /** Writes dim numbers from @p x on. */
    static inline __attribute__((always_inline)) void
    store(const Register &value, double *x)
    {
#ifdef __AVX512VL__
      if constexpr (dim == 3)
        {
          _mm256_mask_storeu_pd(x, 7, (__m256d)value);
          return;
        }
#endif
      for (int d = 0; d < dim; ++d)
        x[d] = value[d];
    }

    /** Adds to the numbers from @p x on. */
    static inline __attribute__((always_inline)) void
    add(const Register &value, double *x)
    {
      for (int d = 0; d < dim; ++d)
        x[d] += value[d];
    }
  };
} // namespace coapt

#endif
