#ifndef coapt_contact_mid_surface_h
#define coapt_contact_mid_surface_h

#include <coapt/geometry/leaflet.h>

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * The mid-surface of a leaflet: one point a column, two triangles a
   * quadrilateral, with the masses by which its columns answer to forces.
   *
   * Position and velocity of a column are weighted means through the
   * thickness, and a force on the column goes to its nodes by the same weights:
   * it acts where the column is, and its power is force times velocity. The
   * weights are those with their mean in the middle of the thickness for which
   * the nodes' accelerations differ least: these are linear through the
   * thickness, and all alike if the masses are symmetric. With the trapezoidal
   * rule a light node at a corner would be kicked away.
   */
  class MidSurface
  {
  public:
    /**
     * @p nodal_mass holds the mass of each node (kg). Throws InputError if its
     * size does not fit, if a column has fewer than two nodes or another
     * number of nodes than the first, or if a node has no mass.
     */
    MidSurface(const Leaflet &leaflet, const std::vector<double> &nodal_mass);

    unsigned int
    n_columns() const;

    /** Corners of the triangles by column, ordered like the quadrilaterals. */
    const std::vector<std::array<unsigned int, 3>> &
    triangles() const;

    /** The quadrilaterals by column. */
    const std::vector<std::array<unsigned int, 4>> &
    quadrilaterals() const;

    /** The numbers of the quadrilaterals that have the @p column as a
     * corner. */
    const std::vector<unsigned int> &
    quadrilaterals_around(const unsigned int column) const
    {
      return around[column];
    }

    /** Positions of all columns (m) for the nodal triples @p X, into @p points
     * of size n_columns(). */
    void
    positions(const double *X, std::vector<dealii::Point<3>> &points) const;

    /** Mean through the thickness of nodal triples, for example velocity
     * (m/s), in a column. */
    dealii::Tensor<1, 3>
    average(const unsigned int column, const double *V) const;

    /** Area of each column (m^2): a quarter of its quadrilaterals. */
    void
    areas(const std::vector<dealii::Point<3>> &points,
          std::vector<double> &areas) const;

    /** Mid-surface velocity that a unit impulse on the column leaves (1/kg):
     * one over the column's mass if its masses are symmetric and no node is
     * pinned, zero if all are. */
    double
    inverse_mass(const unsigned int column) const;

    /**
     * Adds @p first plus @p second (N s) to the column's momentum. Returns the
     * work of each of them (J), exactly the change of kinetic energy in sum.
     */
    std::array<double, 2>
    apply_impulse(const unsigned int column,
                  const dealii::Tensor<1, 3> &first,
                  const dealii::Tensor<1, 3> &second,
                  double *V) const;

  private:
    struct Node
    {
      unsigned int number;
      double weight;   // in the mean
      double velocity; // of a unit impulse on the column, 1/kg; zero if pinned
    };

    unsigned int nodes_per_column;
    std::vector<Node> nodes;
    std::vector<double> inverse_masses; // of columns
    std::vector<std::array<unsigned int, 4>> quads;
    std::vector<std::vector<unsigned int>> around; // quadrilaterals of a column
    std::vector<std::array<unsigned int, 3>> corners;
  };
} // namespace coapt

#endif
