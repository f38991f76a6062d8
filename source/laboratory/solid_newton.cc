#include <mpi.h>

#include <coapt/laboratory/solid_newton.h>
#include <coapt/solid/tangent.h>

#include <Amesos_Klu.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Map.h>
#include <Epetra_SerialComm.h>
#include <Epetra_Vector.h>

#include <algorithm>
#include <cmath>

namespace coapt
{
  namespace
  {
    using Gradients = std::array<std::array<double, 3>, 4>;

    /** Volume of a tetrahedron with these corners, six times, and the gradients
     * of its shape functions. */
    double
    shape_gradients(const SimplexMesh<3> &mesh,
                    const std::array<unsigned int, 4> &cell,
                    Gradients &g)
    {
      SmallMatrix<3, double> edges;
      for (int a = 0; a < 3; ++a)
        for (int c = 0; c < 3; ++c)
          edges[c][a] = mesh.points[cell[a + 1]][c] - mesh.points[cell[0]][c];
      const auto C   = cofactors(edges);
      const double D = determinant(edges, C);
      for (int c = 0; c < 3; ++c)
        {
          g[0][c] = 0;
          for (int a = 0; a < 3; ++a)
            {
              g[a + 1][c] = C[c][a] / D;
              g[0][c] -= g[a + 1][c];
            }
        }
      return D;
    }

    double
    norm(const std::vector<double> &x)
    {
      double sum = 0;
      for (const double value : x)
        sum += value * value;
      return std::sqrt(sum);
    }
  } // namespace

  SolidNewton::SolidNewton(const SimplexMesh<3> &mesh,
                           const SolidOperator<3> &solid,
                           const Material &material,
                           const std::array<double, 9> &directions,
                           const std::vector<bool> &is_fixed)
    : mesh(mesh)
    , solid(solid)
    , material(material)
    , directions(directions)
    , row(is_fixed.size(), -1)
    , n_rows(0)
  {
    for (std::size_t i = 0; i < is_fixed.size(); ++i)
      if (!is_fixed[i])
        row[i] = n_rows++;

    // Stresses are differences of terms as large as the tangent.
    Gradients g;
    const double D = shape_gradients(mesh, mesh.cells[0], g);
    double largest = 0, steepest = 0;
    SmallMatrix<3, double> identity{};
    for (int i = 0; i < 3; ++i)
      identity[i][i] = 1;
    std::visit(
      [&](const auto &law) {
        const auto A = material_tangent(law, identity, directions.data());
        for (const auto &line : A.entry)
          for (const double entry : line)
            largest = std::max(largest, std::abs(entry));
      },
      material);
    for (const auto &gradient : g)
      for (const double component : gradient)
        steepest = std::max(steepest, std::abs(component));
    round_off = 1e-14 * largest * D * steepest;
  }

  std::vector<double>
  SolidNewton::residual(const std::vector<double> &X,
                        const std::vector<double> &load,
                        double &scale) const
  {
    std::vector<double> F(X.size(), 0.);
    const std::vector<double> at_rest(X.size(), 0.);
    solid.add_forces(X.data(), at_rest.data(), F.data());
    scale = 0;
    for (std::size_t i = 0; i < F.size(); ++i)
      {
        scale = std::max({scale, std::abs(F[i]), std::abs(load[i])});
        F[i]  = row[i] < 0 ? 0. : F[i] + load[i];
      }
    return F;
  }

  std::vector<double>
  SolidNewton::correction(const std::vector<double> &X,
                          const std::vector<double> &residual) const
  {
    const Epetra_SerialComm alone;
    const Epetra_Map map(n_rows, 0, alone);
    Epetra_CrsMatrix K(Copy, map, 60);
    for (const auto &cell : mesh.cells)
      {
        Gradients g;
        const double volume = shape_gradients(mesh, cell, g) / 6;
        SmallMatrix<3, double> F{};
        for (int a = 0; a < 4; ++a)
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              F[i][j] += X[3 * cell[a] + i] * g[a][j];
        MaterialTangent A;
        std::visit(
          [&](const auto &law) {
            A = material_tangent(law, F, directions.data());
          },
          material);
        for (int a = 0; a < 4; ++a)
          for (int i = 0; i < 3; ++i)
            {
              const int r = row[3 * cell[a] + i];
              if (r < 0)
                continue;
              for (int b = 0; b < 4; ++b)
                for (int j = 0; j < 3; ++j)
                  {
                    const int c = row[3 * cell[b] + j];
                    if (c < 0)
                      continue;
                    double entry = 0;
                    for (int k = 0; k < 3; ++k)
                      for (int l = 0; l < 3; ++l)
                        entry += g[a][k] * A[3 * i + k][3 * j + l] * g[b][l];
                    entry *= volume;
                    if (K.SumIntoGlobalValues(r, 1, &entry, &c) != 0)
                      K.InsertGlobalValues(r, 1, &entry, &c);
                  }
            }
      }
    K.FillComplete();

    Epetra_Vector right(map), change(map);
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i] >= 0)
        right[row[i]] = residual[i];
    Epetra_LinearProblem problem(&K, &change, &right);
    Amesos_Klu solver(problem);
    if (solver.NumericFactorization() != 0 || solver.Solve() != 0)
      return {};
    std::vector<double> result(row.size(), 0.);
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i] >= 0)
        result[i] = change[row[i]];
    return result;
  }

  unsigned int
  SolidNewton::solve(std::vector<double> &X,
                     const std::vector<double> &load) const
  {
    double scale;
    std::vector<double> r = residual(X, load, scale);
    for (unsigned int iteration = 1; iteration <= 50; ++iteration)
      {
        const double before = norm(r);
        if (before < round_off)
          return iteration;
        const auto direction = correction(X, r);
        if (direction.empty() || !std::isfinite(before))
          return 0;
        // Half as long a step until the residual falls.
        std::vector<double> trial(X.size());
        double fraction = 1, after = 0;
        for (; fraction > 1e-3; fraction /= 2)
          {
            for (std::size_t i = 0; i < X.size(); ++i)
              trial[i] = X[i] + fraction * direction[i];
            r     = residual(trial, load, scale);
            after = norm(r);
            if (after < before || after < std::max(1e-11 * scale, round_off))
              break;
          }
        X = trial;
        if (after < std::max(1e-11 * scale, round_off))
          return iteration;
      }
    return 0;
  }
} // namespace coapt
