#ifndef coapt_solid_largest_frequency_h
#define coapt_solid_largest_frequency_h

#include <coapt/geometry/simplex_mesh.h>
#include <coapt/solid/solid_operator.h>

#include <mpi.h>

#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * The largest frequency of small vibrations of a solid about its deformed
   * state, which limits the step. SolidOperator::step_bound() is 1.6 to 1.8
   * times as large for fibrous leaflets, since all cells around a node do not
   * vibrate at their worst together; this class follows the fastest vibration
   * itself by power iteration (von Mises and Pollaczek-Geiringer, 1929) on
   * M^-1 K, with K w as a difference of internal forces. It goes on from the
   * vibration of the last call, to which a disturbance of the cell with the
   * largest bound is added, so that a cell that has stiffened since is found.
   */
  template <int dim>
  class LargestFrequency
  {
  public:
    /** Of @p solid with cells of @p mesh, where @p pinned nodes are at rest.
     * Both must outlive this object. */
    LargestFrequency(const SolidOperator<dim> &solid,
                     const SimplexMesh<dim> &mesh,
                     const std::vector<bool> &pinned,
                     MPI_Comm communicator);

    /**
     * The bound at the positions @p X (m), its frequency replaced by the
     * estimate: five percent above what the iteration has found, at most the
     * bound and at least 1/1.8 of it; xi belongs to it. Where volumes are
     * averaged, which slows down the fastest vibration but not the bound, at
     * least 1/2.5 of it: regular blocks have 1/2.2. Collective.
     */
    typename SolidOperator<dim>::StepBound
    update(const double *X);

    /** Saves or restores the shape found so far and the state of the noise. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      std::stringstream state;
      state << noise;
      std::string text = state.str();
      archive &is_new &shape &text;
      state.str(text);
      state >> noise;
    }

  private:
    /** Adds noise to the nodes of a cell, up to 0.3 of @p largest. */
    void
    disturb(const unsigned int cell, const double largest);

    double
    largest_component() const;

    /** w <- M^-1 K w, scaled to the norm one; returns the norm before. */
    double
    iterate(const double *X);

    /** Internal forces of this rank's cells. */
    void
    compute_forces(const std::vector<double> &X, std::vector<double> &F) const;

    /** Divides by the norm sqrt(w . M w), which is returned. */
    double
    normalize();

    const SolidOperator<dim> &solid;
    const SimplexMesh<dim> &mesh;
    const std::vector<bool> &pinned;
    MPI_Comm communicator;
    double displacement; // largest, of differences (m)
    bool is_new = true;

    std::mt19937 noise; // the same on all ranks
    std::vector<double> shape;
    std::vector<double> displaced, forces, displaced_forces;
  };
} // namespace coapt

#endif
