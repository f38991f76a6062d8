// The crest of a fold counts as shut if its sides face each other closely.

#include <coapt/metrics/fold_crest.h>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double thickness = 1e-3, limit = 0.9e-3, no_gap = 1e-2;

  /** Columns along a hairpin: a side, a half circle, and the other side, which
   * face each other at twice the radius. */
  struct Hairpin
  {
    std::vector<double> gap;
    std::vector<Tensor<1, 3>> normals;
    std::vector<Point<3>> points;

    explicit Hairpin(const double radius)
    {
      for (const int side : {-1, 1})
        for (unsigned int i = 0; i < 5; ++i)
          {
            points.emplace_back(0.5e-3 * (i + 0.5), side * radius, 0);
            normals.push_back(Tensor<1, 3>({0., -1. * side, 0.}));
            gap.push_back(2 * radius - thickness + 1e-5 * side);
          }
      for (const double angle : {0.6, 1.2, 1.8, 2.4})
        {
          points.emplace_back(-radius * std::sin(angle),
                              radius * std::cos(angle),
                              0);
          normals.push_back(Tensor<1, 3>());
          gap.push_back(no_gap);
        }
    }

    std::vector<double>
    with_crest() const
    {
      return gaps_with_fold_crests(gap, normals, points, thickness, limit);
    }
  };
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Hairpin tight(0.75e-3);
  const auto shut = tight.with_crest();
  double error    = 0;
  for (unsigned int c = 0; c < shut.size(); ++c)
    error =
      std::max(error, std::abs(shut[c] - (c < 10 ? tight.gap[c] : 0.51e-3)));
  check("a shut fold has the gap of its sides", error < 1e-12, error);

  const Hairpin wide(1.2e-3);
  check("an open fold stays as it is", wide.with_crest() == wide.gap);

  // A pipe at the end of a shut fold lets blood through.
  Hairpin pipe = tight;
  for (unsigned int c = 10; c < pipe.points.size(); ++c)
    pipe.points[c] *= 2.5;
  check("a wide crest stays open", pipe.with_crest()[11] == no_gap);

  // A hole in one of two sheets that lie on each other.
  Hairpin hole = tight;
  hole.gap[2]  = no_gap;
  for (unsigned int c = 5; c < 10; ++c)
    hole.points[c][1] += 2e-3;
  check("a hole in a sheet stays open", hole.with_crest()[2] == no_gap);
}
