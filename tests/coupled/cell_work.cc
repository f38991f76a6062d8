// Division of the octree among ranks: points count where they are, cells
// outside of the lumen much less, and all ranks get the same work although
// all points lie in one corner, also after refinement and coarsening.

#include <coapt/coupled/cell_work.h>
#include <coapt/fluid/fluid_grid.h>

#include <deal.II/grid/tria.h>

#include "../tests.h"

using namespace coapt;
using Point2 = dealii::Point<2>;

namespace
{
  /** Largest over smallest work of a rank. */
  double
  imbalance(const FluidGrid<2> &grid, const CellWork<2> &work)
  {
    double sum = 0;
    for (const auto &cell : grid.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        sum += work(cell->center(), grid.cell_size(cell->level()));
    return dealii::Utilities::MPI::max(sum, MPI_COMM_WORLD) /
      dealii::Utilities::MPI::min(sum, MPI_COMM_WORLD);
  }

  /** Points in a square of 4 mm, 4 in each cell of 0.25 mm. */
  std::vector<Point2>
  cluster(const Point2 &corner)
  {
    std::vector<Point2> points;
    for (unsigned int i = 0; i < 32; ++i)
      for (unsigned int j = 0; j < 32; ++j)
        points.emplace_back(corner[0] + (i + 0.5) * 4e-3 / 32,
                            corner[1] + (j + 0.5) * 4e-3 / 32);
    return points;
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);

  // a lumen of x < 12 mm
  CellWork<2> work(Point2(0, 0), 0.25e-3, [](const Point2 &x) {
    return x[0] - 12e-3;
  });
  FluidGrid<2> grid(MPI_COMM_WORLD,
                    Point2(0, 0),
                    Point2(16e-3, 16e-3),
                    {{8, 8}});
  grid.divide_by([&work](const Point2 &center, const double size) {
    return work(center, size);
  });

  Point2 corner;
  const auto wanted = [&corner](const Point2 &x, double) {
    return x[0] > corner[0] && x[0] < corner[0] + 4e-3 && x[1] > corner[1] &&
        x[1] < corner[1] + 4e-3
      ? 3u
      : 1u;
  };
  work.place(cluster(corner), cluster(corner));
  grid.refine_to(wanted);
  const double fluid = work(Point2(8.5e-3, 8.5e-3), 1e-3);
  check("a cell outside of the lumen costs little",
        work(Point2(15.5e-3, 0.5e-3), 1e-3) < 0.4 * fluid);
  check_relative("4 points in a cell",
                 work(Point2(0.125e-3, 0.125e-3), 0.25e-3) - fluid,
                 4 * 31,
                 1e-12);
  // in larger cells those that carry coupling count: one in each 0.5 mm
  std::vector<Point2> sparse;
  for (unsigned int i = 0; i < 64; ++i)
    sparse.emplace_back((i % 8 + 0.5) * 0.5e-3, (i / 8 + 0.5) * 0.5e-3);
  work.place(cluster(corner), sparse);
  for (const double size : {0.5e-3, 1e-3, 2e-3})
    check_relative("points in a larger cell",
                   work(Point2(0.5 * size, 0.5 * size), size) - fluid,
                   std::pow(size / 0.5e-3, 2) * 31,
                   1e-12);
  work.place(cluster(corner), cluster(corner));
  check("ranks get the same work",
        imbalance(grid, work) < 1.1,
        imbalance(grid, work));

  corner = Point2(8e-3, 10e-3);
  work.place(cluster(corner), cluster(corner));
  grid.refine_to(wanted);
  check("and also when the points have moved",
        imbalance(grid, work) < 1.1,
        imbalance(grid, work));
}
