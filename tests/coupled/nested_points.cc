// Coupling points of two densities on a block that lies half in fine cells and
// half in ones twice as large: in the large ones, off the fine ones, points
// stand for their groups; the volume is that of the block, momentum is
// conserved, and when the octree changes the force stays as it is; points that
// have been dense stay so.

#include "coupled_case.h"

using namespace coapt;
using Point2 = dealii::Point<2>;

namespace
{
  const double fine = 0.5e-3;

  /** The points of simplex_lattice(), and for those of each simplex one at its
   * centroid. */
  NestedLattice<2>
  points_of(const SimplexMesh<2> &mesh)
  {
    NestedLattice<2> lattice{simplex_lattice(mesh, 0.6 * fine), {}};
    const unsigned int n_dense = lattice.points.size();
    for (const SamplePoint<2> &point : lattice.points)
      lattice.stand_in.push_back(n_dense + point.cell);
    lattice.points.resize(n_dense + mesh.cells.size());
    for (unsigned int id = 0; id < n_dense; ++id)
      {
        SamplePoint<2> &one = lattice.points[lattice.stand_in[id]];
        one.cell            = lattice.points[id].cell;
        one.barycentric.fill(1. / 3);
        one.volume += lattice.points[id].volume;
      }
    return lattice;
  }

  struct Strip
  {
    Strip()
      : block(make_block<2>({{24, 4}},
                            [](const Point2 &r) {
                              return Point2(2.1e-3 + 12e-3 * r[0],
                                            7.3e-3 + 2e-3 * r[1] + 1e-3 * r[0]);
                            }))
      , lattice(points_of(block.mesh))
      , X(as_array(block.mesh.points))
      , grid(MPI_COMM_WORLD, Point2(0, 0), Point2(16e-3, 16e-3), {{16, 16}})
      , fluid(FluidParameters(), walls(), {})
      , points(block.mesh, lattice, fine, MPI_COMM_WORLD)
    {
      refine_below(8e-3);
    }

    static FluidBoundaries<2>
    walls()
    {
      FluidBoundaries<2> boundaries;
      boundaries.type.fill(FluidBoundary::no_slip);
      return boundaries;
    }

    /** Fine cells where x is below @p end. */
    void
    refine_below(const double end)
    {
      grid.refine_to(
        [=](const Point2 &x, double) { return x[0] < end ? 1u : 0u; });
      fluid.reinit(grid);
      points.distribute(fluid, X.data(), multiplier);
    }

    /** Force (2) and torque of the multipliers on the block, and the sum of
     * both components of the force on the fluid. */
    std::vector<double>
    forces()
    {
      const std::vector<double> V(X.size(), 0.), u(2 * fluid.n_local_nodes());
      std::vector<double> f(u.size(), 0.), F(X.size(), 0.),
        rate(multiplier.size());
      points.add_forces({1e13, 0},
                        u.data(),
                        V.data(),
                        multiplier.data(),
                        f.data(),
                        F.data(),
                        rate.data());
      std::vector<double> sums(4, 0.);
      for (unsigned int i = 0; i < F.size(); i += 2)
        {
          sums[0] += F[i];
          sums[1] += F[i + 1];
          sums[2] += X[i] * F[i + 1] - X[i + 1] * F[i];
        }
      for (unsigned int i = 0; i < f.size(); ++i)
        sums[3] += f[i];
      dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
      return sums;
    }

    /** Energy of the multipliers (J). */
    double
    energy() const
    {
      const std::vector<double> u(2 * fluid.n_local_nodes());
      return points
        .energy_and_power({1e13, 0},
                          u.data(),
                          std::vector<double>(X.size()).data(),
                          multiplier.data())
        .energy;
    }

    /** Positions of the points that carry coupling, of one density. */
    std::vector<Point2>
    active(const bool dense) const
    {
      const std::vector<Point2> all = points.positions(X.data());
      std::vector<Point2> result;
      for (unsigned int id = 0; id < all.size(); ++id)
        if ((id < points.n_points()) == dense && points.is_active(id))
          result.push_back(all[id]);
      return result;
    }

    double
    active_volume() const
    {
      double volume = 0;
      for (unsigned int id = 0; id < lattice.points.size(); ++id)
        if (points.is_active(id))
          volume += lattice.points[id].volume;
      return volume;
    }

    Block<2> block;
    NestedLattice<2> lattice;
    std::vector<double> X, multiplier;
    FluidGrid<2> grid;
    FluidOperator<2> fluid;
    CouplingPoints<2> points;
  };
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  Strip strip;

  const auto along = [](const Point2 &a, const Point2 &b) {
    return a[0] < b[0];
  };
  const auto dense = strip.active(true), sparse = strip.active(false);
  check("points are dense in fine cells and up to a large one beside them",
        std::abs((*std::max_element(dense.begin(), dense.end(), along))[0] -
                 9e-3) < fine);
  check("points that carry coupling",
        strip.points.n_active() == dense.size() + sparse.size());
  check("and sparse beyond",
        std::abs((*std::min_element(sparse.begin(), sparse.end(), along))[0] -
                 9e-3) < fine);
  check_relative("volume", strip.active_volume(), 24e-6, 1e-12);
  check("points that carry coupling are all on some rank",
        dealii::Utilities::MPI::sum(strip.points.n_owned(), MPI_COMM_WORLD) ==
          dense.size() + sparse.size());

  // a smooth force that the multipliers of all ranks know by their number
  const auto positions = strip.points.positions(strip.X.data());
  for (unsigned int q = 0; q < strip.points.n_owned(); ++q)
    {
      const Point2 &x             = positions[strip.points.id(q)];
      strip.multiplier[2 * q]     = 1 + 200 * x[0];
      strip.multiplier[2 * q + 1] = 1 - 100 * x[1];
    }
  const std::vector<double> before = strip.forces();
  const double energy              = strip.energy();
  check("what the block gets the fluid loses",
        std::abs(before[0] + before[1] + before[3]) <
          1e-12 * std::abs(before[0]));

  for (const double end : {10e-3, 16e-3, 4e-3})
    {
      strip.refine_below(end);
      const std::vector<double> after = strip.forces();
      const std::string name = " of the force when cells are fine up to " +
        std::to_string(std::lround(1e3 * end)) + " mm";
      check_relative("x" + name, after[0], before[0], 1e-12);
      check_relative("y" + name, after[1], before[1], 1e-12);
      check_relative("torque" + name, after[2], before[2], 1e-12);
      check_relative("energy" + name, strip.energy(), energy, 1e-12);
      check_relative("volume then", strip.active_volume(), 24e-6, 1e-12);
    }
  check("groups that have been dense stay so", strip.active(false).empty());
}
