#include <coapt/geometry/quadratic_mesh.h>
#include <coapt/solid/cell_batch.h>

namespace coapt
{
  using dealii::Tensor;

  namespace
  {
    template <int dim, int degree>
    using Gradients =
      std::array<Tensor<1, dim>, CellBatch<dim, degree>::n_nodes>;

    /** Gradients of the shape functions at a @p point of the unit simplex. */
    template <int dim, int degree>
    Gradients<dim, degree>
    unit_gradients(const int point)
    {
      Gradients<dim, 1> vertex;
      for (int d = 0; d < dim; ++d)
        {
          vertex[d + 1][d] = 1;
          vertex[0][d]     = -1;
        }
      if constexpr (degree == 1)
        return vertex;
      else
        {
          // The points of degree two for three points in 2D, four in 3D.
          constexpr double near = dim == 2 ? 2. / 3 : 0.58541019662496845;
          constexpr double far  = dim == 2 ? 1. / 6 : 0.13819660112501051;
          const auto coordinate = [point](const int a) {
            return a == point ? near : far;
          };
          Gradients<dim, degree> result;
          for (int a = 0; a <= dim; ++a)
            result[a] = (4 * coordinate(a) - 1) * vertex[a];
          int node = dim + 1;
          for (const auto &[a, b] : simplex_edges<dim>())
            result[node++] =
              4 * (coordinate(a) * vertex[b] + coordinate(b) * vertex[a]);
          return result;
        }
    }

    /** Derivative of the position (m) to that in the unit simplex. */
    template <int dim, int degree>
    Tensor<2, dim>
    jacobian(const SimplexMesh<dim> &mesh,
             const unsigned int number,
             const Gradients<dim, degree> &gradients)
    {
      const auto &nodes = elements<dim, degree>(mesh)[number];
      Tensor<2, dim> result;
      for (unsigned int a = 0; a < nodes.size(); ++a)
        result +=
          outer_product(Tensor<1, dim>(mesh.points[nodes[a]]), gradients[a]);
      return result;
    }

    /** Volume of a point with this @p jacobian. */
    template <int dim, int degree>
    double
    volume(const Tensor<2, dim> &jacobian)
    {
      return determinant(jacobian) /
        ((dim == 2 ? 2 : 6) * CellBatch<dim, degree>::n_points);
    }

    /** Sets the directions of the entry @p lane. */
    template <int dim>
    void
    fill_directions(Batch (&directions)[dim * dim],
                    const unsigned int lane,
                    const Tensor<1, dim> &fibre,
                    const Tensor<1, dim> &normal)
    {
      for (Batch &component : directions)
        component[lane] = 0;
      if (!(fibre.norm() > 0))
        return;
      const auto along = fibre / fibre.norm();
      for (int d = 0; d < dim; ++d)
        directions[d][lane] = along[d];
      if constexpr (dim == 3)
        {
          auto up = normal - (normal * along) * along;
          if (!(up.norm() > 1e-6 * normal.norm()))
            return;
          up /= up.norm();
          const auto across = cross_product_3d(up, along);
          for (int d = 0; d < 3; ++d)
            {
              directions[3 + d][lane] = across[d];
              directions[6 + d][lane] = up[d];
            }
        }
    }

    /** Sets geometry of the entry @p lane of the @p point. */
    template <int dim, int degree>
    void
    fill_geometry(typename CellBatch<dim, degree>::Point &point,
                  const unsigned int lane,
                  const Tensor<2, dim> &jacobian,
                  const Gradients<dim, degree> &unit,
                  const Tensor<2, dim> &prestretch)
    {
      const auto to_stress_free = invert(jacobian) * prestretch;
      point.volume[lane]        = volume<dim, degree>(jacobian);
      for (unsigned int a = 1; a < unit.size(); ++a)
        {
          const auto gradient = unit[a] * to_stress_free;
          for (int d = 0; d < dim; ++d)
            point.gradient[a - 1][d][lane] = gradient[d];
        }
    }
  } // namespace



