#ifndef coapt_immersion_fluid_within_h
#define coapt_immersion_fluid_within_h

#include <coapt/fluid/fluid_operator.h>
#include <coapt/geometry/coupling_lattice.h>
#include <coapt/geometry/simplex_mesh.h>
#include <coapt/immersion/coupling_points.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * Takes the pressure of the fluid that fills a solid off its stress. Without
   * this, the solid has its own stress and -p besides, so that rho c^2 adds to
   * its bulk modulus where the fluid follows its changes of volume. That the
   * fluid's stress is taken off the solid's is due to the variational form of
   * Heltai and Costanzo (2012).
   *
   * The stress +p I in the solid, p of the cell at each coupling point, has its
   * adjoint in the equation of state, where only the rest of the change of
   * volume compresses the fluid of a cell:
   *   V p' = -rho c^2 (V div u - sum_q w_q J_q div v),
   * so that the energies of both add up as before.
   */
  template <int dim>
  class FluidWithin
  {
  public:
    /** @p points couple the whole volume of @p mesh. */
    FluidWithin(const SimplexMesh<dim> &mesh,
                const CouplingPoints<dim> &points);

    /**
     * Takes over the cells of the points, for the positions @p X (m) of the
     * solid's nodes. Returns whether this rank owns all of those cells; points
     * in others are left out.
     */
    bool
    update(const FluidOperator<dim> &fluid, const double *X);

    /** Adds to the forces @p F (N) on the solid's nodes and to the rates of the
     * pressures of this rank (Pa/s), for velocities @p V (m/s). */
    void
    add(const double *pressure,
        const double *V,
        double *F,
        double *pressure_rate) const;

  private:
    /** The points of an element that lie in the same cell. */
    struct Part
    {
      unsigned int cell;
      double fraction;           // of the element
      double modulus_per_volume; // rho c^2 over the volume of the cell
    };

    /** Element of the solid with consecutive parts. */
    struct Element
    {
      unsigned int number;

      /** Derivatives of its volume to the positions of its nodes. */
      std::array<dealii::Tensor<1, dim>, dim + 1> slopes;
      unsigned int begin, end;
    };

    /** Derivatives of the volume of the element @p number. */
    std::array<dealii::Tensor<1, dim>, dim + 1>
    volume_slopes(const unsigned int number, const double *X) const;

    /** Adds a point to the elements. */
    void
    append(const unsigned int id,
           const unsigned int cell,
           const FluidOperator<dim> &fluid,
           const double *X);

    const SimplexMesh<dim> &mesh;
    const CouplingPoints<dim> &points;
    std::vector<double> volumes; // of all elements in the reference
    std::vector<Element> elements;
    std::vector<Part> parts;
  };
} // namespace coapt

#endif
