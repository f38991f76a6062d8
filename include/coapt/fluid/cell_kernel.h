#ifndef coapt_fluid_cell_kernel_h
#define coapt_fluid_cell_kernel_h

#include <coapt/fluid/cell_modes.h>

#include <array>
#include <vector>

namespace coapt
{
  namespace internal
  {
    /**
     * The loop over cells: forces of pressure, viscosity, convection and
     * hourglass damping. Eight cells are worked on at once; their velocities
     * are loaded as contiguous node triples and transposed, which is about ten
     * times faster than deal.II's MatrixFree without vector registers.
     */
    template <int dim>
    class CellKernel
    {
    public:
      /** Number of corners of a cell. */
      static constexpr int n_corners = 1 << dim;

      /** Forgets all cells. */
      void
      clear();

      /**
       * Adds a cell: the local numbers of its @p nodes, the index of its
       * pressure, and its size (m).
       */
      void
      add_cell(const std::array<unsigned int, n_corners> &nodes,
               const unsigned int pressure_index,
               const double size);

      /**
       * Adds the nodal forces (N) of all cells to @p force and overwrites
       * their entries of @p pressure_rate (Pa/s). Velocity and force have
       * dim entries for every local node.
       */
      void
      evaluate(const CellCoefficients &coefficients,
               const double *velocity,
               const double *pressure,
               double *force,
               double *pressure_rate) const;

    private:
      /** Eight cells; lanes from n_filled on repeat the first one. */
      struct Batch
      {
        EightDoubles size;
        int offset[n_corners][8]; // dim times the node number
        int pressure[8];
        int n_filled;
      };

      std::vector<Batch> batches;
    };
  } // namespace internal
} // namespace coapt

#endif
