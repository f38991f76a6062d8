#ifndef coapt_contact_facet_contact_h
#define coapt_contact_facet_contact_h

#include <coapt/contact/contact_law.h>
#include <coapt/contact/facet_neighbours.h>
#include <coapt/contact/facet_overlap.h>
#include <coapt/contact/facet_search.h>
#include <coapt/geometry/simplex_mesh.h>

#include <mpi.h>

#include <vector>

namespace coapt
{
  /** The outer facets of a mesh, by their nodes, such that area_normal() points
   * outwards. */
  template <int dim>
  std::vector<std::array<unsigned int, dim>>
  outer_facets(const SimplexMesh<dim> &mesh);

  /**
   * Contact of facets of a solid, of one body with another or with itself, as
   * an impulse on the velocities after each completed step.
   *
   * Each facet looks along its normal for facets that face it, and a pressure
   * that follows the law of contact (contact_pressure()) acts on both along
   * this normal, integrated over what lies opposite (add_overlap()). So a
   * facet that slides over an edge loses its load little by little, and
   * nothing hooks there. Each facet has a turn, with half of the weight: two
   * passes.
   *
   * Neighbours (FacetNeighbours), such as the sides of an edge and what lies
   * opposite within the solid, never touch.
   *
   * Friction (contact_shear()) is that of the nodes, with the means of
   * pressure, normal and sliding velocity over what they touch; its traction
   * is interpolated between them. Normal forces conserve momentum and its
   * moment; those of friction act on both surfaces a gap apart, and the couple
   * of that is left out.
   *
   * Contact has no stable step of its own: the stiffness follows the step and
   * the least areal mass of all nodes. It is the same everywhere, since under a
   * uniform pressure different ones would bend the surfaces.
   *
   * The facets are divided among the ranks and their impulses summed, so that
   * the replicated velocities stay the same on all ranks. In 2D, forces and
   * masses are per thickness, and areas are lengths.
   */
  template <int dim>
  class FacetContact
  {
  public:
    /**
     * @p facets are what may touch, with normals outwards: outer_facets() or
     * some of them. @p nodal_mass holds the mass of each node (kg); nodes in @p
     * held (all of its size n_nodes) keep their velocity. What is deeper below
     * a surface than @p depth (m) does not touch it; less than the thickness of
     * the thinnest part. Throws InputError if sizes do not fit.
     */
    FacetContact(const SimplexMesh<dim> &mesh,
                 const std::vector<std::array<unsigned int, dim>> &facets,
                 const std::vector<double> &nodal_mass,
                 const std::vector<bool> &held,
                 const ContactParameters &parameters,
                 const double depth,
                 MPI_Comm communicator);

    /** What happened in a step; the same on all ranks. */
    struct Result
    {
      double normal_force   = 0; // N, sum of the magnitudes, one side
      double friction_power = 0; // W, work on the solid / step
      double normal_power   = 0; // W
      unsigned int pairs    = 0; // of facets, each counted from both sides
    };

    /**
     * Changes the velocities @p V (m/s) of the step of length @p dt (s) that
     * has just ended at positions @p X (m), dim values for each node and the
     * same on all ranks. Collective. Throws NumericalError if a position is
     * not finite.
     */
    Result
    apply_impulse(const double *X, double *V, const double dt);

    /** Pressure at each node (Pa): force over area, both shared among the
     * corners of the facets that touch. Zero where nothing touches. After the
     * last apply_impulse(); the same on all ranks. */
    const std::vector<double> &
    pressure() const;

    /** Saves or restores what friction remembers, the same on all ranks. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &histories;
    }

  private:
    using Vector = dealii::Tensor<1, dim>;

    /** A point where a facet and its partner touch. */
    struct Touch
    {
      unsigned int facet, partner;
      OverlapPoint<dim> point;
      Vector normal;
      double pressure;
    };

    /** Integrals over what a node touches, by its shape function, and its share
     * of the facets that touch. */
    struct NodeSums
    {
      double area = 0, pressure = 0, slope = 0, share = 0;
      Vector normal, sliding;
      static constexpr unsigned int n_numbers = 4 + 2 * dim;
    };

    /** Unit normal of a facet and, in the overlap, what of the other one lies
     * on it if it faces this one. */
    Vector
    find_overlap(const unsigned int facet, const unsigned int partner);

    void
    find_touches(const double *V, const double dt);

    /** Returns whether the facets touch. */
    bool
    touch(const unsigned int facet,
          const unsigned int partner,
          const double *V,
          const double dt);

    void
    find_shear(const double dt);

    Result
    apply(double *V, const double dt);

    Vector
    velocity(const unsigned int facet,
             const std::array<double, dim> &weights,
             const double *V) const;

    std::array<dealii::Point<dim>, dim>
    corners(const unsigned int facet) const;

    const ContactParameters parameters;
    const double depth;
    const MPI_Comm communicator;
    const PressureLaw law;
    std::vector<std::array<unsigned int, dim>> facets;
    std::vector<double> inverse_mass; // by node, 1/kg; zero: held
    double areal_mass; // of a pair in which both sides are the lightest, kg/m^2
    std::vector<unsigned int> own;
    FacetSearch<dim> search;
    FacetNeighbours<dim> neighbours;

    std::vector<dealii::Point<dim>> points;
    std::vector<OverlapPoint<dim>> overlap; // scratch
    std::vector<Touch> touches;             // of the own facets
    unsigned int n_pairs = 0;               // of this rank
    std::vector<NodeSums> sums;
    std::vector<ElasticSlip<dim>> histories;
    std::vector<Vector> shear; // Pa, by node
    std::vector<double> nodal_pressure;
  };
} // namespace coapt

#endif
