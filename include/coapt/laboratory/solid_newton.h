#ifndef coapt_laboratory_solid_newton_h
#define coapt_laboratory_solid_newton_h

#include <coapt/geometry/simplex_mesh.h>
#include <coapt/solid/materials/material.h>
#include <coapt/solid/solid_operator.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Static equilibrium of a solid by Newton's method: forces from the
   * SolidOperator, the tangent by automatic differentiation of the material,
   * corrections by the sparse direct solver KLU of Trilinos. On one process.
   */
  class SolidNewton
  {
  public:
    /** All directions of @p directions (fibre, across, normal) are the same in
     * every cell. @p is_fixed: which entries of nodal arrays keep their
     * values. */
    SolidNewton(const SimplexMesh<3> &mesh,
                const SolidOperator<3> &solid,
                const Material &material,
                const std::array<double, 9> &directions,
                const std::vector<bool> &is_fixed);

    /**
     * Moves the free entries of @p X (m) until the forces at them balance the
     * dead @p load (N) to 1e-11 of the largest force in a node. Returns the
     * number of iterations, or zero if they do not converge, with @p X
     * anywhere.
     */
    unsigned int
    solve(std::vector<double> &X, const std::vector<double> &load) const;

  private:
    /** Load minus internal forces, zero at fixed entries; largest nodal force
     * in @p scale. */
    std::vector<double>
    residual(const std::vector<double> &X,
             const std::vector<double> &load,
             double &scale) const;

    /** The correction that the tangent at @p X gives for a @p residual; empty
     * if that is singular. */
    std::vector<double>
    correction(const std::vector<double> &X,
               const std::vector<double> &residual) const;

    const SimplexMesh<3> &mesh;
    const SolidOperator<3> &solid;
    Material material;
    std::array<double, 9> directions;
    std::vector<int> row; ///< of each entry, -1 if it is fixed
    int n_rows;
    double round_off; ///< of a nodal force (N)
  };
} // namespace coapt

#endif
