#ifndef coapt_laboratory_fit_report_h
#define coapt_laboratory_fit_report_h

#include <coapt/laboratory/tissue_fit.h>

#include <string>

namespace coapt
{
  /** Quality and parameters with their intervals, several lines. */
  std::string
  fit_text(const TissueModel &model, const FitResult &result);

  /** The subsection Solid of a parameter file that gives the fitted material,
   * whose exponential limit lies above the strains of the data. */
  std::string
  material_block(const TissueModel &model,
                 const BiaxialData &data,
                 const FitResult &result);

  /** Rows protocol, stretches, measured and model stresses (kPa). */
  std::string
  comparison_table(const BiaxialData &data, const FitResult &result);

  /** Rows parameter, value, sum of squares over the least one. */
  std::string
  profile_table(const FitResult &result);
} // namespace coapt

#endif
