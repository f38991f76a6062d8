#ifndef coapt_solid_batch_h
#define coapt_solid_batch_h

#include <coapt/base/eight_doubles.h>

#include <cmath>

namespace coapt
{
  /** Cells that are evaluated together. */
  constexpr unsigned int batch_size = 8;

  /** One number of each cell of a batch. */
  using Batch = EightDoubles;

  namespace internal
  {
    /** Replace every entry by the function of it. @{ */
    void
    square_roots(Batch &x);
    void
    exponentials(Batch &x);
    void
    logarithms(Batch &x);
    void
    cube_roots(Batch &x);
    /** @} */
  } // namespace internal

  /** Square root. */
  inline double
  square_root(const double x)
  {
    return std::sqrt(x);
  }

  /** Square root of every entry. */
  inline Batch
  square_root(const Batch &x)
  {
#ifdef __AVX512F__
    return (Batch)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#else
    Batch result = x;
    internal::square_roots(result);
    return result;
#endif
  }

  /** Exponential function. */
  inline double
  exponential(const double x)
  {
    return std::exp(x);
  }

  /** Exponential function of every entry. */
  inline Batch
  exponential(const Batch &x)
  {
    Batch result = x;
    internal::exponentials(result);
    return result;
  }

  /** Natural logarithm. */
  inline double
  logarithm(const double x)
  {
    return std::log(x);
  }

  /** Natural logarithm of every entry. */
  inline Batch
  logarithm(const Batch &x)
  {
    Batch result = x;
    internal::logarithms(result);
    return result;
  }

  /** Cube root. */
  inline double
  cube_root(const double x)
  {
    return std::cbrt(x);
  }

  /** Cube root of every entry. */
  inline Batch
  cube_root(const Batch &x)
  {
    Batch result = x;
    internal::cube_roots(result);
    return result;
  }

  /**
   * The larger one of @p x and @p bound, for numbers and batches; a NaN in
   * @p x stays a NaN.
   */
  template <typename Number>
  inline Number
  at_least(const Number &x, const double bound)
  {
    return x < bound ? Number{} + bound : x;
  }

  /** The smaller one of @p x and @p bound; a NaN in @p x stays a NaN. */
  template <typename Number>
  inline Number
  at_most(const Number &x, const double bound)
  {
    return x > bound ? Number{} + bound : x;
  }

  /** The larger entries of @p x and @p y; a NaN in @p y stays a NaN. */
  template <typename Number>
  inline Number
  larger(const Number &x, const Number &y)
  {
    return x > y ? x : y;
  }

  /** Whether @p x is at most @p bound; no NaN is. */
  inline bool
  none_above(const double x, const double bound)
  {
    return x <= bound;
  }

  /** Whether every entry is at most that of @p bound; no NaN is. */
  inline bool
  none_above(const Batch &x, const Batch &bound)
  {
    const auto below = x <= bound;
    bool all         = true;
    for (unsigned int i = 0; i < batch_size; ++i)
      all = all && below[i];
    return all;
  }

  /** Absolute value. */
  template <typename Number>
  inline Number
  absolute(const Number &x)
  {
    return x < 0 ? -x : x;
  }
} // namespace coapt

#endif
