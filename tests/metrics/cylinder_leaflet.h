#ifndef coapt_tests_metrics_cylinder_leaflet_h
#define coapt_tests_metrics_cylinder_leaflet_h

#include <coapt/metrics/leaflet_lines.h>

#include <cmath>

constexpr unsigned int n_angles = 72, n_rows = 12;
constexpr double radius = 15e-3, row_height = 1e-3;

inline unsigned int
column(const unsigned int i, const unsigned int j)
{
  return (i % n_angles) * (n_rows + 1) + j;
}

/** A cylinder; the commissures are at 20 to 30 and 150 to 160 degrees. */
inline coapt::Leaflet
cylinder()
{
  using coapt::Region;
  coapt::Leaflet leaflet;
  leaflet.thickness = 1e-3;
  for (unsigned int i = 0; i < n_angles; ++i)
    for (unsigned int j = 0; j <= n_rows; ++j)
      {
        const double t = 2 * M_PI * i / n_angles;
        leaflet.columns.push_back({2 * column(i, j), 2 * column(i, j) + 1});
        leaflet.column_coordinates.push_back(
          {{std::remainder(t, 2 * M_PI), j * 1. / n_rows}});
        for (const double r : {radius - 0.5e-3, radius + 0.5e-3})
          leaflet.mesh.points.emplace_back(r * std::cos(t),
                                           r * std::sin(t),
                                           -row_height * j);
        if (j == n_rows)
          leaflet.free_edge_columns.push_back(column(i, j));
        if (j == 0)
          leaflet.annulus_columns.push_back(column(i, j));
      }
  for (unsigned int i = 0; i < n_angles; ++i)
    for (unsigned int j = 0; j < n_rows; ++j)
      {
        leaflet.quads.push_back({{column(i, j),
                                  column(i, j + 1),
                                  column(i + 1, j + 1),
                                  column(i + 1, j)}});
        leaflet.quad_region.push_back(
          i >= 6 && i < 30                             ? Region::anterior
            : (i == 4 || i == 5 || i == 30 || i == 31) ? Region::commissure
                                                       : Region::posterior);
      }
  return leaflet;
}

/** Mid-surface of a leaflet in the reference, by column (m). */
inline std::vector<dealii::Point<3>>
mid_surface(const coapt::Leaflet &leaflet)
{
  std::vector<dealii::Point<3>> points;
  for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
    points.push_back(coapt::middle_of_column(leaflet, c));
  return points;
}

/** Marks rows 8 to 12 of all lines, but not from line @p begin to @p end. */
inline std::vector<bool>
belt_without(const unsigned int begin, const unsigned int end)
{
  std::vector<bool> marks(n_angles * (n_rows + 1), false);
  for (unsigned int i = 0; i < n_angles; ++i)
    for (unsigned int j = 8; j <= n_rows; ++j)
      marks[column(i, j)] = i < begin || i >= end;
  return marks;
}

#endif
