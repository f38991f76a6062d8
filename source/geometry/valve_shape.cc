#include <coapt/geometry/valve_generator.h>

#include <cmath>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    constexpr double pi = numbers::PI;

    /** Place on a leaflet: -1 at the left, 1 at the right commissure. */
    struct LeafletCoordinate
    {
      bool anterior;
      double xi;
    };

    LeafletCoordinate
    leaflet_coordinate(const ValveParameters &valve, const double t)
    {
      // into [-pi/2, 3 pi/2): from mid-posterior once around
      const double angle = t - 2 * pi * std::floor((t + pi / 2) / (2 * pi));
      const double right = valve.commissure_angle;
      if (angle >= right && angle <= pi - right)
        return {true, (pi / 2 - angle) / (pi / 2 - right)};
      const double from_posterior =
        (angle > pi / 2 ? angle - 2 * pi : angle) + pi / 2;
      return {false, from_posterior / (pi / 2 + right)};
    }

    /** 1 in the middle of a leaflet, 0 at the commissures. */
    double
    profile(const double xi, const double exponent)
    {
      const double cosine = std::cos(pi / 2 * std::pow(std::abs(xi), exponent));
      return cosine * cosine;
    }

    double
    cone_angle(const ValveParameters &valve, const double t)
    {
      const LeafletCoordinate place = leaflet_coordinate(valve, t);
      const double middle =
        place.anterior ? valve.anterior_cone_angle : valve.posterior_cone_angle;
      return valve.commissure_cone_angle +
        (middle - valve.commissure_cone_angle) * profile(place.xi, 1);
    }

    /** Where the leaflet at angle @p t reaches the coaptation surface. */
    Point<3>
    top_of_coaptation(const ValveParameters &valve, const double t)
    {
      const double xi        = leaflet_coordinate(valve, t).xi;
      const Point<3> end     = annulus_point(valve, valve.commissure_angle);
      const double end_depth = end[2] - valve.coaptation_end_drop;
      return Point<3>(valve.coaptation_half_width * end[0] * xi,
                      end[1] + (valve.coaptation_y - end[1]) * (1 - xi * xi),
                      -valve.coaptation_depth +
                        (end_depth + valve.coaptation_depth) * xi * xi);
    }
  } // namespace



  Point<3>
  annulus_point(const ValveParameters &valve, const double t)
  {
    return Point<3>(valve.annulus_semi_axis_x * std::cos(t),
                    valve.annulus_semi_axis_y * std::sin(t),
                    -valve.saddle_height / 2 * std::cos(2 * t));
  }



  double
  leaflet_height(const ValveParameters &valve, const double t)
  {
    const LeafletCoordinate place = leaflet_coordinate(valve, t);
    const double middle =
      place.anterior ? valve.anterior_height : valve.posterior_height;
    const double exponent =
      place.anterior ? valve.anterior_exponent : valve.posterior_exponent;
    return valve.commissure_height +
      (middle - valve.commissure_height) * profile(place.xi, exponent);
  }



  Point<3>
  open_position(const ValveParameters &valve, const double t, const double s)
  {
    Tensor<1, 3> inward({-std::cos(t) / valve.annulus_semi_axis_x,
                         -std::sin(t) / valve.annulus_semi_axis_y,
                         0});
    inward /= inward.norm();
    const double angle = cone_angle(valve, t);
    const Tensor<1, 3> down({0, 0, -1});
    return annulus_point(valve, t) +
      s * leaflet_height(valve, t) *
      (std::sin(angle) * inward + std::cos(angle) * down);
  }



  Point<3>
  closed_position(const ValveParameters &valve, const double t, const double s)
  {
    const Point<3> annulus   = annulus_point(valve, t);
    const Point<3> top       = top_of_coaptation(valve, t);
    const Tensor<1, 3> chord = top - annulus;
    const double span        = chord.norm();
    const double length = s * leaflet_height(valve, t) * valve.closed_stretch;
    if (length < span)
      return annulus + chord * (length / span);
    return top + Tensor<1, 3>({0, 0, span - length});
  }
} // namespace coapt
