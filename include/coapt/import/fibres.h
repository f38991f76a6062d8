#ifndef coapt_import_fibres_h
#define coapt_import_fibres_h

#include <coapt/import/surface_mesh.h>

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * Fibre direction of each quadrilateral of the @p surface, from a CSV with
   * the columns fx, fy, fz and a row for each element of the mesh's file.
   *
   * @throws InputError with file and line if there are not as many rows as
   * elements, if a fibre is zero, or if it is more than 30 degrees away from
   * the tangential plane of its element.
   */
  std::vector<dealii::Tensor<1, 3>>
  read_fibres(const std::string &file, const SurfaceMesh &surface);
} // namespace coapt

#endif
