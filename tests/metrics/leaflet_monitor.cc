// What a monitor says of an upright elliptic tube that is stretched, squeezed
// and dented in ways with known strains, stresses and volumes.

#include "../structure/upright_valve.h"
#include "tests.h"

using namespace coapt;
using dealii::Point;

namespace
{
  void
  stretched()
  {
    const double stretch = 1.2, mu = 50e3, lambda = 200e3;
    ModelParameters parameters          = upright_valve();
    parameters.solid.neo_hookean.mu     = mu;
    parameters.solid.neo_hookean.lambda = lambda;
    ObservedValve tube(parameters);
    const ValveSample sample =
      tube.sample(0, tube.state([&](const Point<3> &x) {
        return Point<3>(x[0], x[1], stretch * x[2]);
      }));

    // Cauchy stress (mu (b - 1) + lambda ln J)/J with b = diag(1, 1, stretch^2)
    const double along  = mu * (stretch * stretch - 1) / stretch,
                 across = lambda * std::log(stretch) / stretch;
    check_relative("mean of the largest strain",
                   sample.mean_strain,
                   std::log(stretch),
                   1e-6);
    check_relative("mean von Mises stress", sample.mean_stress, along, 1e-6);
    check_relative("mean of the largest principal stress",
                   sample.mean_principal,
                   along + across,
                   1e-6);
    check_relative("smallest stretch", sample.smallest_stretch, 1, 1e-6);
    check("nothing is distorted", sample.distorted_cells == 0);
    check_relative("largest displacement, of the free edge",
                   sample.displacement,
                   (stretch - 1) * upright_height,
                   1e-9);

    // The leaflets stand within the wall, by less than the lumen's inset.
    const double inset = parameters.lumen.inset;
    check_relative("orifice of the open tube",
                   sample.orifice.area,
                   M_PI * (upright_a - inset) * (upright_b - inset),
                   2e-3);
    check("largest disc in it",
          std::abs(sample.orifice.disc - 2 * (upright_b - inset)) < 0.2e-3,
          sample.orifice.disc);
  }

  /** To half its width, within a millisecond. */
  void
  squeezed()
  {
    ModelParameters parameters            = upright_valve();
    parameters.solid.distortion_threshold = 0.6;
    ObservedValve tube(parameters);
    const double duration = 1e-3;
    const auto narrower   = [&](const double t) {
      return [=](const Point<3> &x) {
        return Point<3>(x[0], (1 - t / duration / 2) * x[1], x[2]);
      };
    };
    const auto inwards = [&](const Point<3> &x) {
      return Point<3>(0, -x[1] / 2 / duration, 0);
    };
    for (const double part : {0., 0.3})
      tube.sample(part * duration,
                  tube.state(narrower(part * duration), inwards));
    const ValveSample sample =
      tube.sample(duration, tube.state(narrower(duration), inwards));

    const double polygon = 0.5 * upright_around *
      std::sin(2 * M_PI / upright_around) * upright_a * upright_b;
    const double volume = polygon * (upright_height + upright_root);
    check_relative("swept volume, half of that of the tube",
                   sample.swept_volume,
                   volume / 2,
                   1e-9);
    check_relative("swept flow",
                   sample.swept_flow,
                   volume / 2 / duration,
                   1e-9);
    check_relative("smallest stretch of a squeezed tube",
                   sample.smallest_stretch,
                   0.5,
                   1e-6);
    check("all cells are distorted",
          sample.distorted_cells == tube.valve.leaflet.mesh.cells.size(),
          sample.distorted_cells);
    check("nothing is longer",
          std::abs(sample.mean_strain) < 1e-6,
          sample.mean_strain);
    const double outside = upright_b + parameters.valve.thickness / 2;
    check_relative("largest displacement, of the outer face",
                   sample.displacement,
                   outside / 2,
                   1e-9);
    check_relative("largest displacement of what is held, in the middle",
                   sample.held_displacement.at("annulus"),
                   upright_b / 2,
                   1e-9);
    check_relative("largest velocity",
                   sample.largest_velocity,
                   outside / 2 / duration,
                   1e-9);
  }

  /** One column of the free edge is pushed up by nine tenths of an element. */
  void
  dented()
  {
    ModelParameters parameters            = upright_valve();
    parameters.solid.distortion_threshold = 0.4;
    ObservedValve tube(parameters);
    const Point<3> dent(-upright_a, 0, -upright_height);
    const double element = upright_height / upright_rows;
    const ValveSample sample =
      tube.sample(0, tube.state([&](const Point<3> &x) {
        return x.distance(dent) < parameters.valve.thickness
          ? x + Point<3>(0, 0, 0.9 * element)
          : x;
      }));
    check("smallest stretch in the dent",
          sample.smallest_stretch > 0.01 && sample.smallest_stretch < 0.2,
          sample.smallest_stretch);
    // at most five cells in each of two layers of two bricks
    check("number of distorted cells",
          sample.distorted_cells >= 4 && sample.distorted_cells <= 20,
          sample.distorted_cells);
    check("place of the dent",
          sample.crushed_place.distance(dent) < element,
          sample.crushed_place.distance(dent));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  stretched();
  squeezed();
  dented();
}
