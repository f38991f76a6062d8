#include <coapt/base/exceptions.h>
#include <coapt/solid/cell_batch.h>
#include <coapt/solid/partition.h>
#include <coapt/solid/quadratic_solid.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  using dealii::Tensor;

  namespace
  {
    /** Shares of an element's mass. @{ */
    constexpr double vertex_share = 1. / 36;
    constexpr double edge_share   = 4. / 27;
    /** @} */

    /** Barycentric coordinates of the four points of degree two: the larger one
     * is that of the vertex of the same number. @{ */
    constexpr double near_vertex = 0.58541019662496845;
    constexpr double far_vertex  = 0.13819660112501051;
    /** @} */

    /** Gradients of the barycentric coordinates of a tetrahedron. */
    std::array<Tensor<1, 3>, 4>
    barycentric_gradients(const SimplexMesh<3> &mesh, const unsigned int cell)
    {
      Tensor<2, 3> edges;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int d = 0; d < 3; ++d)
          edges[d][a] = mesh.points[mesh.cells[cell][a + 1]][d] -
            mesh.points[mesh.cells[cell][0]][d];
      const Tensor<2, 3> inverse = invert(edges);
      std::array<Tensor<1, 3>, 4> result;
      for (unsigned int a = 0; a < 3; ++a)
        {
          result[a + 1] = inverse[a];
          result[0] -= inverse[a];
        }
      return result;
    }

    /** Gradients of the ten shape functions at the point near a vertex. */
    std::array<Tensor<1, 3>, 10>
    shape_gradients(const std::array<Tensor<1, 3>, 4> &gradient,
                    const unsigned int vertex)
    {
      const auto coordinate = [vertex](const unsigned int a) {
        return a == vertex ? near_vertex : far_vertex;
      };
      std::array<Tensor<1, 3>, 10> result;
      for (unsigned int a = 0; a < 4; ++a)
        result[a] = (4 * coordinate(a) - 1) * gradient[a];
      for (unsigned int e = 0; e < 6; ++e)
        {
          const unsigned int a = QuadraticMesh::edges[e][0];
          const unsigned int b = QuadraticMesh::edges[e][1];
          result[4 + e] =
            4 * (coordinate(a) * gradient[b] + coordinate(b) * gradient[a]);
        }
      return result;
    }
  } // namespace



  QuadraticSolid::QuadraticSolid(const QuadraticMesh &mesh,
                                 const Material &material,
                                 const double density,
                                 const double viscosity,
                                 const std::vector<Tensor<1, 3>> &fibre,
                                 const MPI_Comm communicator)
    : communicator(communicator)
    , material(material)
    , density(density)
    , viscosity(viscosity)
    , nodal_mass(mesh.linear.points.size(), 0.)
  {
    if (!fibre.empty() && fibre.size() != mesh.cells.size())
      throw InputError(
        "Solid: " + std::to_string(fibre.size()) + " fibres are given for " +
        std::to_string(mesh.cells.size()) + " cells, one a cell is needed.");
    const std::vector<double> volumes = signed_volumes(mesh.linear);
    for (unsigned int i = 0; i < volumes.size(); ++i)
      {
        if (!(volumes[i] > 0))
          throw InputError("Solid mesh: cell " + std::to_string(i) +
                           " is inverted or without volume.");
        for (unsigned int a = 0; a < 10; ++a)
          nodal_mass[mesh.cells[i][a]] +=
            density * volumes[i] * (a < 4 ? vertex_share : edge_share);
      }
    build(mesh, partition_cells(mesh.linear, communicator), fibre);
  }



  void
  QuadraticSolid::build(const QuadraticMesh &mesh,
                        const std::vector<unsigned int> &cells,
                        const std::vector<Tensor<1, 3>> &fibre)
  {
    const std::vector<double> volumes = signed_volumes(mesh.linear);
    batches.resize((cells.size() + batch_size - 1) / batch_size);
    for (unsigned int i = 0; i < batches.size() * batch_size; ++i)
      {
        // Unused lanes repeat the last cell with no volume.
        const bool used         = i < cells.size();
        const unsigned int cell = used ? cells[i] : cells.back();
        const unsigned int lane = i % batch_size;
        Batch10 &batch          = batches[i / batch_size];
        if (used)
          batch.n_filled = lane + 1;
        const auto gradients = barycentric_gradients(mesh.linear, cell);
        for (unsigned int q = 0; q < 4; ++q)
          {
            const auto shape = shape_gradients(gradients, q);
            for (unsigned int a = 1; a < 10; ++a)
              for (unsigned int d = 0; d < 3; ++d)
                batch.point[q].gradient[a - 1][d][lane] = shape[a][d];
            batch.point[q].volume[lane] = used ? volumes[cell] / 4 : 0.;
          }
        for (unsigned int d = 0; d < 9; ++d)
          batch.fibre[d][lane] =
            d < 3 && !fibre.empty() ? fibre[cell][d] / fibre[cell].norm() : 0.;
        for (unsigned int a = 0; a < 10; ++a)
          batch.entry[a][lane] = 3 * mesh.cells[cell][a];
      }
  }



  void
  QuadraticSolid::Batch10::load(const double *x, Batch (&relative)[9][3]) const
  {
    Batch origin[3];
    load_nodes<3>(x, entry[0], origin);
    for (unsigned int a = 0; a < 9; ++a)
      {
        load_nodes<3>(x, entry[a + 1], relative[a]);
        for (unsigned int c = 0; c < 3; ++c)
          relative[a][c] -= origin[c];
      }
  }



  SmallMatrix<3, Batch>
  QuadraticSolid::Batch10::gradient_of(const Batch (&relative)[9][3],
                                       const Point &point)
  {
    SmallMatrix<3, Batch> G{};
    for (unsigned int a = 0; a < 9; ++a)
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          G[c][d] += relative[a][c] * point.gradient[a][d];
    return G;
  }



  void
  QuadraticSolid::add_forces(const double *X, const double *V, double *F) const
  {
    std::visit(
      [&](const auto &law) {
        for (const Batch10 &batch : batches)
          {
            Batch x[9][3], v[9][3], force[9][3] = {}, rest[3] = {};
            batch.load(X, x);
            batch.load(V, v);
            for (const typename Batch10::Point &point : batch.point)
              {
                SmallMatrix<3, Batch> stress =
                  law.first_piola(Batch10::gradient_of(x, point), batch.fibre);
                const auto rate = Batch10::gradient_of(v, point);
                for (unsigned int c = 0; c < 3; ++c)
                  for (unsigned int d = 0; d < 3; ++d)
                    stress[c][d] =
                      point.volume * (stress[c][d] + viscosity * rate[c][d]);
                for (unsigned int a = 0; a < 9; ++a)
                  for (unsigned int c = 0; c < 3; ++c)
                    for (unsigned int d = 0; d < 3; ++d)
                      force[a][c] -= stress[c][d] * point.gradient[a][d];
              }
            for (unsigned int a = 0; a < 9; ++a)
              {
                add_to_nodes<3>(F,
                                batch.entry[a + 1],
                                batch.n_filled,
                                force[a]);
                for (unsigned int c = 0; c < 3; ++c)
                  rest[c] -= force[a][c];
              }
            add_to_nodes<3>(F, batch.entry[0], batch.n_filled, rest);
          }
      },
      material);
  }



  double
  QuadraticSolid::elastic_energy(const double *X) const
  {
    Batch sum{};
    std::visit(
      [&](const auto &law) {
        for (const Batch10 &batch : batches)
          {
            Batch x[9][3];
            batch.load(X, x);
            for (const typename Batch10::Point &point : batch.point)
              sum += point.volume *
                law.energy(Batch10::gradient_of(x, point), batch.fibre);
          }
      },
      material);
    double energy = 0;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      energy += sum[lane];
    return dealii::Utilities::MPI::sum(energy, communicator);
  }



  template <typename Law>
  double
  QuadraticSolid::local_max_frequency(const Law &law, const double *X) const
  {
    double largest = 0;
    for (const Batch10 &batch : batches)
      {
        Batch x[9][3], square{};
        batch.load(X, x);
        for (const typename Batch10::Point &point : batch.point)
          {
            // A quarter of the volume over the node's share of the mass.
            const double vertex = std::sqrt(0.25 / (density * vertex_share));
            const double edge   = std::sqrt(0.25 / (density * edge_share));
            Batch scaled[12][3] = {};
            for (unsigned int a = 0; a < 9; ++a)
              for (unsigned int d = 0; d < 3; ++d)
                {
                  scaled[a + 1][d] =
                    (a < 3 ? vertex : edge) * point.gradient[a][d];
                  scaled[0][d] -= vertex * point.gradient[a][d];
                }
            const auto F = Batch10::gradient_of(x, point);
            for (unsigned int group = 0; group < 3; ++group)
              {
                Batch four[4][3];
                for (unsigned int a = 0; a < 4; ++a)
                  std::copy_n(scaled[4 * group + a], 3, four[a]);
                square += law.stiffness_bound(F, batch.fibre, four);
              }
          }
        for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
          // For MPI's reduction, a NaN is the largest number.
          largest = square[lane] <= largest
            ? largest
            : (std::isnan(square[lane])
                 ? std::numeric_limits<double>::infinity()
                 : square[lane]);
      }
    return std::sqrt(largest);
  }



  double
  QuadraticSolid::max_frequency(const double *X) const
  {
    double omega = 0;
    std::visit([&](const auto &law) { omega = local_max_frequency(law, X); },
               material);
    omega = dealii::Utilities::MPI::max(omega, communicator);
    return std::isfinite(omega) ? omega
                                : std::numeric_limits<double>::quiet_NaN();
  }
} // namespace coapt
