#ifndef coapt_base_varied_parameters_h
#define coapt_base_varied_parameters_h

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /**
   * What changes from run to run in a study: parameters, by their full names
   * such as Mesh/Leaflet level, with a value of each for every run. Subsection
   * Study.
   */
  class VariedParameters
  {
  public:
    /** Declares the parameters of the study, which is none by default. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. Throws InputError if names and values do not match. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** Number of runs, zero if there is no study. */
    unsigned int
    n_runs() const;

    /** What is special of this run, in words. */
    std::string
    label(const unsigned int run) const;

    /** Names and values of a run; not-a-number for what is no number. */
    std::vector<std::pair<std::string, double>>
    columns(const unsigned int run) const;

    /**
     * Calls @p read while @p prm has the values of this run, and gives it back
     * its own ones.
     *
     * @throws InputError if there is no such parameter or a value is not
     * allowed; names the parameter.
     */
    void
    with_values(dealii::ParameterHandler &prm,
                const unsigned int run,
                const std::function<void()> &read) const;

  private:
    struct Parameter
    {
      std::string name;
      std::vector<std::string> values;
    };
    std::vector<Parameter> parameters;
  };
} // namespace coapt

#endif
