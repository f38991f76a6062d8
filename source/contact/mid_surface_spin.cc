#include <coapt/contact/mid_surface_spin.h>

#include <algorithm>
#include <array>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Points on a line have a determinant of zero over the cube of the trace;
     * below this they have neither spin nor couples. */
    constexpr double least_determinant = 1e-9;

    /** Inertia (kg m^2) about the centre of mass, at @p shift (m), of points
     * with the @p moment (kg m) and the @p second ones (kg m^2: xx, yy, zz, xy,
     * yz, zx) about the origin. */
    Tensor<2, 3>
    inertia_of(std::array<double, 6> second,
               const Tensor<1, 3> &moment,
               const Tensor<1, 3> &shift)
    {
      Tensor<2, 3> inertia;
      for (unsigned int i = 0; i < 3; ++i)
        {
          second[i] -= moment[i] * shift[i];
          second[3 + i] -= moment[i] * shift[(i + 1) % 3];
        }
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j = (i + 1) % 3;
          inertia[i][i]        = second[j] + second[(i + 2) % 3];
          inertia[i][j]        = -second[3 + i];
          inertia[j][i]        = inertia[i][j];
        }
      return inertia;
    }
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

    // Sums in one pass, as seen from the column; those about the centre follow.
    const Point<3> &origin     = centres[column];
    const Tensor<1, 3> &motion = velocities[column];
    double mass                = 0;
    Tensor<1, 3> moment, momentum, moment_of_momentum; // the first of mass
    std::array<double, 6> second{};
    for (const unsigned int c : around[column])
      {
        const double m              = surface.mass(c);
        const Tensor<1, 3> arm      = centres[c] - origin;
        const Tensor<1, 3> part     = m * arm;
        const Tensor<1, 3> relative = velocities[c] - motion;
        mass += m;
        moment += part;
        momentum += m * relative;
        moment_of_momentum += cross_product_3d(part, relative);
        for (unsigned int i = 0; i < 3; ++i)
          {
            second[i] += part[i] * arm[i];
            second[3 + i] += part[i] * arm[(i + 1) % 3];
          }
      }
    const Tensor<1, 3> shift = moment / mass;
    result.centre            = origin + shift;
    moment_of_momentum -= cross_product_3d(shift, momentum);
    const Tensor<2, 3> inertia = inertia_of(second, moment, shift);
    const double size          = trace(inertia);
    if (determinant(inertia) > least_determinant * size * size * size)
      {
        result.inverse_inertia = invert(inertia);
        result.spin            = result.inverse_inertia * moment_of_momentum;
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
