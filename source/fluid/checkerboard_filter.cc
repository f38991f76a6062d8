#include <coapt/fluid/cell_modes.h>
#include <coapt/fluid/checkerboard_filter.h>

#include <cmath>

namespace coapt
{
  namespace
  {
    /** Amplitudes s_S . p of the alternating patterns of a family; those of
     * the mean and of the linear patterns are set to zero. */
    template <int dim>
    inline void
    alternating_modes(const std::array<unsigned int, 1 << dim> &cells,
                      const double *pressure,
                      double *mode)
    {
      for (int i = 0; i < (1 << dim); ++i)
        mode[i] = pressure[cells[i]];
      internal::corners_to_modes<dim>(mode);
      for (int s = 0; s < (1 << dim); ++s)
        if (!internal::is_hourglass(s))
          mode[s] = 0;
    }

    /** Sum of the squares of the modes. */
    template <int dim>
    inline double
    norm_square(const double *mode)
    {
      double sum = 0;
      for (int s = 0; s < (1 << dim); ++s)
        sum += mode[s] * mode[s];
      return sum;
    }
  } // namespace



  template <int dim>
  void
  CheckerboardFilter<dim>::clear()
  {
    families.clear();
    rates.clear();
    sizes.clear();
  }



  template <int dim>
  void
  CheckerboardFilter<dim>::add_family(const Family &cells,
                                      const double rate,
                                      const double size)
  {
    families.push_back(cells);
    rates.push_back(rate);
    sizes.push_back(size);
  }



  template <int dim>
  void
  CheckerboardFilter<dim>::add_rate(const double *pressure,
                                    double *pressure_rate) const
  {
    for (unsigned int f = 0; f < families.size(); ++f)
      {
        double mode[1 << dim];
        alternating_modes<dim>(families[f], pressure, mode);
        internal::modes_to_corners<dim>(mode);
        const double factor = rates[f] / (1 << dim);
        for (int i = 0; i < (1 << dim); ++i)
          pressure_rate[families[f][i]] -= factor * mode[i];
      }
  }



  template <int dim>
  double
  CheckerboardFilter<dim>::power(const double *pressure,
                                 const double bulk_modulus) const
  {
    double sum = 0;
    for (unsigned int f = 0; f < families.size(); ++f)
      {
        double mode[1 << dim];
        alternating_modes<dim>(families[f], pressure, mode);
        sum += norm_square<dim>(mode) * rates[f] * std::pow(sizes[f], dim) /
          ((1 << dim) * bulk_modulus);
      }
    return sum;
  }



  template <int dim>
  double
  CheckerboardFilter<dim>::sum_of_squares(
    const double *pressure,
    const std::function<bool(unsigned int)> &counts,
    unsigned int &n_families) const
  {
    double sum = 0;
    n_families = 0;
    for (const Family &family : families)
      if (counts(family[0]))
        {
          double mode[1 << dim];
          alternating_modes<dim>(family, pressure, mode);
          sum += norm_square<dim>(mode) / (1 << (2 * dim));
          ++n_families;
        }
    return sum;
  }

  template class CheckerboardFilter<2>;
  template class CheckerboardFilter<3>;
} // namespace coapt
