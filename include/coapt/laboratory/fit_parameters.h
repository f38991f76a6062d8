#ifndef coapt_laboratory_fit_parameters_h
#define coapt_laboratory_fit_parameters_h

#include <coapt/laboratory/biaxial_data.h>
#include <coapt/laboratory/tissue_fit.h>

#include <map>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace coapt
{
  /** Which materials are fitted to which data: the subsection "Fit". */
  struct FitParameters
  {
    std::string data_file              = "tables/biaxial_example.csv";
    StressMeasure measure              = StressMeasure::first_piola;
    std::string unit                   = "kPa";
    unsigned int ogden_order           = 2;
    std::vector<std::string> materials = {"HGO"};

    /** Lower and upper bound of the parameters of these names. */
    std::map<std::string, std::array<double, 2>> bounds;

    FitOptions options;

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. @throws InputError if bounds cannot be understood. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /** The model of the material of this name within the given bounds.
     * @throws InputError if a bound's name belongs to no parameter of any of
     * the materials. */
    std::unique_ptr<TissueModel>
    model(const std::string &material) const;
  };
} // namespace coapt

#endif
