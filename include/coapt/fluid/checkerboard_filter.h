#ifndef coapt_fluid_checkerboard_filter_h
#define coapt_fluid_checkerboard_filter_h

#include <array>
#include <functional>
#include <vector>

namespace coapt
{
  /**
   * Damps pressures that alternate from cell to cell in two or more
   * directions, which the divergence of a Q1 velocity barely sees. It works
   * on families, the 2^dim children of one octree cell: with the patterns
   * s_S = +-1, S alternating in at least two directions,
   *
   *   p' = -r sum_S s_S (s_S . p) / 2^dim,   r = coefficient c/h.
   *
   * The patterns sum to zero, so no mass is made or lost.
   */
  template <int dim>
  class CheckerboardFilter
  {
  public:
    /** Pressure indices of the children of one cell, deal.II's order. */
    using Family = std::array<unsigned int, 1 << dim>;

    /** Forgets all families. */
    void
    clear();

    /** Adds a family of children of size @p size (m) that decays at the
     * rate @p rate (1/s). */
    void
    add_family(const Family &cells, const double rate, const double size);

    /** Adds the filter's part to @p pressure_rate (Pa/s). */
    void
    add_rate(const double *pressure, double *pressure_rate) const;

    /** Power (W) that the filter takes from the acoustic energy
     * p^2 V/(2 K) of this rank's families, K the bulk modulus (Pa). */
    double
    power(const double *pressure, const double bulk_modulus) const;

    /** Sum over this rank's families of the squared amplitudes (Pa^2) of all
     * patterns. Families for whose first cell @p counts is false are left
     * out; @p n_families counts the others. */
    double
    sum_of_squares(const double *pressure,
                   const std::function<bool(unsigned int)> &counts,
                   unsigned int &n_families) const;

  private:
    std::vector<Family> families;
    std::vector<double> rates;
    std::vector<double> sizes;
  };
} // namespace coapt

#endif
