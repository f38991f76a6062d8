#include <coapt/laboratory/fit_report.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace coapt
{
  namespace
  {
    /** Strain of the material that its exponential limit is compared with, the
     * largest one of the data; zero if it has none. */
    double
    largest_strain(const Material &material, const BiaxialData &data)
    {
      const double fibre[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      double largest        = 0;
      for (const auto &point : data.points)
        {
          SmallMatrix<3, double> F{};
          F[0][0] = point.stretch[0];
          F[1][1] = point.stretch[1];
          F[2][2] = 1 / (point.stretch[0] * point.stretch[1]);
          std::visit(
            [&](const auto &law) {
              largest = std::max(largest, law.strain_ratio(F, fibre));
            },
            material);
        }
      return largest;
    }

    /** What the data say about a parameter. */
    std::string
    verdict(const FittedVariable &v)
    {
      if (v.determined_below && v.determined_above)
        return "determined";
      if (v.determined_above)
        return "not bounded from below by the data";
      if (v.determined_below)
        return "not bounded from above by the data";
      return "not determined by the data";
    }
  } // namespace

  std::string
  fit_text(const TissueModel &model, const FitResult &result)
  {
    std::ostringstream text;
    text << model.name() << ": R2 " << std::setprecision(4)
         << result.r_squared[2] << " (direction 1: " << result.r_squared[0]
         << ", 2: " << result.r_squared[1] << "), NMAD " << result.nmad
         << " %, " << result.n_minima << " local minima from "
         << result.n_starts << " starts";
    for (const FittedVariable &v : result.variables)
      text << "\n  " << std::setw(9) << std::left << v.variable.name << " "
           << std::setprecision(5) << v.value << " " << v.variable.unit
           << ", confidence " << v.lower << " to " << v.upper << ", profile "
           << v.profile_lower << " to " << v.profile_upper << ": "
           << verdict(v);
    return text.str();
  }

  std::string
  material_block(const TissueModel &model,
                 const BiaxialData &data,
                 const FitResult &result)
  {
    // The models have the limit 1e300; their strains are relative to it.
    const double strain = 1e300 *
      largest_strain(model.material(result.stiffness, result.shape), data);
    const double limit = std::max(1.1 * strain, 1e-3);
    std::ostringstream text;
    text << "# R2 " << std::setprecision(4) << result.r_squared[2] << ", NMAD "
         << result.nmad << " %\n"
         << "subsection Solid\n  set Material = " << model.name()
         << "\n  subsection " << model.subsection() << "\n";
    for (const auto &entry :
         model.entries(result.stiffness, result.shape, limit))
      text << "    set " << entry.first << " = " << entry.second << "\n";
    text << "  end\nend\n";
    return text.str();
  }

  std::string
  comparison_table(const BiaxialData &data, const FitResult &result)
  {
    std::ostringstream text;
    text << std::setprecision(8)
         << "protocol,stretch1,stretch2,measured1_kPa,measured2_kPa,"
            "model1_kPa,model2_kPa\n";
    for (std::size_t i = 0; i < data.points.size(); ++i)
      {
        const auto &p = data.points[i];
        text << p.protocol << ',' << p.stretch[0] << ',' << p.stretch[1] << ','
             << p.stress[0] / 1e3 << ',' << p.stress[1] / 1e3 << ','
             << result.stress[i][0] / 1e3 << ',' << result.stress[i][1] / 1e3
             << '\n';
      }
    return text.str();
  }

  std::string
  profile_table(const FitResult &result)
  {
    std::ostringstream text;
    text << std::setprecision(10)
         << "parameter,value,sum_of_squares_over_least\n";
    for (const FittedVariable &v : result.variables)
      for (const auto &point : v.profile)
        text << v.variable.name << ',' << point[0] << ','
             << point[1] / result.sum_of_squares << '\n';
    return text.str();
  }
} // namespace coapt
