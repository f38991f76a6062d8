#include <coapt/base/exceptions.h>
#include <coapt/solid/materials/fung.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace coapt
{
  using dealii::Patterns::Double;

  void
  Fung::declare_parameters(dealii::ParameterHandler &prm)
  {
    const Fung defaults;
    prm.enter_subsection(name);
    prm.declare_entry("c",
                      std::to_string(defaults.c),
                      Double(0, 1e12),
                      "Stiffness c (Pa).");
    prm.declare_entry("b",
                      "12, 4, 0, 8, 0, 4",
                      dealii::Patterns::List(Double(), 6, 21),
                      "Tensor b (-), of axes fibre (1), across it in the "
                      "tangent plane (2) and normal (3): planar 1111, 1122, "
                      "1112, 2222, 2212, 1212; or in 3D 1111, 1122, 1133, "
                      "1112, 1113, 1123, 2222, 2233, 2212, 2213, 2223, 3333, "
                      "3312, 3313, 3323, 1212, 1213, 1223, 1313, 1323, 2323. "
                      "Neither may have a negative eigenvalue.");
    prm.declare_entry("C10",
                      std::to_string(defaults.C10),
                      Double(0, 1e12),
                      "Stiffness of a neo-Hookean matrix (Pa), half its shear "
                      "modulus; zero in the published law. A planar b alone "
                      "resists no transverse shear.");
    prm.declare_entry("Exponential limit",
                      std::to_string(defaults.exponential_limit),
                      Double(1e-3, 100),
                      "Value of the exponent (-) beyond which the "
                      "exponential is continued by a parabola.");
    prm.declare_entry("Bulk modulus",
                      std::to_string(defaults.bulk),
                      Double(1e-3, 1e14),
                      "Bulk modulus (Pa).");
    prm.leave_subsection();
  }

  void
  Fung::parse_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Utilities;
    prm.enter_subsection(name);
    c                 = prm.get_double("c");
    b                 = string_to_double(split_string_list(prm.get("b")));
    C10               = prm.get_double("C10");
    exponential_limit = prm.get_double("Exponential limit");
    bulk              = prm.get_double("Bulk modulus");
    prm.leave_subsection();
    check();
  }

  Fung::Matrix
  Fung::cholesky(const Matrix &B)
  {
    double largest = 0;
    for (int i = 0; i < 6; ++i)
      largest = std::max(largest, std::abs(B[7 * i]));
    // Round-off of a singular matrix is not a negative eigenvalue.
    const double tolerance = 1e-12 * largest;
    Matrix R{};
    for (int j = 0; j < 6; ++j)
      {
        double pivot = B[7 * j];
        for (int k = 0; k < j; ++k)
          pivot -= R[6 * j + k] * R[6 * j + k];
        const bool zero = std::abs(pivot) <= tolerance;
        R[7 * j]        = zero ? 0 : std::sqrt(pivot);
        for (int i = j + 1; i < 6; ++i)
          {
            double sum = B[6 * i + j];
            for (int k = 0; k < j; ++k)
              sum -= R[6 * i + k] * R[6 * j + k];
            if (!zero)
              R[6 * i + j] = sum / R[7 * j];
            else if (std::abs(sum) > std::sqrt(tolerance * largest))
              R[6 * i + j] = std::nan("");
          }
      }
    return R;
  }

  void
  Fung::check() const
  {
    std::ostringstream message;
    if (b.size() != 6 && b.size() != 21)
      message << "b has " << b.size()
              << " numbers, expected are 6 (planar) or 21 (3D)";
    else if (!(c >= 0 && C10 >= 0 && exponential_limit > 0 && bulk > 0))
      message << "c = " << c << ", C10 = " << C10
              << ", exponential limit = " << exponential_limit
              << ", bulk modulus = " << bulk
              << ": the last two must be positive, the others not negative";
    else
      {
        const Matrix factor = cholesky(matrix());
        if (!std::all_of(factor.begin(), factor.end(), [](const double x) {
              return std::isfinite(x);
            }))
          message << "the tensor b has a negative eigenvalue, with which the "
                     "energy would be negative";
      }
    if (!message.str().empty())
      throw InputError("Material Fung: " + message.str() +
                       " (subsection Solid/Fung).");
  }
} // namespace coapt
