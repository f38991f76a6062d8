// Shares, means and quantiles by weight: of four values, of a pressure that
// falls linearly over tributary areas, and of a stress by regions.

#include <coapt/metrics/distribution.h>
#include <coapt/metrics/region_volumes.h>

#include "cylinder_leaflet.h"
#include "tests.h"

using namespace coapt;

namespace
{
  void
  four_values()
  {
    const std::vector<double> values = {1, 2, 3, 4}, weights = {4, 3, 2, 1};
    const auto share = exceedance(values, weights, {0, 1, 2.5, 4});
    check("shares above thresholds",
          share[0] == 1 && std::abs(share[1] - 0.6) < 1e-15 &&
            std::abs(share[2] - 0.3) < 1e-15 && share[3] == 0);
    check("mean and quantile",
          std::abs(weighted_mean(values, weights) - 2) < 1e-15 &&
            weighted_quantile(values, weights, 0.4) == 1 &&
            weighted_quantile(values, weights, 0.5) == 2 &&
            weighted_quantile(values, weights, 0.95) == 4);
    const std::vector<double> nothing(4, 0.);
    check("nothing has no share, mean or quantile",
          exceedance(values, nothing, {0})[0] == 0 &&
            weighted_mean(values, nothing) == 0 &&
            weighted_quantile(values, nothing, 0.5) == 0);
  }

  /** A pressure that rises linearly from nothing at the annulus to 12 kPa at
   * the free edge: P(p > t) = 1 - t/(12 kPa), exact half-way between the rows,
   * since those at both ends stand for half a strip. */
  void
  linear_pressure()
  {
    const double peak     = 12e3;
    const Leaflet leaflet = cylinder();
    const LeafletLines lines(leaflet);
    std::vector<double> pressure, area;
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      {
        pressure.push_back(peak * lines.depth[c] / (n_rows * row_height));
        area.push_back(lines.height[c] * 2 * M_PI * radius / n_angles);
      }
    std::vector<double> thresholds;
    for (unsigned int j = 0; j < n_rows; ++j)
      thresholds.push_back((j + 0.5) / n_rows * peak);
    const auto share = exceedance(pressure, area, thresholds);
    double error     = 0;
    for (unsigned int j = 0; j < n_rows; ++j)
      error = std::max(error, std::abs(share[j] - (1 - thresholds[j] / peak)));
    check("distribution of a linear pressure", error < 1e-12, error);
    check_relative("its mean", weighted_mean(pressure, area), 6e3, 1e-12);
    check_relative("its median",
                   weighted_quantile(pressure, area, 0.5),
                   6e3,
                   1e-12);
    // rows 11 and 12 stand for the uppermost 12.5 %
    check_relative("what 5 % exceed",
                   weighted_quantile(pressure, area, 0.95),
                   11e3,
                   1e-12);
  }

  /** A strip of 60 quadrilaterals of unit length and volume: 20 are of the
   * anterior leaflet, 30 of the posterior one, and 10 of the root. Each has a
   * cell of a quarter and one of three quarters of its length. */
  void
  linear_stress()
  {
    Leaflet strip;
    strip.quad_region.assign(20, Region::anterior);
    strip.quad_region.insert(strip.quad_region.end(), 30, Region::posterior);
    strip.quad_region.insert(strip.quad_region.end(), 10, Region::root);
    std::vector<double> volumes, stress; // as large as x, in the cells' middle
    for (const bool is_longer : {false, true})
      for (unsigned int q = 0; q < 60; ++q)
        {
          strip.cell_quad.push_back(q);
          volumes.push_back(is_longer ? 0.75 : 0.25);
          stress.push_back(q + (is_longer ? 0.625 : 0.125));
        }
    const auto mean = [&](const Region region) {
      return weighted_mean(stress, volumes_in_region(strip, region, volumes));
    };
    check_relative("mean of the anterior leaflet",
                   mean(Region::anterior),
                   10,
                   1e-12);
    check_relative("mean of the posterior leaflet",
                   mean(Region::posterior),
                   35,
                   1e-12);
    check_relative("mean of the root", mean(Region::root), 55, 1e-12);
    // 94 % of 20 is 18.8, in the longer cell of the 19th quadrilateral
    check_relative(
      "what 6 % of the anterior leaflet exceed",
      weighted_quantile(stress,
                        volumes_in_region(strip, Region::anterior, volumes),
                        0.94),
      18.625,
      1e-12);
    check("a region that is not there has no volume",
          volumes_in_region(strip, Region::septal, volumes) ==
            std::vector<double>(volumes.size(), 0.));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  four_values();
  linear_pressure();
  linear_stress();
}
