#ifndef coapt_solid_distortion_control_h
#define coapt_solid_distortion_control_h

#include <coapt/geometry/simplex_mesh.h>
#include <coapt/solid/small_matrix.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Keeps cells from being crushed: each principal stretch lambda relative to
   * the mesh that is below a threshold theta adds the energy
   *   K/2 (theta - lambda)^2 for each reference volume,
   * so the first Piola stress -K (theta - lambda) n x N, with the directions N
   * before and n after of that stretch. An inverted cell counts as one whose
   * smallest stretch is negative and is pushed back through zero. (As the
   * distortion control of the Abaqus manual does, this acts on a length ratio,
   * here with an energy, so that the balance of energies holds.) With the
   * smallest stretch alone, the force would jump where two are equal, and a
   * cell could still be crushed to a needle.
   *
   * K is M/theta^2, with the largest modulus M of a plane wave at rest. That is
   * how stiff a volumetric energy with ln J is there, so for such materials
   * steps become shorter by no more than a root of two; for those that do not
   * stiffen, by up to 1/theta. To crush a cell to nothing takes M/2 for each
   * volume, four times as much as for Saint-Venant and Kirchhoff's law. The
   * curvature of the energy is at most K, as a function of the deformation
   * gradient: that gives the bound of the frequencies.
   */
  template <int dim>
  class DistortionControl
  {
  public:
    /** Acts on the linear @p cells of the @p mesh below the stretch @p
     * threshold, with the @p modulus M (Pa). @p mass is that of the nodes (kg).
     */
    DistortionControl(const SimplexMesh<dim> &mesh,
                      const std::vector<unsigned int> &cells,
                      const double threshold,
                      const double modulus,
                      const std::vector<double> &mass);

    /** Adds to @p F (N) the forces at the positions @p X (m). */
    void
    add_forces(const double *X, double *F) const;

    /** Energy of these cells (J). */
    double
    energy(const double *X) const;

    /** Bound of the squares of the frequencies (1/s^2), without those of the
     * material, and the cell that has it. */
    struct Bound
    {
      double square     = 0;
      unsigned int cell = 0;
    };

    /** Of the cells that are distorted or soon will be. */
    Bound
    frequency_bound(const double *X) const;

  private:
    struct Cell
    {
      std::array<unsigned int, dim + 1> nodes;
      unsigned int number;
      dealii::Tensor<2, dim> to_reference; // inverse of the edges by columns
      double volume;
      double square_frequency; // bound while it is distorted

      /** Change of a stretch at most for each length that nodes move (1/m). */
      double sensitivity;
    };

    /** Sets what follows from the gradients of the shape functions; @p
     * volume_at_nodes is the sum of the volumes around each node. */
    void
    set_bounds(Cell &cell,
               const std::vector<double> &volume_at_nodes,
               const std::vector<double> &mass) const;

    /** Deformation gradient. */
    static dealii::Tensor<2, dim>
    gradient(const Cell &cell, const double *X);

    /** Cells that alone can be distorted at @p X. */
    const std::vector<unsigned int> &
    candidates(const double *X) const;

    /** Finds the candidates anew. */
    void
    find_candidates(const double *X) const;

    void
    add_forces(const Cell &cell, const double *X, double *F) const;

    const double threshold, stiffness;
    const unsigned int n_nodes;
    std::vector<Cell> cells;

    /** The list, and from where and how far (m) nodes may move before others
     * can be distorted. Changes nothing but the cost. @{ */
    mutable std::vector<unsigned int> candidate_list;
    mutable std::vector<double> origin;
    mutable double reach = -1;
    /** @} */
  };

  /** Principal stretches and their directions, as columns. If the gradient
   * inverts, the smallest stretch is negative. */
  struct PrincipalStretches
  {
    std::array<double, 3> value;
    SmallMatrix<3, double> before, after;
  };

  /** Of the deformation gradient @p F. */
  PrincipalStretches
  principal_stretches(const SmallMatrix<3, double> &F);

  /** The smallest of them. */
  double
  smallest_stretch(const SmallMatrix<3, double> &F);
} // namespace coapt

#endif
