#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <coapt/fluid/cell_interpolation.h>
#include <coapt/metrics/plane_flux.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::GeometryInfo;
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    using Cell = FluidOperator<3>::Cell;

    /** The plane as the zeros of n . x - offset, and two directions in it. */
    struct Frame
    {
      explicit Frame(const Plane &plane)
        : normal(plane.normal / plane.normal.norm())
        , offset(normal * plane.point)
      {
        Tensor<1, 3> axis;
        axis[std::abs(normal[0]) < 0.5 ? 0 : 1] = 1;
        first = cross_product_3d(normal, axis);
        first /= first.norm();
        second = cross_product_3d(normal, first);
      }

      Tensor<1, 3> normal;
      double offset;
      Tensor<1, 3> first, second;
    };

    /** Corners, in order, of the polygon in which a plane cuts a cell, in
     * coordinates of the unit cell; fewer than three if it does not. A plane
     * that runs along a face cuts the cell before it only. */
    std::vector<Point<3>>
    section(const Cell &cell, const Frame &frame)
    {
      std::array<double, 8> height;
      for (unsigned int v = 0; v < 8; ++v)
        {
          const Point<3> unit = GeometryInfo<3>::unit_cell_vertex(v);
          height[v] = (frame.normal * cell.lower - frame.offset) / cell.size +
            frame.normal * unit;
          // the same in all cells around a corner in spite of rounding
          if (std::abs(height[v]) < 1e-9)
            height[v] = 0;
        }
      std::vector<Point<3>> corners;
      for (unsigned int line = 0; line < GeometryInfo<3>::lines_per_cell;
           ++line)
        {
          const unsigned int a =
                               GeometryInfo<3>::line_to_cell_vertices(line, 0),
                             b =
                               GeometryInfo<3>::line_to_cell_vertices(line, 1);
          if ((height[a] < 0) == (height[b] < 0))
            continue;
          const double s      = height[a] / (height[a] - height[b]);
          const Point<3> from = GeometryInfo<3>::unit_cell_vertex(a),
                         to   = GeometryInfo<3>::unit_cell_vertex(b);
          corners.push_back(from + s * (to - from));
        }
      if (corners.empty())
        return corners;
      Point<3> center;
      for (const Point<3> &corner : corners)
        center += corner / static_cast<double>(corners.size());
      std::sort(corners.begin(),
                corners.end(),
                [&](const Point<3> &a, const Point<3> &b) {
                  const auto angle = [&](const Point<3> &x) {
                    return std::atan2((x - center) * frame.second,
                                      (x - center) * frame.first);
                  };
                  return angle(a) < angle(b);
                });
      return corners;
    }
  } // namespace



  double
  flux_through_plane(const FluidOperator<3> &fluid,
                     const std::vector<double> &fluid_velocity,
                     const Plane &plane,
                     MPI_Comm communicator)
  {
    const Frame frame(plane);
    // of degree five, for trilinear functions are cubic in a plane
    const dealii::QGaussSimplex<2> quadrature(3);
    double flux = 0;
    for (unsigned int c = 0; c < fluid.n_owned_cells(); ++c)
      {
        if (!fluid.is_active_cell(c))
          continue;
        const Cell &cell                    = fluid.cell(c);
        const std::vector<Point<3>> corners = section(cell, frame);
        for (unsigned int i = 2; i < corners.size(); ++i)
          {
            const Tensor<1, 3> ab = corners[i - 1] - corners[0],
                               ac = corners[i] - corners[0];
            // twice the area, as the weights add up to a half
            const double scale =
              cell.size * cell.size * cross_product_3d(ab, ac).norm();
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                const dealii::Point<2> &s = quadrature.point(q);
                flux += scale * quadrature.weight(q) * frame.normal *
                  interpolate<3>(cell,
                                 Point<3>(corners[0] + s[0] * ab + s[1] * ac),
                                 fluid_velocity);
              }
          }
      }
    return dealii::Utilities::MPI::sum(flux, communicator);
  }
} // namespace coapt