  template <int dim, int degree>
  std::vector<CellBatch<dim, degree>>
  build_batches(const SimplexMesh<dim> &mesh,
                const std::vector<unsigned int> &numbers,
                const std::vector<Tensor<1, dim>> &fibre,
                const std::vector<Tensor<2, dim>> &prestretch,
                const std::vector<Tensor<1, dim>> &normal)
  {
    using Cells = CellBatch<dim, degree>;
    Tensor<2, dim> identity;
    for (int d = 0; d < dim; ++d)
      identity[d][d] = 1;
    std::vector<Cells> batches((numbers.size() + batch_size - 1) / batch_size);
    for (unsigned int i = 0; i < batches.size() * batch_size; ++i)
      {
        const bool used           = i < numbers.size();
        const unsigned int number = used ? numbers[i] : numbers.back();
        const unsigned int lane   = i % batch_size;
        Cells &batch              = batches[i / batch_size];
        batch.cell[lane]          = number;
        for (int a = 0; a < Cells::n_nodes; ++a)
          batch.entry[a][lane] = dim * elements<dim, degree>(mesh)[number][a];
        for (int q = 0; q < Cells::n_points; ++q)
          {
            const unsigned int cell = Cells::n_parts * number + q;
            const auto unit         = unit_gradients<dim, degree>(q);
            fill_geometry<dim, degree>(
              batch.point[q],
              lane,
              jacobian<dim, degree>(mesh, number, unit),
              unit,
              prestretch.empty() ? identity : prestretch[cell]);
            fill_directions<dim>(batch.point[q].fibre,
                                 lane,
                                 fibre.empty() ? Tensor<1, dim>() : fibre[cell],
                                 normal.empty() ? Tensor<1, dim>()
                                                : normal[cell]);
            if (!used)
              batch.point[q].volume[lane] = 0;
          }
        if (used)
          batch.n_filled = lane + 1;
      }
    return batches;
  }

  template <int dim, int degree>
  std::vector<std::array<double, CellBatch<dim, degree>::n_points>>
  point_volumes(const SimplexMesh<dim> &mesh)
  {
    std::vector<std::array<double, CellBatch<dim, degree>::n_points>> volumes(
      elements<dim, degree>(mesh).size());
    for (unsigned int q = 0; q < CellBatch<dim, degree>::n_points; ++q)
      {
        const auto unit = unit_gradients<dim, degree>(q);
        for (unsigned int i = 0; i < volumes.size(); ++i)
          volumes[i][q] =
            volume<dim, degree>(jacobian<dim, degree>(mesh, i, unit));
      }
    return volumes;
  }

  template <int dim>
  std::vector<double>
  signed_volumes(const SimplexMesh<dim> &mesh)
  {
    std::vector<double> volumes;
    for (const auto &volume : point_volumes<dim, 1>(mesh))
      volumes.push_back(volume[0]);
    return volumes;
  }

  template std::vector<CellBatch<2, 1>>
  build_batches<2, 1>(const SimplexMesh<2> &,
                      const std::vector<unsigned int> &,
                      const std::vector<Tensor<1, 2>> &,
                      const std::vector<Tensor<2, 2>> &,
                      const std::vector<Tensor<1, 2>> &);
  template std::vector<CellBatch<2, 2>>
  build_batches<2, 2>(const SimplexMesh<2> &,
                      const std::vector<unsigned int> &,
                      const std::vector<Tensor<1, 2>> &,
                      const std::vector<Tensor<2, 2>> &,
                      const std::vector<Tensor<1, 2>> &);
  template std::vector<CellBatch<3, 1>>
  build_batches<3, 1>(const SimplexMesh<3> &,
                      const std::vector<unsigned int> &,
                      const std::vector<Tensor<1, 3>> &,
                      const std::vector<Tensor<2, 3>> &,
                      const std::vector<Tensor<1, 3>> &);
  template std::vector<CellBatch<3, 2>>
  build_batches<3, 2>(const SimplexMesh<3> &,
                      const std::vector<unsigned int> &,
                      const std::vector<Tensor<1, 3>> &,
                      const std::vector<Tensor<2, 3>> &,
                      const std::vector<Tensor<1, 3>> &);
  template std::vector<std::array<double, 1>>
  point_volumes<2, 1>(const SimplexMesh<2> &);
  template std::vector<std::array<double, 3>>
  point_volumes<2, 2>(const SimplexMesh<2> &);
  template std::vector<std::array<double, 1>>
  point_volumes<3, 1>(const SimplexMesh<3> &);
  template std::vector<std::array<double, 4>>
  point_volumes<3, 2>(const SimplexMesh<3> &);
  template std::vector<double>
  signed_volumes(const SimplexMesh<2> &);
  template std::vector<double>
  signed_volumes(const SimplexMesh<3> &);
} // namespace coapt
