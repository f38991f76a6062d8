#include <coapt/base/exceptions.h>
#include <coapt/geometry/lumen.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    constexpr double mm = 1e-3;

    /**
     * Distance from (x, y) in the first quadrant to the ellipse with the
     * semi-axes @p a, @p b. The nearest point of the ellipse is
     * (a^2 x/(t + a^2), b^2 y/(t + b^2)) with t the largest root of
     *   g(t) = (a x/(t + a^2))^2 + (b y/(t + b^2))^2 - 1,
     * which is convex and falling right of its last pole -min(a,b)^2, so that
     * Newton's method from the left converges monotonically (Eberly 2013).
     */
    double
    distance_to_ellipse(const double a,
                        const double b,
                        const double x,
                        const double y)
    {
      if (a == b)
        return std::abs(std::hypot(x, y) - a);
      const double shortest = std::min(a, b);
      const double pole     = -shortest * shortest;
      // a start with g >= 0: one of the two terms alone is one there
      double t = std::max(a * x - a * a, b * y - b * b);
      if (t <= pole * (1 - 1e-12))
        {
          // on the long axis, inside of the evolute: the nearest point is off
          // the axis
          const double longest = std::max(a, b);
          const double along   = a > b ? x : y;
          const double foot    = longest * longest * along /
            (longest * longest - shortest * shortest);
          const double cosine = std::min(1., foot / longest);
          return std::hypot(foot - along,
                            shortest * std::sqrt(1 - cosine * cosine));
        }
      for (unsigned int iteration = 0; iteration < 100; ++iteration)
        {
          const double u = a * x / (t + a * a), v = b * y / (t + b * b);
          const double g     = u * u + v * v - 1;
          const double slope = -2 * (u * u / (t + a * a) + v * v / (t + b * b));
          const double step  = -g / slope;
          t += step;
          if (std::abs(step) < 1e-13 * (a * a + b * b))
            break;
        }
      return std::hypot(x - a * a * x / (t + a * a),
                        y - b * b * y / (t + b * b));
    }
  } // namespace



  void
  LumenParameters::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Lumen");
    prm.declare_entry("Inset",
                      "0.75",
                      Patterns::Double(0, 20),
                      "How far the wall stands inside of the annulus line "
                      "(mm). The root of the leaflet is buried by that much; "
                      "it must be at least one fluid cell to be tight.");
    prm.declare_entry("Ventricular length",
                      "35",
                      Patterns::Double(1, 500),
                      "Length of the lumen below the annulus plane (mm).");
    prm.declare_entry("Atrial length",
                      "15",
                      Patterns::Double(1, 500),
                      "Length of the lumen above the annulus plane (mm).");
    prm.declare_entry("Margin",
                      "2",
                      Patterns::Double(0, 100),
                      "How far the box of the fluid mesh reaches beyond the "
                      "annulus sideways (mm).");
    prm.leave_subsection();
  }



  void
  LumenParameters::parse_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Lumen");
    inset              = prm.get_double("Inset") * mm;
    ventricular_length = prm.get_double("Ventricular length") * mm;
    atrial_length      = prm.get_double("Atrial length") * mm;
    margin             = prm.get_double("Margin") * mm;
    prm.leave_subsection();
  }



  FittedTube::FittedTube(const LumenParameters &parameters,
                         const double semi_axis_x,
                         const double semi_axis_y)
    : a(semi_axis_x - parameters.inset)
    , b(semi_axis_y - parameters.inset)
    , corners{Point<3>(-semi_axis_x - parameters.margin,
                       -semi_axis_y - parameters.margin,
                       -parameters.ventricular_length),
              Point<3>(semi_axis_x + parameters.margin,
                       semi_axis_y + parameters.margin,
                       parameters.atrial_length)}
  {
    if (!(std::min(a, b) > 0))
      throw InputError("Lumen/Inset is " +
                       std::to_string(parameters.inset / mm) +
                       " mm, but must be less than the semi-axes of the "
                       "annulus.");
  }



  double
  FittedTube::signed_distance(const Point<3> &p) const
  {
    const double distance =
      distance_to_ellipse(a, b, std::abs(p[0]), std::abs(p[1]));
    return inside(p) ? -distance : distance;
  }



  bool
  FittedTube::inside(const Point<3> &p) const
  {
    const double x = p[0] / a, y = p[1] / b;
    return x * x + y * y < 1;
  }



  Point<3>
  FittedTube::lower() const
  {
    return corners[0];
  }



  Point<3>
  FittedTube::upper() const
  {
    return corners[1];
  }



  double
  FittedTube::semi_axis_x() const
  {
    return a;
  }



  double
  FittedTube::semi_axis_y() const
  {
    return b;
  }
} // namespace coapt
