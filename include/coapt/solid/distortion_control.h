#ifndef coapt_solid_distortion_control_h
#define coapt_solid_distortion_control_h

#include <coapt/geometry/simplex_mesh.h>
#include <coapt/solid/small_matrix.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace coapt
{
  /**
   * Keeps cells from being crushed: where the smallest principal stretch
   * lambda relative to the mesh is below a threshold theta, a cell has the
   * additional energy
   *   K/2 (theta - lambda)^2 for each reference volume,
   * so the first Piola stress -K (theta - lambda) n x N, with the directions N
   * before and n after of that stretch. An inverted cell counts as one with a
   * negative stretch and is pushed back through zero. (As the distortion
   * control of the Abaqus manual does, this acts on a length ratio, here with
   * an energy, so that the balance of energies holds.)
   *
   * K is M/theta^2, with the largest modulus M of a plane wave at rest. That is
   * how stiff a volumetric energy with ln J is there, so steps become shorter
   * by no more than a root of two; and to crush a cell to nothing takes M/2 for
   * each volume, four times as much as for Saint-Venant and Kirchhoff's law.
   */
  template <int dim>
  class DistortionControl
  {
  public:
    /** Acts on the linear @p cells of the @p mesh below the stretch @p
     * threshold, with the @p modulus M (Pa). */
    DistortionControl(const SimplexMesh<dim> &mesh,
                      const std::vector<unsigned int> &cells,
                      const double threshold,
                      const double modulus);

    /** Adds to @p F (N) the forces at the positions @p X (m). */
    void
    add_forces(const double *X, double *F) const;

    /** Energy of these cells (J). */
    double
    energy(const double *X) const;

  private:
    struct Cell
    {
      std::array<unsigned int, dim + 1> nodes;
      dealii::Tensor<2, dim> to_reference; // inverse of the edges by columns
      double volume;
    };

    /** Deformation gradient. */
    static dealii::Tensor<2, dim>
    gradient(const Cell &cell, const double *X);

    /** Whether the smallest stretch may be below the threshold; exact enough to
     * leave out nearly all others. */
    bool
    may_be_distorted(const dealii::Tensor<2, dim> &F) const;

    const double threshold, stiffness;
    std::vector<Cell> cells;
  };

  /** Smallest principal stretch and its directions. */
  struct SmallestStretch
  {
    double value; // negative if inverted
    std::array<double, 3> before, after;
  };

  /** Of the deformation gradient @p F. */
  SmallestStretch
  smallest_stretch(const SmallMatrix<3, double> &F);
} // namespace coapt

#endif
