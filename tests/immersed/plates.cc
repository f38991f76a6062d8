// Plates that shut a channel, straight across and at 45 degrees: rows of the
// verification files plate_tilted and plate_oblique, which must be tight and
// bend as in vacuum, with elements smaller than the cells, too. With the
// argument "dry" only prints how all of their rows bend there.
#include <coapt/geometry/body_shapes.h>
#include <coapt/geometry/material_point.h>
#include <coapt/time/stability_limit.h>

#include <cstring>
#include <iostream>

#include "coupled/block.h"
#include "flow/run_study.h"
#include "tests.h"

using namespace coapt;

namespace
{
  /** A plate of plate_tilted, or of plate_oblique. */
  struct Plate
  {
    bool oblique;
    double element_size; // m

    StripShape<2>
    shape() const
    {
      StripShape<2> shape;
      shape.begin = dealii::Point<2>(oblique ? 20.13e-3 : 18.76e-3, 0);
      shape.end   = dealii::Point<2>(oblique ? 40.13e-3 : 21.5e-3, 20e-3);
      shape.thickness[0] = oblique ? 1.4142e-3 : 1e-3; // along x
      shape.bow          = 1e-3;
      return shape;
    }
  };

  /** The plate as an image of the unit square, the first coordinate through the
   * thickness. */
  Block<2>
  block(const Plate &plate)
  {
    const StripShape<2> s = plate.shape();
    Block<2> block;
    block.mesh = strip_body(s, plate.element_size).mesh;
    for (const auto &x : block.mesh.points)
      {
        const double along  = x[1] / s.end[1];
        const double middle = s.begin[0] + along * (s.end[0] - s.begin[0]) +
          4 * s.bow * along * (1 - along);
        block.unit.emplace_back((x[0] - middle) / s.thickness[0] + 0.5, along);
      }
    return block;
  }

  /** Deflection of the plate's middle along x (m) under 16 kPa in vacuum. */
  double
  dry_deflection(const Plate &plate)
  {
    SolidParameters parameters;
    parameters.material           = "neo-Hookean";
    parameters.viscosity          = 0;
    parameters.neo_hookean.mu     = 500e3;
    parameters.neo_hookean.lambda = 2.5e6;
    const Block<2> body           = block(plate);
    const SolidOperator<2> solid(body.mesh, parameters, {}, {}, MPI_COMM_SELF);
    const auto held = body.nodes_where(
      [](const dealii::Point<2> &r) { return r[1] < 1e-9 || r[1] > 1 - 1e-9; });
    const auto bound = solid.step_bound(as_array(body.mesh.points).data());
    const double dt  = 0.5 * kinnmark_gray_limit(bound.xi) / bound.omega;
    const auto X     = dry_equilibrium(body, solid, held, 16e3, 800, dt, 50e-3);
    const StripShape<2> s = plate.shape();
    const dealii::Point<2> middle(0.5 * (s.begin[0] + s.end[0]) + s.bow, 10e-3);
    return displacement(body.mesh,
                        find_material_point(body.mesh, middle, "middle"),
                        X)[0];
  }

  void
  print_dry()
  {
    for (const bool oblique : {false, true})
      for (const double size : {0.125e-3, 0.25e-3, 0.5e-3, 1e-3, 2e-3})
        std::cout << (oblique ? "oblique " : "tilted ") << size << ' '
                  << dry_deflection({oblique, size}) << std::endl;
  }

  /** Runs a row of the file: cells of 1 mm/2^@p level, elements of @p ratio
   * cells. The deflection may differ by @p tolerance. */
  void
  check_plate(const bool oblique,
              const unsigned int level,
              const double ratio,
              const double tolerance)
  {
    const std::string name = oblique ? "plate_oblique" : "plate_tilted";
    const auto row =
      run_study<2>(name,
                   FlowContents::bodies,
                   {{"Flow", "Refinements", std::to_string(level)},
                    {"Body", "Element size", std::to_string(ratio)},
                    {"Flow", "Figures from", "45e-3"},
                    {"Study", "Parameter", ""},
                    {"Study", "Values", ""}});
    const FlowResult &result = row.results()[0];
    const double leak        = figure(result, "leak_m3_per_s_mean") / 20e-3;
    check(name + ", leak below 0.3 mm/s", std::abs(leak) < 0.3e-3, leak);
    const double dry = dry_deflection({oblique, ratio * 1e-3 / (1 << level)});
    const double wet = figure(result, "displacement_1_x_m_mean");
    check(name + ", bends as in vacuum",
          std::abs(wet / dry - 1) < tolerance,
          wet / dry - 1);
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  if (argc > 1 && std::strcmp(argv[1], "dry") == 0)
    print_dry();
  else
    {
      check_plate(false, 0, 2, 0.005);
      check_plate(false, 1, 0.5, 0.003);
      check_plate(false, 1, 2, 0.003);
      check_plate(true, 1, 2, 0.005);
    }
}
