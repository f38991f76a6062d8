// The refinement around a solid: finest where parts of it face each other.

#include <coapt/coupled/solid_band.h>
#include <coapt/geometry/facing_parts.h>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const double spacing = 0.25e-3;

  /** A sheet of 10 x 10 mm at the height @p z, tilted by @p slope. */
  void
  add_sheet(const double z,
            const double slope,
            std::vector<Point<3>> &x,
            std::vector<Tensor<1, 3>> &normals)
  {
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j <= 40; ++j)
        {
          x.emplace_back(i * spacing, j * spacing, z + slope * i * spacing);
          normals.push_back(Tensor<1, 3>({-slope, 0., 1.}));
        }
  }

  void
  facing()
  {
    std::vector<Point<3>> x;
    std::vector<Tensor<1, 3>> normals;
    add_sheet(0, 0.1, x, normals);
    const auto count = [&](const double distance) {
      const std::vector<bool> faces = facing_parts(x, normals, distance);
      return std::count(faces.begin(), faces.end(), true);
    };
    check("a sheet does not face itself", count(4e-3) == 0, count(4e-3));

    // 2 mm apart at x = 0, 4 mm at x = 10 mm
    add_sheet(2e-3, 0.3, x, normals);
    check("too far", count(1.9e-3) == 0, count(1.9e-3));
    check("near enough", count(4.5e-3) == 2 * 41 * 41, count(4.5e-3));
    const auto part = facing_parts(x, normals, 3e-3);
    for (unsigned int i = 0; i < x.size(); ++i)
      if (part[i] != (x[i][0] < 4.9e-3) && std::abs(x[i][0] - 4.9e-3) > 0.6e-3)
        check("only where the other sheet is near", false, x[i][0]);
    check("facing parts", part[0] && !part[41 * 41 - 1]);
  }

  MeshParameters
  mesh_parameters()
  {
    MeshParameters parameters;
    parameters.coarse_cell          = 4e-3;
    parameters.lumen_level          = 0;
    parameters.leaflet_level        = 3;
    parameters.levels_coarser_apart = 1;
    parameters.band                 = 2;
    return parameters;
  }

  void
  levels()
  {
    std::vector<Point<3>> x;
    std::vector<Tensor<1, 3>> normals;
    add_sheet(0, 0, x, normals);
    std::vector<bool> faces;
    for (const Point<3> &point : x)
      faces.push_back(point[0] < 5e-3);

    SolidBand<3> band(mesh_parameters(), {});
    const double h   = 0.5e-3;
    const auto level = [&](const double x, const double z) {
      return band.wanted_level(Point<3>(x, 5e-3, z), h);
    };
    check("nothing placed", level(2e-3, 0) == 0);
    band.place(x);
    check("all are finest", level(2e-3, 0.9 * h) == 3 && level(8e-3, 0) == 3);
    check("beyond the band", level(2e-3, 2.1 * h) == 0);
    band.place(x, {}, faces);
    check("facing part", level(2e-3, 1.9 * h) == 3);
    check("part that is apart", level(8e-3, 0) == 2);
    check("its band has its own cells",
          level(8e-3, 3.9 * h) == 2 && level(8e-3, 4.1 * h) == 0);
    check("near",
          band.is_near(Point<3>(8e-3, 5e-3, 5.9 * h)) &&
            !band.is_near(Point<3>(8e-3, 5e-3, 6.1 * h)));

    // 2 - 0.5 - sqrt(3)/2 cells
    const auto moved_up = [&](const double from, const double way) {
      std::vector<Point<3>> moved = x;
      for (Point<3> &point : moved)
        if (point[0] >= from)
          point[2] += way;
      return moved;
    };
    check("fine cells are used up", band.is_used_up(moved_up(0, 0.64 * h)));
    check("coarse ones are not", !band.is_used_up(moved_up(5e-3, 1.2 * h)));
    check("coarse cells are used up", band.is_used_up(moved_up(5e-3, 1.3 * h)));
  }

  void
  wall()
  {
    MeshParameters parameters = mesh_parameters();
    parameters.lumen_level    = 1;
    parameters.wall_level     = 2;
    const SolidBand<3> band(parameters, [](const Point<3> &x) { return x[2]; });
    const double size = 1e-3, half_diagonal = 0.5 * std::sqrt(3.) * size;
    const auto level = [&](const double z) {
      return band.wanted_level(Point<3>(0, 0, z), size);
    };
    check("in the lumen", level(-1.01 * half_diagonal) == 1);
    check("cut by the wall",
          level(-0.99 * half_diagonal) == 2 &&
            level(0.99 * half_diagonal) == 2);
    check("outside", level(1.01 * half_diagonal) == 0);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  facing();
  levels();
  wall();
}
