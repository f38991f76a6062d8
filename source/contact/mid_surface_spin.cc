#include <coapt/contact/mid_surface_spin.h>

#include <algorithm>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Points on a line have a determinant of zero over the cube of the trace;
     * below this they have neither spin nor couples. */
    constexpr double least_determinant = 1e-9;
  } // namespace



  MidSurfaceSpin::MidSurfaceSpin(const MidSurface &surface)
    : surface(surface)
    , around(surface.n_columns())
    , centres(surface.n_columns())
    , velocities(surface.n_columns())
    , bodies(surface.n_columns())
  {
    for (const auto &quad : surface.quadrilaterals())
      for (const unsigned int column : quad)
        around[column].insert(around[column].end(), quad.begin(), quad.end());
    for (auto &columns : around)
      {
        std::sort(columns.begin(), columns.end());
        columns.erase(std::unique(columns.begin(), columns.end()),
                      columns.end());
      }
  }



  void
  MidSurfaceSpin::set_state(const double *X, const double *V)
  {
    for (unsigned int c = 0; c < centres.size(); ++c)
      {
        centres[c]           = Point<3>(surface.mean_by_mass(c, X));
        velocities[c]        = surface.mean_by_mass(c, V);
        bodies[c].is_current = false;
      }
  }



  const MidSurfaceSpin::Body &
  MidSurfaceSpin::body(const unsigned int column)
  {
    Body &result = bodies[column];
    if (result.is_current)
      return result;
    result = Body();

    double mass = 0;
    Tensor<1, 3> moment;
    for (const unsigned int c : around[column])
      {
        mass += surface.mass(c);
        moment += surface.mass(c) * centres[c];
      }
    result.centre = Point<3>(moment / mass);

    Tensor<2, 3> inertia;
    Tensor<1, 3> momentum; // its moment
    for (const unsigned int c : around[column])
      {
        const Tensor<1, 3> arm = centres[c] - result.centre;
        momentum += surface.mass(c) * cross_product_3d(arm, velocities[c]);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            inertia[i][j] += surface.mass(c) *
              ((i == j ? arm.norm_square() : 0.) - arm[i] * arm[j]);
      }
    const double size = trace(inertia);
    if (determinant(inertia) > least_determinant * size * size * size)
      {
        result.inverse_inertia = invert(inertia);
        result.spin            = result.inverse_inertia * momentum;
      }
    result.is_current = true;
    return result;
  }



  const Tensor<1, 3> &
  MidSurfaceSpin::spin(const unsigned int column)
  {
    return body(column).spin;
  }



  double
  MidSurfaceSpin::inverse_inertia(const unsigned int column)
  {
    return trace(body(column).inverse_inertia);
  }



  const std::vector<MidSurfaceSpin::Impulse> &
  MidSurfaceSpin::impulses(const unsigned int column,
                           const Tensor<1, 3> &couple)
  {
    const Body &all         = body(column);
    const Tensor<1, 3> spin = all.inverse_inertia * couple;
    parts.clear();
    for (const unsigned int c : around[column])
      parts.push_back(
        {c, surface.mass(c) * cross_product_3d(spin, centres[c] - all.centre)});
    return parts;
  }
} // namespace coapt
