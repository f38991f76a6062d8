#ifndef coapt_coupled_enclosed_fluid_h
#define coapt_coupled_enclosed_fluid_h

#include <coapt/coupled/pressure_sink.h>
#include <coapt/immersion/coupling_points.h>

#include <mpi.h>

#include <vector>

namespace coapt
{
  /**
   * The fluid within bodies that are coupled at their surface. The bodies feel
   * the difference of the fluid's stresses outside and inside, but in the place
   * of the body there is no fluid. Its pressure is also arbitrary: a wall that
   * is felt 0.01 cells off changes the enclosed area by so much that rho c^2
   * makes more of it than there is outside. So the cells within a body go to
   * the pressure zero, as a body without stress has it:
   *
   *   p' = ... - phi r p,
   *
   * where r is a fiftieth of the rate at which sound crosses a cell, and phi
   * goes from 0 to 1 while the body takes from three quarters to all of the
   * cell.
   */
  template <int dim>
  class EnclosedFluid : public PressureSink
  {
  public:
    /** Of bodies with the @p mesh in cells of @p cell_size (m) or more. Both
     * references must outlive this. */
    EnclosedFluid(const SimplexMesh<dim> &mesh,
                  const FluidOperator<dim> &fluid,
                  const double cell_size,
                  MPI_Comm communicator);

    /** Finds the cells within for the positions @p X of the nodes (m). Due when
     * bodies have moved by a good part of a cell. Collective. */
    void
    update(const double *X);

    void
    add_rate(const double *pressure, double *pressure_rate) override;

    double
    power(const double *pressure) const override;

  private:
    struct Cell
    {
      unsigned int number;
      double rate;       // phi r, 1/s
      double compliance; // volume by rho c^2, m^3/Pa
    };

    const FluidOperator<dim> &fluid;
    CouplingPoints<dim> points; // only to find the cells
    std::vector<double> no_multiplier;
    std::vector<Cell> cells;
  };
} // namespace coapt

#endif
