#ifndef coapt_solid_batch_h
#define coapt_solid_batch_h

#include <cmath>

namespace coapt
{
  /** Cells that are evaluated together. */
  constexpr unsigned int batch_size = 8;

  /**
   * One number of each cell of a batch (a vector type of GCC: arithmetic and
   * comparison act on all entries, as does the ternary operator).
   */
  typedef double Batch
    __attribute__((vector_size(batch_size * sizeof(double))));

  /** The function @p f of every entry of @p x. */
  template <typename Function>
  inline Batch
  for_each_entry(const Batch &x, const Function &f)
  {
    Batch result{};
    for (unsigned int i = 0; i < batch_size; ++i)
      result[i] = f(x[i]);
    return result;
  }

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
    return for_each_entry(x, [](const double y) { return std::sqrt(y); });
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
    return for_each_entry(x, [](const double y) { return std::exp(y); });
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
    return for_each_entry(x, [](const double y) { return std::log(y); });
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
    return for_each_entry(x, [](const double y) { return std::cbrt(y); });
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

  /** Absolute value. */
  template <typename Number>
  inline Number
  absolute(const Number &x)
  {
    return x < 0 ? -x : x;
  }
} // namespace coapt

#endif
