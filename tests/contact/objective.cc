// Friction does not notice that touching sheets turn together.

#include <coapt/contact/mid_surface_contact.h>

#include "sheets.h"
#include "tests.h"

#include <deal.II/physics/transformations.h>

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const double dt = 1e-7;

  ContactParameters
  parameters()
  {
    ContactParameters result;
    result.clearance = 0.3e-3;
    result.damping   = 0;
    return result;
  }

  /** Two sheets of different meshes, which touch, and turn as one body. */
  struct TurningSheets
  {
    TurningSheets()
    {
      sheets.add_rectangle({{12, 12}}, Point<3>(), {{12e-3, 12e-3}}, false);
      sheets.add_rectangle({{7, 5}},
                           Point<3>(2.4e-3, 3.6e-3, 5e-3),
                           {{7e-3, 5e-3}},
                           false);
      contact    = std::make_unique<MidSurfaceContact>(sheets.leaflet,
                                                    sheets.mass,
                                                    Sheets::density,
                                                    parameters(),
                                                    MPI_COMM_WORLD);
      upper_node = 3 * 13 * 13;
      for (unsigned int n = upper_node; n < sheets.mass.size(); ++n)
        sheets.X[3 * n + 2] -=
          5e-3 - Sheets::thickness - parameters().clearance + depth;
      start = sheets.X;
    }

    /** One step in which both are turned by @p rotation since the start at the
     * spin @p omega (rad/s), and the upper one slides at @p sliding (m/s, as
     * seen from the lower one). Returns the sum of the forces of contact on the
     * upper one (N), as seen from the lower one. */
    Tensor<1, 3>
    step(const Tensor<2, 3> &rotation,
         const Tensor<1, 3> &omega,
         const Tensor<1, 3> &sliding)
    {
      slid += dt * sliding;
      for (unsigned int n = 0; n < sheets.mass.size(); ++n)
        {
          Tensor<1, 3> x;
          for (unsigned int d = 0; d < 3; ++d)
            x[d] = start[3 * n + d];
          if (n >= upper_node)
            x += slid;
          x                    = rotation * x;
          const Tensor<1, 3> v = cross_product_3d(omega, x) +
            (n >= upper_node ? rotation * sliding : Tensor<1, 3>());
          for (unsigned int d = 0; d < 3; ++d)
            {
              sheets.X[3 * n + d] = x[d];
              sheets.V[3 * n + d] = v[d];
            }
        }
      const std::vector<double> before = sheets.V;
      result = contact->apply_impulse(sheets.X.data(), sheets.V.data(), dt);
      Tensor<1, 3> force;
      for (unsigned int n = upper_node; n < sheets.mass.size(); ++n)
        for (unsigned int d = 0; d < 3; ++d)
          force[d] +=
            sheets.mass[n] * (sheets.V[3 * n + d] - before[3 * n + d]) / dt;
      return transpose(rotation) * force;
    }

    /** Both turn about @p axis, a unit vector, by @p angle. Returns the last
     * force. */
    Tensor<1, 3>
    turn(const Point<3> &axis, const double angle)
    {
      const unsigned int n_steps = 1000;
      Tensor<1, 3> force;
      for (unsigned int i = 1; i <= n_steps; ++i)
        force =
          step(dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
                 axis, angle * i / n_steps),
               angle / (n_steps * dt) * axis,
               Tensor<1, 3>());
      return force;
    }

    static constexpr double depth = 5e-6;

    Sheets sheets;
    std::unique_ptr<MidSurfaceContact> contact;
    MidSurfaceContact::Result result;
    unsigned int upper_node;
    std::vector<double> start;
    Tensor<1, 3> slid;
  };

  const Point<3> normal(0, 0, 1), oblique(0.48, 0.64, 0.6), across(0.6, 0.8, 0);

  void
  no_slip()
  {
    for (const auto &axis : {normal, across, oblique})
      {
        TurningSheets sheets;
        const Tensor<1, 3> force = sheets.turn(axis, 1.);
        const double friction    = std::hypot(force[0], force[1]);
        const std::string name   = " about an axis at " +
          std::to_string(std::lround(10 * axis[2])) + "/10 of the normal";
        check("sheets touch while they turn" + name,
              sheets.result.pairs > 60 && force[2] > 0,
              sheets.result.pairs);
        check("and do not slip" + name,
              friction < 1e-9 * force[2],
              friction / force[2]);
      }
  }

  // What sticks keeps its shear, which turns with the sheets.
  void
  shear_turns()
  {
    for (const auto &axis : {normal, across, oblique})
      {
        TurningSheets sheets;
        const Tensor<2, 3> straight = dealii::unit_symmetric_tensor<3>();
        // Half of what it takes to slide.
        const double way = 0.5 * parameters().friction * TurningSheets::depth /
          parameters().stick_stiffness;
        Tensor<1, 3> before, sliding;
        sliding[0] = way / (100 * dt);
        for (unsigned int i = 0; i < 100; ++i)
          before = sheets.step(straight, Tensor<1, 3>(), sliding);
        const Tensor<1, 3> after = sheets.turn(axis, 1.);
        check("shear turns with the sheets about an axis at " +
                std::to_string(std::lround(10 * axis[2])) + "/10 of the normal",
              before[0] < -0.09 * before[2] &&
                (after - before).norm() < 2e-3 * std::abs(before[0]),
              (after - before).norm() / std::abs(before[0]));
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  no_slip();
  shear_turns();
}
