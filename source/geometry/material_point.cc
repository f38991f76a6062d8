#include <coapt/base/exceptions.h>
#include <coapt/geometry/material_point.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  template <int dim>
  MaterialPoint<dim>
  find_material_point(const SimplexMesh<dim> &mesh,
                      const Point<dim> &point,
                      const std::string &name)
  {
    MaterialPoint<dim> best;
    double least = -std::numeric_limits<double>::max();
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const auto &nodes = mesh.cells[c];
        Tensor<2, dim> edges;
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int d = 0; d < dim; ++d)
            edges[d][a] =
              mesh.points[nodes[a + 1]][d] - mesh.points[nodes[0]][d];
        const Tensor<1, dim> local =
          invert(edges) * (point - mesh.points[nodes[0]]);
        std::array<double, dim + 1> weights;
        weights[0] = 1;
        for (unsigned int a = 0; a < dim; ++a)
          {
            weights[a + 1] = local[a];
            weights[0] -= local[a];
          }
        const double lowest = *std::min_element(weights.begin(), weights.end());
        if (lowest > least)
          {
            least = lowest;
            best  = {c, weights};
          }
      }
    if (least < -1e-6)
      {
        std::ostringstream message;
        message << name << ": (" << point << ") m is in no body";
        throw InputError(message.str());
      }
    return best;
  }



  template <int dim>
  Tensor<1, dim>
  displacement(const SimplexMesh<dim> &mesh,
               const MaterialPoint<dim> &point,
               const std::vector<double> &X)
  {
    Tensor<1, dim> result;
    for (unsigned int a = 0; a <= dim; ++a)
      {
        const unsigned int node = mesh.cells[point.cell][a];
        for (unsigned int d = 0; d < dim; ++d)
          result[d] +=
            point.weights[a] * (X[dim * node + d] - mesh.points[node][d]);
      }
    return result;
  }

  template MaterialPoint<2>
  find_material_point(const SimplexMesh<2> &,
                      const Point<2> &,
                      const std::string &);
  template MaterialPoint<3>
  find_material_point(const SimplexMesh<3> &,
                      const Point<3> &,
                      const std::string &);
  template Tensor<1, 2>
  displacement(const SimplexMesh<2> &,
               const MaterialPoint<2> &,
               const std::vector<double> &);
  template Tensor<1, 3>
  displacement(const SimplexMesh<3> &,
               const MaterialPoint<3> &,
               const std::vector<double> &);
} // namespace coapt
