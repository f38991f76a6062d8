// Two strips that stand beside each other are bent together by a pressure from
// outside, until their upper parts lie flat on each other.

#include "blocks.h"
#include "tests.h"

using dealii::Point;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double length = 1, thickness = 0.06, half_gap = 0.01;
  Blocks<2> blocks;
  unsigned int second = 0;
  for (const int side : {-1, 1})
    second = blocks.add({{8, side < 0 ? 100u : 91u}}, [=](const Point<2> &p) {
      const double x = side < 0 ? p[0] - 1 : p[0];
      return Point<2>(thickness * x + half_gap * side, length * p[1]);
    });
  const auto &points = blocks.mesh.points;
  std::vector<bool> held(points.size());
  for (unsigned int n = 0; n < points.size(); ++n)
    held[n] = points[n][1] < 1e-9;

  coapt::ContactParameters parameters;
  parameters.clearance        = 0;
  parameters.friction         = 0.2;
  parameters.max_stiffness    = 1e15;
  parameters.stiffness_factor = 0.5;
  parameters.search_margin    = 0.02;
  Motion<2> motion(blocks.mesh,
                   held,
                   coapt::outer_facets(blocks.mesh),
                   parameters,
                   0.5 * thickness,
                   0,
                   true);

  // A clamped beam that is pressed on a plane at the distance d touches it from
  // q c^4 = 72 E I d on, and carries 2/3 q c at the clamp.
  const double contact_begins = 0.5 * length;
  const double bending        = motion.modulus * std::pow(thickness, 3) / 12;
  const double q = 72 * bending * half_gap / std::pow(contact_begins, 4);
  Point<2> towards(1, 0);
  motion.load(q, towards, [=](const Point<2> &p) {
    return std::abs(p[0] + half_gap + thickness) < 1e-9;
  });
  motion.load(q, -towards, [=](const Point<2> &p) {
    return std::abs(p[0] - half_gap - thickness) < 1e-9;
  });
  motion.relax(5000);
  check_relative("force of contact",
                 motion.result.normal_force,
                 q * (length - 2. / 3 * contact_begins),
                 0.01);
  double lowest = length, least = 1e300, largest = 0;
  for (unsigned int n = 0; n < second; ++n)
    {
      const double height = points[n][1], p = motion.contact.pressure()[n];
      if (p > 0)
        lowest = std::min(lowest, height);
      if (p > 0 && height > 0.7 * length && height < 0.97 * length)
        {
          least   = std::min(least, p);
          largest = std::max(largest, p);
        }
    }
  check("where contact begins",
        std::abs(lowest - contact_begins) < 0.05 * length,
        lowest);
  check("pressure of contact is that from outside",
        least > 0.98 * q && largest < 1.02 * q,
        least / q);

  std::fill(motion.external.begin(), motion.external.end(), 0.);
  motion.relax(5000);
  double displacement = 0;
  for (unsigned int n = 0; n < points.size(); ++n)
    displacement =
      std::max(displacement, std::abs(motion.X[2 * n] - points[n][0]));
  check("strips part when it ends", motion.result.pairs == 0);
  check("and are not thrown apart", displacement < half_gap, displacement);
}
