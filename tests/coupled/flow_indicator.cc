// Refinement by the flow: a jet is refined, a uniform flow and a masked place
// are not; once refined, the mesh stays; behind a jet that has gone it is
// coarse again; the same on any number of ranks; the number of cells is
// bounded.

#include <coapt/coupled/flow_indicator.h>

#include "../fluid/fluid_case.h"

using namespace coapt;

namespace
{
  using Point2 = dealii::Point<2>;

  /** A jet along x at the height @p y, of 1 m/s and 2 mm. */
  double
  jet(const Point2 &x, const double y)
  {
    const double s = (x[1] - y) / 1e-3;
    return std::exp(-s * s);
  }

  struct Case
  {
    explicit Case(const unsigned int max_cells = 1000000)
      : indicator(parameters(max_cells))
      , fluid(FluidParameters(),
              boundaries(),
              Point2(0, 0),
              Point2(32e-3, 32e-3),
              {{8, 8}})
    {
      fluid.set_up([](const Point2 &, double) { return 1u; });
    }

    static MeshParameters
    parameters(const unsigned int max_cells)
    {
      MeshParameters mesh;
      mesh.coarse_cell   = 4e-3;
      mesh.lumen_level   = 1;
      mesh.leaflet_level = 4;
      mesh.flow_level    = 4;
      mesh.flow_jump     = 0.2;
      mesh.max_cells     = max_cells;
      return mesh;
    }

    static FluidBoundaries<2>
    boundaries()
    {
      FluidBoundaries<2> boundaries;
      boundaries.type.fill(FluidBoundary::slip);
      return boundaries;
    }

    /** Adapts @p n times to a flow along x; returns whether the mesh changed
     * the last time. */
    bool
    adapt(
      const std::function<double(const Point2 &)> &flow,
      const unsigned int n,
      const FlowIndicator<2>::Mask &masked = [](const Point2 &) {
        return false;
      })
    {
      bool changed = false;
      for (unsigned int i = 0; i < n; ++i)
        {
          fluid.set_velocity([&](const Point2 &x,
                                 int d) { return d == 0 ? flow(x) : 0.; },
                             false);
          std::vector<double> local(2 * fluid.op.n_local_nodes());
          fluid.op.gather(fluid.u.data(), local.data());
          raised = indicator.update(fluid.grid, fluid.op, local.data(), masked);
          changed = fluid.grid.adapt(
            [this](const Point2 &center, const double size) {
              return indicator.wanted_level(center, size);
            },
            fluid.op,
            fluid.u,
            fluid.p);
        }
      return changed;
    }

    /** Finest and coarsest size (mm) of a cell at the heights from @p y to
     * y + 2 mm, of all ranks. */
    std::pair<double, double>
    sizes(const double y) const
    {
      double finest = 1, coarsest = 0;
      for (unsigned int c = 0; c < fluid.op.n_owned_cells(); ++c)
        {
          const auto &cell = fluid.op.cell(c);
          if (cell.lower[1] < y || cell.lower[1] >= y + 2e-3)
            continue;
          finest   = std::min(finest, cell.size);
          coarsest = std::max(coarsest, cell.size);
        }
      return {1e3 * dealii::Utilities::MPI::min(finest, MPI_COMM_WORLD),
              1e3 * dealii::Utilities::MPI::max(coarsest, MPI_COMM_WORLD)};
    }

    unsigned int
    n_cells() const
    {
      return fluid.grid.triangulation().n_global_active_cells();
    }

    FlowIndicator<2> indicator;
    FluidCase<2> fluid;
    bool raised = false;
  };
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);

  Case uniform;
  check("uniform flow is left alone",
        !uniform.adapt([](const Point2 &) { return 3.; }, 1) &&
          uniform.n_cells() == 256,
        uniform.n_cells());

  Case one;
  const auto low_jet  = [](const Point2 &x) { return jet(x, 9e-3); };
  const auto high_jet = [](const Point2 &x) { return jet(x, 25e-3); };
  check("a refined mesh stays", !one.adapt(low_jet, 6));
  // The steepest gradient of the jet, 860/s, over 0.25 mm is 0.21 m/s.
  check("the jet is refined to the level of the flow",
        one.sizes(8e-3).first == 0.25 && one.sizes(8e-3).second <= 0.5,
        one.sizes(8e-3).second);
  check("the rest is coarse",
        one.sizes(24e-3).first == 2 && one.sizes(30e-3).first == 2,
        one.sizes(24e-3).first);
  check("the same cells on any number of ranks",
        one.n_cells() == 3568,
        one.n_cells());
  one.adapt(high_jet, 6);
  check("coarse again behind the jet", one.sizes(8e-3).first == 2);
  check("the jet's new place is refined", one.sizes(24e-3).first == 0.25);

  Case masked;
  masked.adapt(low_jet, 3, [](const Point2 &x) { return x[1] < 16e-3; });
  check("a masked jet is left alone", masked.n_cells() == 256);

  Case bounded(500);
  bounded.adapt(low_jet, 20);
  check("the number of cells is bounded",
        bounded.n_cells() <= 500 && bounded.indicator.tolerated_jump() > 0.2,
        bounded.n_cells());
}
