// Hertz (1882): an elastic body with a parabolic end is pressed on a rigid
// plane.

#include "blocks.h"
#include "tests.h"

#include <algorithm>

namespace
{
  constexpr double radius_of_curvature = 4, contact_radius = 0.1;
  constexpr double poisson = 0.3;

  struct Errors
  {
    double force, radius, pressure;
  };

  /** Half of a cylinder (2D) or a quarter of a sphere with @p n^dim boxes that
   * grow away from the contact; the load is that of the contact radius. */
  template <int dim>
  Errors
  press(const unsigned int n, const double grading, const unsigned int n_steps)
  {
    using Point = dealii::Point<dim>;
    Blocks<dim> blocks;
    std::array<unsigned int, dim> boxes;
    boxes.fill(n);
    blocks.add(boxes, [&](const Point &p) {
      Point q;
      double height = 0;
      for (unsigned int d = 0; d < dim; ++d)
        {
          q[d] = std::sinh(grading * p[d]) / std::sinh(grading);
          if (d + 1 < dim)
            height += q[d] * q[d] / (2 * radius_of_curvature);
        }
      q[dim - 1] += height * (1 - q[dim - 1]);
      return q;
    });
    const unsigned int first_of_plane = blocks.mesh.points.size();
    boxes.fill(1);
    blocks.add(boxes, [](Point p) {
      p *= 2;
      for (unsigned int d = 0; d < dim; ++d)
        p[d] -= d + 1 < dim ? 0.5 : 2;
      return p;
    });
    const auto &points = blocks.mesh.points;
    std::vector<bool> held(points.size(), false);
    std::fill(held.begin() + first_of_plane, held.end(), true);

    coapt::ContactParameters parameters;
    parameters.clearance        = 0;
    parameters.friction         = 0;
    parameters.max_stiffness    = 1e15;
    parameters.stiffness_factor = 0.5;
    parameters.search_margin    = 0.05;
    // Those of the contact, and the plane.
    std::vector<std::array<unsigned int, dim>> facets;
    for (const auto &facet : coapt::outer_facets(blocks.mesh))
      if (std::all_of(facet.begin(), facet.end(), [&](const unsigned int node) {
            return node >= first_of_plane ||
              (points[node][dim - 1] < 0.01 &&
               points[node].norm() < 2.5 * contact_radius);
          }))
        facets.push_back(facet);
    Motion<dim> motion(
      blocks.mesh, held, facets, parameters, 0.1, poisson, true);
    motion.constrain = [&](std::vector<double> &V) {
      for (unsigned int i = 0; i < first_of_plane; ++i)
        for (unsigned int d = 0; d + 1 < dim; ++d)
          if (points[i][d] < 1e-9)
            V[dim * i + d] = 0;
    };

    // Johnson (1985), sections 4.2 and 3.4, with a rigid partner.
    const double e = Motion<dim>::modulus / (1 - poisson * poisson);
    const double a = contact_radius, r = radius_of_curvature;
    const double force = dim == 2 ? M_PI * e * a * a / (4 * r) / 2
                                  : 4 * e * a * a * a / (3 * r) / 4;
    const double peak  = dim == 2 ? e * a / (2 * r) : 2 * e * a / (M_PI * r);
    Point down;
    down[dim - 1] = -1;
    motion.load(force, down, [](const Point &p) {
      return p[dim - 1] > 1 - 1e-9;
    });
    motion.relax(n_steps);

    // The second moment of the forces of contact is that of Hertz' ellipse:
    // a^2/4 in 2D, 2 a^2/5 for the distance from the axis in 3D. They
    // balance those of the elements. Pressures within half of the radius are
    // compared with the ellipse, too.
    double sum = 0, moment = 0, ratio = 0;
    unsigned int n_inside = 0;
    for (unsigned int i = 0; i < first_of_plane; ++i)
      {
        double square = 0;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          square += points[i][d] * points[i][d];
        if (points[i].norm() > 2 * contact_radius ||
            motion.contact.pressure()[i] == 0)
          continue;
        const double f = -motion.F[dim * i + dim - 1];
        sum += f;
        if (square < 0.25 * a * a)
          {
            ratio += motion.contact.pressure()[i] /
              (peak * std::sqrt(1 - square / (a * a)));
            ++n_inside;
          }
        moment += f * square;
      }
    const double measured     = std::sqrt(moment / sum * (dim == 2 ? 4 : 2.5));
    const double force_error  = motion.result.normal_force / force - 1;
    const double radius_error = measured / a - 1;
    const double pressure_error = ratio / n_inside - 1;
    return {force_error, radius_error, pressure_error};
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Errors cylinder, coarser{1, 1, 1};
  for (const unsigned int n : {8, 16, 32})
    {
      cylinder = press<2>(n, 4, n < 32 ? 1000 : 2000);
      check("cylinder: errors fall, " + std::to_string(n) + " elements",
            std::abs(cylinder.pressure) < 0.5 * std::abs(coarser.pressure) &&
              std::abs(cylinder.radius) < 0.6 * std::abs(coarser.radius),
            cylinder.pressure);
      coarser = cylinder;
    }
  check("cylinder: force", std::abs(cylinder.force) < 1e-3, cylinder.force);
  check("cylinder: half width",
        std::abs(cylinder.radius) < 0.005,
        cylinder.radius);
  check("cylinder: pressure",
        std::abs(cylinder.pressure) < 0.005,
        cylinder.pressure);

  // The bounds are those of each mesh.
  Errors sphere;
  coarser = {1, 0.06, 0.06};
  for (const unsigned int n : {8, 16, 24})
    {
      sphere                 = press<3>(n, 4, n < 24 ? 180 * n : 4000);
      const std::string name = ", " + std::to_string(n) + " elements";
      check("sphere: force" + name,
            std::abs(sphere.force) < 1e-3,
            sphere.force);
      check("sphere: radius, errors fall" + name,
            std::abs(sphere.radius) < 0.75 * std::abs(coarser.radius),
            sphere.radius);
      check("sphere: pressure, errors fall" + name,
            std::abs(sphere.pressure) < 0.75 * std::abs(coarser.pressure),
            sphere.pressure);
      coarser = sphere;
    }
  check("sphere: radius", std::abs(sphere.radius) < 0.006, sphere.radius);
  check("sphere: pressure", std::abs(sphere.pressure) < 0.015, sphere.pressure);
}
