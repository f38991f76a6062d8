#include <coapt/base/csv_table.h>
#include <coapt/base/exceptions.h>
#include <coapt/import/fibres.h>

#include <cmath>

namespace coapt
{
  using dealii::Tensor;

  std::vector<Tensor<1, 3>>
  read_fibres(const std::string &file, const SurfaceMesh &surface)
  {
    const CsvTable table(file);
    const auto x = table.numbers("fx"), y = table.numbers("fy"),
               z = table.numbers("fz");
    if (table.n_rows() != surface.n_elements)
      throw InputError(file + ": " + std::to_string(table.n_rows()) +
                       " fibres are given for " +
                       std::to_string(surface.n_elements) +
                       " elements, one for each is needed");
    std::vector<Tensor<1, 3>> result;
    for (unsigned int q = 0; q < surface.quads.size(); ++q)
      {
        const unsigned int e = surface.elements[q];
        const auto &quad     = surface.quads[q];
        Tensor<1, 3> fibre({x[e], y[e], z[e]});
        if (!(fibre.norm() > 0))
          throw InputError(table.place(e) + ": the fibre is zero");
        fibre /= fibre.norm();
        const Tensor<1, 3> normal =
          cross_product_3d(surface.points[quad[2]] - surface.points[quad[0]],
                           surface.points[quad[3]] - surface.points[quad[1]]);
        const double sine = std::abs(fibre * normal) / normal.norm();
        if (sine > 0.5)
          throw InputError(
            table.place(e) + ": the fibre is " +
            std::to_string(std::asin(std::min(1., sine)) * 180 / M_PI) +
            " degrees away from the tangential plane of its "
            "element; allowed are 30");
        result.push_back(fibre);
      }
    return result;
  }
} // namespace coapt
