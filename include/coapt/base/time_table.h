#ifndef coapt_base_time_table_h
#define coapt_base_time_table_h

#include <string>
#include <vector>

namespace coapt
{
  /**
   * A quantity given at increasing times, such as the pressure at an end of
   * the tube. Between the rows a monotone cubic interpolates: it has a
   * continuous first derivative and neither overshoots nor adds an extremum
   * (Fritsch and Carlson 1980; slopes by the weighted harmonic mean of Fritsch
   * and Butland 1984, at the ends by the limited three-point formula). Before
   * the first and after the last row the value is held.
   */
  class TimeTable
  {
  public:
    /**
     * From rows in SI. @p origin names the rows in error messages.
     *
     * @throws InputError if there are fewer than two rows, if times and values
     * differ in number, if a number is not finite, or times do not increase.
     */
    TimeTable(const std::vector<double> &times,
              const std::vector<double> &values,
              const std::string &origin = "time table");

    /**
     * From a text file with a row `time, value` a line; time in s. Blank lines
     * and what follows a `#` are skipped. The first line may name the columns;
     * the name of the second then ends with the unit, such as
     * `time_s,pressure_mmHg`.
     *
     * @param unit `from file`, or `Pa`, `kPa`, `mmHg` for a file without
     * header.
     * @throws InputError with file and line number if the file is missing,
     * empty or truncated, holds something else than finite numbers, if times do
     * not increase, or if the unit is missing, unknown or contradicted.
     */
    static TimeTable
    from_file(const std::string &file, const std::string &unit = "from file");

    /**
     * From one line such as `0:0.1, 0.01:17.5` (time in s : value in @p unit).
     *
     * @throws InputError as from_file().
     */
    static TimeTable
    from_list(const std::string &list, const std::string &unit = "Pa");

    /** Units that from_file() understands, as a deal.II Selection pattern. */
    static std::string
    unit_names();

    /** The value at @p time (s), in SI. */
    double
    value(const double time) const;

    /** Same as value(). */
    double
    operator()(const double time) const
    {
      return value(time);
    }

    /** The largest magnitude of all values, in SI. */
    double
    largest_magnitude() const;

    /** Time of the last row (s). */
    double
    last_time() const
    {
      return times.back();
    }

  private:
    /** Slopes of the monotone cubic at the rows. */
    void
    compute_slopes();

    std::vector<double> times;
    std::vector<double> values;
    std::vector<double> slopes;
  };

  /**
   * Where the file @p name is that a parameter file in the folder @p folder
   * speaks of: relative to the parameter file or, if nothing is there, to the
   * parameter files that come with the program; otherwise as it stands, that
   * is absolute or relative to the current folder.
   */
  std::string
  find_input_file(const std::string &name, const std::string &folder);
} // namespace coapt

#endif
