#ifndef coapt_solid_solid_operator_h
#define coapt_solid_solid_operator_h

#include <coapt/solid/cell_batch.h>
#include <coapt/solid/cell_results.h>
#include <coapt/solid/distortion_control.h>
#include <coapt/solid/materials/material.h>
#include <coapt/solid/nodal_average.h>
#include <coapt/solid/solid_parameters.h>

#include <mpi.h>

#include <limits>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace coapt
{
  /**
   * The semi-discrete solid M X'' = -F_int(X) - F_visc(V) in the total
   * Lagrangian frame with a lumped mass matrix (Belytschko, Liu, Moran:
   * Nonlinear Finite Elements, section 4.9): the quadratic elements of the mesh
   * if it has such, otherwise its linear simplices. The first
   * Piola-Kirchhoff stress is that of the material at the elastic deformation
   * gradient F F0 plus the Kelvin-Voigt stress eta d(F F0)/dt.
   *
   * The Kelvin-Voigt stress is not objective: a rotation at the rate omega
   * costs a stress of eta omega, some ten Pa for a closing leaflet.
   *
   * Linear simplices lock where the material is nearly incompressible. If
   * asked to, the energy is that of deformation gradients whose ratio of
   * volumes is a mean over the neighbours (ScaledVolume, NodalAverage), which
   * leaves a pressure for each node instead of each cell.
   *
   * Crushed cells can be stiffened (DistortionControl), for which
   * step_bound() makes room before it happens.
   *
   * Every rank knows all nodes: nodal arrays have dim * n_nodes() entries,
   * [dim * node + component]. The elements are divided among the ranks. In 2D
   * the strain is plane, volumes are areas, and masses, forces and energies
   * are per thickness. What is given or returned "per cell" is so per linear
   * cell of the mesh, of which a quadratic element has eight (in 2D four): the
   * stress points of the element are those of the cells at its vertices, and
   * the four cells (in 2D one) inside have the mean of them.
   */
  template <int dim>
  class SolidOperator
  {
  public:
    /** Bound of the highest frequency, and where it is attained. */
    struct StepBound
    {
      /** Largest undamped angular frequency (1/s); NaN if X is not finite. */
      double omega = 0;

      /** Largest viscous damping ratio of a motion at omega. */
      double xi = 0;

      /** Cell that has this frequency, or is not finite; of a quadratic
       * element, the first. */
      unsigned int cell = 0;

      /** Smallest ratio of the volume to the stress-free one. */
      double min_jacobian = std::numeric_limits<double>::max();
    };

    /**
     * @p fibre (one vector a cell) is needed by the materials that have
     * fibres, and otherwise ignored; @p prestretch F0 (one tensor a cell,
     * positive determinant) may be empty: identity. @p normal (one vector a
     * cell) is needed by materials with several directions in the plane across
     * it. @p added_mass is that of the last nodes of the mesh (kg), which may
     * then belong to no cell. Collective.
     *
     * @throws InputError if cells are inverted or without volume (the first
     * ten are listed), if the material is not admissible or not available
     * (spatial ones in 2D), or if fibres, normals or prestretches are missing,
     * of another number than the cells, zero or singular.
     */
    SolidOperator(const SimplexMesh<dim> &mesh,
                  const SolidParameters &parameters,
                  const std::vector<dealii::Tensor<1, dim>> &fibre,
                  const std::vector<dealii::Tensor<2, dim>> &prestretch,
                  const MPI_Comm communicator,
                  const std::vector<dealii::Tensor<1, dim>> &normal = {},
                  const std::vector<double> &added_mass             = {});

    /** Number of nodes. */
    unsigned int
    n_nodes() const;

    /** Whether volumes are averaged over the neighbours. */
    bool
    averages_volume() const;

    /** Lumped mass of every node (kg), of the cells of all ranks and what was
     * added. */
    const std::vector<double> &
    mass() const;

    /**
     * Subtracts from @p F (N) the internal and viscous forces of this rank's
     * cells, at the positions @p X (m) and velocities @p V (m/s). Collective
     * where volumes are averaged.
     */
    void
    add_forces(const double *X, const double *V, double *F) const;

    /** step_bound().omega. Collective. */
    double
    max_frequency(const double *X) const;

    /**
     * Bound of the frequencies of all cells at the positions @p X, which
     * bounds those of the solid (Irons and Treharne, 1972). With it, central
     * differences are stable below dt = 2/omega (sqrt(1 + xi^2) - xi), and
     * the Kinnmark-Gray 5(3) method below 3.87/omega. For xi, the strongest
     * damping of any cell is taken. Collective.
     */
    StepBound
    step_bound(const double *X) const;

    /** Elastic energy of the whole solid (J). Collective. */
    double
    elastic_energy(const double *X) const;

    /** Power (W) that the viscosity dissipates. Collective. */
    double
    viscous_power(const double *V) const;

    /** Kinetic energy of the whole solid (J); the same on every rank. */
    double
    kinetic_energy(const double *V) const;

    /** Stress, strain and volume of every cell, on every rank, at the nodal
     * positions @p X (m). Collective. */
    CellResults
    cell_results(const double *X) const;

    /** Reference volume of every cell (m^3, in 2D m^2). */
    const std::vector<double> &
    cell_volumes() const;

    /** Numbers of the cells that this rank evaluates. */
    const std::vector<unsigned int> &
    owned_cells() const;

  private:
    /** Builds masses and batches of the elements of this degree. */
    template <int degree>
    void
    build(const SimplexMesh<dim> &mesh,
          const std::vector<dealii::Tensor<1, dim>> &fibre,
          const std::vector<dealii::Tensor<1, dim>> &normal,
          const std::vector<double> &added_mass);

    /** Calls @p f with the material and with the batches, as their own types.
     */
    template <typename Function>
    void
    with_material(const Function &f) const;

    /** Damping rate (1/s) that bounds those of all elements. Collective. */
    double
    largest_viscous_rate() const;

    /** Forces where volumes are averaged. */
    template <typename Law>
    void
    add_averaged_forces(const Law &law,
                        const std::vector<CellBatch<dim>> &batches,
                        const double *X,
                        const double *V,
                        double *F) const;

    /** Factor of the deformation gradient of each batch: one, but where volumes
     * are averaged. Collective. */
    template <typename Cells>
    std::vector<Batch>
    volume_factors(const std::vector<Cells> &batches, const double *X) const;

    /** Ratios of volumes of each batch, averaged. Collective. */
    std::vector<Batch>
    mean_ratios(const std::vector<CellBatch<dim>> &batches,
                const double *X) const;

    /** Largest stiffness over mass of the batches of this rank. */
    template <typename Law, typename Cells>
    StepBound
    local_step_bound(const Law &law,
                     const std::vector<Cells> &batches,
                     const double *X) const;

    /** Batches of linear or quadratic elements. */
    using Batches =
      std::variant<std::vector<CellBatch<dim>>, std::vector<CellBatch<dim, 2>>>;

    MPI_Comm communicator;
    double density, viscosity;
    double viscous_rate;
    Material material;
    std::vector<double> volumes, nodal_mass;
    std::vector<unsigned int> cells;
    std::vector<dealii::Tensor<2, dim>> prestretch;
    Batches batches;
    std::optional<NodalAverage<dim>> averaging;
    std::optional<DistortionControl<dim>> distortion;
  };
} // namespace coapt

#endif
