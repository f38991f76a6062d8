// Normals of triangulated surfaces at their points.

#include <coapt/geometry/vertex_normals.h>

#include "tests.h"

#include <cmath>

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // A cylinder around z, cut into triangles that all lean to one side.
  constexpr unsigned int n_around = 24, n_rows = 6;
  std::vector<Point<3>> points;
  std::vector<std::array<unsigned int, 3>> triangles;
  const auto number = [&](const unsigned int i, const unsigned int j) {
    return (i % n_around) * n_rows + j;
  };
  for (unsigned int i = 0; i < n_around; ++i)
    for (unsigned int j = 0; j < n_rows; ++j)
      {
        const double angle = 2 * M_PI * i / n_around;
        points.emplace_back(std::cos(angle), std::sin(angle), 0.2 * j);
        if (j + 1 == n_rows)
          continue;
        triangles.push_back(
          {{number(i, j), number(i + 1, j), number(i + 1, j + 1)}});
        triangles.push_back(
          {{number(i, j), number(i + 1, j + 1), number(i, j + 1)}});
      }
  // An apex over a triangle of its own, and a point on no triangle.
  const unsigned int first = points.size();
  for (const double angle : {0., 2 * M_PI / 3, 4 * M_PI / 3})
    points.emplace_back(5 + std::cos(angle), std::sin(angle), 0);
  points.emplace_back(5, 0, 1);
  points.emplace_back(9, 9, 9);
  for (unsigned int i = 0; i < 3; ++i)
    triangles.push_back({{first + i, first + (i + 1) % 3, first + 3}});

  const auto normals = vertex_normals(points, triangles);
  double error       = 0;
  for (unsigned int p = 0; p < first; ++p)
    if (p % n_rows > 0 && p % n_rows + 1 < n_rows)
      error = std::max(
        error,
        (normals[p] - Tensor<1, 3>({points[p][0], points[p][1], 0.})).norm());
  check("radial between the rims of a cylinder", error < 1e-12, error);
  double length = 0;
  for (unsigned int p = 0; p + 1 < points.size(); ++p)
    length = std::max(length, std::abs(normals[p].norm() - 1));
  check("of unit length, on rims too", length < 1e-12, length);
  const double apex = (normals[first + 3] - Tensor<1, 3>({0., 0., 1.})).norm();
  check("upright on an apex", apex < 1e-12, apex);
  check("zero at a point on no triangle", normals.back().norm() == 0);
}
