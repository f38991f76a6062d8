#ifndef coapt_laboratory_biaxial_data_h
#define coapt_laboratory_biaxial_data_h

#include <array>
#include <string>
#include <vector>

namespace coapt
{
  /** Which stress a biaxial test reports. */
  enum class StressMeasure
  {
    first_piola,
    second_piola,
    cauchy
  };

  /** Measured stresses of a square sheet under stretches along its sides, the
   * fibres along side 1. */
  struct BiaxialData
  {
    /** A measurement; stresses in Pa. */
    struct Point
    {
      int protocol;
      std::array<double, 2> stretch;
      std::array<double, 2> stress;
    };

    std::vector<Point> points;
    StressMeasure measure = StressMeasure::first_piola;

    /**
     * From a table with the columns protocol, stretch1, stretch2, stress1 and
     * stress2. @p unit: Pa, kPa or MPa.
     *
     * @throws InputError if the table cannot be read (NumberTable), a stretch
     * is not positive, or there is no stress but zero.
     */
    static BiaxialData
    from_file(const std::string &file,
              const StressMeasure measure,
              const std::string &unit);

    /** Stress in this measure over the first Piola-Kirchhoff stress, at a
     * stretch in the same direction, of an incompressible sheet. */
    double
    factor(const double stretch) const
    {
      switch (measure)
        {
          case StressMeasure::first_piola:
            return 1;
          case StressMeasure::second_piola:
            return 1 / stretch;
          default:
            return stretch;
        }
    }
  };
} // namespace coapt

#endif
