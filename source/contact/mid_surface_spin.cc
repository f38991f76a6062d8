#include <coapt/contact/mid_surface_spin.h>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Sine of the angle between diagonals below which a quadrilateral has
     * neither spin nor couples. */
    constexpr double least_sine = 1e-3;
  } // namespace



  MidSurfaceSpin::MidSurfaceSpin(const MidSurface &surface)
    : surface(surface)
    , corners(surface.quadrilaterals())
    , columns(surface.n_columns())
    , rotations(surface.n_columns())
    , quads(corners.size())
  {
  }



  void
  MidSurfaceSpin::set_state(const std::vector<Point<3>> &points,
                            const double *V)
  {
    this->points = &points;
    this->V      = V;
    ++step;
  }



  const Tensor<1, 3> &
  MidSurfaceSpin::velocity(const unsigned int column)
  {
    ColumnState &result = columns[column];
    if (result.step != step)
      result = {step, surface.average(column, V)};
    return result.velocity;
  }



  const MidSurfaceSpin::Quad &
  MidSurfaceSpin::current_quad(const unsigned int q)
  {
    Quad &quad = quads[q];
    if (quad.rotation.step == step)
      return quad;
    quad.rotation      = Rotation();
    quad.rotation.step = step;

    const auto &c             = corners[q];
    quad.a                    = (*points)[c[2]] - (*points)[c[0]];
    quad.b                    = (*points)[c[3]] - (*points)[c[1]];
    const Tensor<1, 3> normal = cross_product_3d(quad.a, quad.b);
    const double square       = normal.norm_square();
    const double a_2          = quad.a.norm_square();
    const double b_2          = quad.b.norm_square();
    quad.n                    = Tensor<1, 3>();
    if (!(square > least_sine * least_sine * a_2 * b_2))
      return quad;
    quad.n = normal / square;

    const Tensor<1, 3> a_rate = velocity(c[2]) - velocity(c[0]);
    const Tensor<1, 3> b_rate = velocity(c[3]) - velocity(c[1]);
    quad.rotation.spin        = (b_rate * quad.n) * quad.a -
      (a_rate * quad.n) * quad.b +
      0.5 * (a_rate * quad.b - b_rate * quad.a) * quad.n;
    quad.rotation.inverse_inertia = 1.25 / square *
      (b_2 * (surface.inverse_mass(c[0]) + surface.inverse_mass(c[2])) +
       a_2 * (surface.inverse_mass(c[1]) + surface.inverse_mass(c[3])));
    return quad;
  }



  const MidSurfaceSpin::Rotation &
  MidSurfaceSpin::rotation(const unsigned int column)
  {
    Rotation &result = rotations[column];
    if (result.step == step)
      return result;
    result             = Rotation();
    result.step        = step;
    const auto &around = surface.quadrilaterals_around(column);
    if (around.empty())
      return result;
    const double share = 1. / around.size();
    for (const unsigned int q : around)
      {
        const Rotation &part = current_quad(q).rotation;
        result.spin += share * part.spin;
        result.inverse_inertia += share * share * part.inverse_inertia;
      }
    return result;
  }



  const Tensor<1, 3> &
  MidSurfaceSpin::spin(const unsigned int column)
  {
    return rotation(column).spin;
  }



  double
  MidSurfaceSpin::inverse_inertia(const unsigned int column)
  {
    return rotation(column).inverse_inertia;
  }



  void
  MidSurfaceSpin::add_couple(const unsigned int column,
                             const Tensor<1, 3> &couple)
  {
    const auto &around       = surface.quadrilaterals_around(column);
    const Tensor<1, 3> share = couple * (1. / around.size());
    for (const unsigned int q : around)
      {
        Quad &quad = quads[q];
        if (!quad.has_couple)
          with_couple.push_back(q);
        quad.has_couple = true;
        quad.couple += share;
      }
  }



  const std::vector<MidSurfaceSpin::Impulse> &
  MidSurfaceSpin::fetch_impulses()
  {
    parts.clear();
    for (const unsigned int q : with_couple)
      {
        const Quad &quad           = current_quad(q);
        const Tensor<1, 3> &couple = quad.couple;
        const double about_normal  = 0.5 * (couple * quad.n);
        const Tensor<1, 3> along_a =
          about_normal * quad.b - (couple * quad.b) * quad.n;
        const Tensor<1, 3> along_b =
          (couple * quad.a) * quad.n - about_normal * quad.a;
        parts.push_back({corners[q][2], along_a});
        parts.push_back({corners[q][0], -along_a});
        parts.push_back({corners[q][3], along_b});
        parts.push_back({corners[q][1], -along_b});
        quads[q].couple     = Tensor<1, 3>();
        quads[q].has_couple = false;
      }
    with_couple.clear();
    return parts;
  }
} // namespace coapt
