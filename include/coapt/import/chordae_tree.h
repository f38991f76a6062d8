#ifndef coapt_import_chordae_tree_h
#define coapt_import_chordae_tree_h

#include <coapt/chordae/chorda.h>
#include <coapt/geometry/leaflet.h>

#include <set>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * Chordae that branch, from a file of straight segments. Segments between
   * two branchings, attachments or held ends become one string, which pulls as
   * soon as it is longer than they are together, and as stiff as they are one
   * after the other. Branchings are nodes with the mass of half of each
   * string; the held ends are nodes without a mass.
   */
  class ChordaeTree
  {
  public:
    /** A node that remains. */
    struct Node
    {
      long number; ///< in the file
      dealii::Point<3> position;
      int vertex; ///< of the surface, or -1
      bool is_held;
    };

    /** A string between two nodes, by their places in nodes(). */
    struct String
    {
      std::array<unsigned int, 2> ends;
      double length, area; // m, m^2
    };

    /** No chordae. */
    ChordaeTree() = default;

    /**
     * Reads the @p file, a CSV with the columns of Import/Chordae; lengths but
     * for the diameter are multiplied by @p unit. The nodes with the numbers
     * @p held are held; @p vertices are the positions of the surface (m).
     *
     * @throws InputError with file, line and column if a column is missing or
     * a cell no number, if a diameter or length is not positive, if a vertex
     * does not exist or is farther than 2 mm from the end attached to it, if a
     * node has two positions, and if an end of a segment is neither attached,
     * nor held, nor continued (the first ten are listed).
     */
    ChordaeTree(const std::string &file,
                const double unit,
                const std::set<long> &held,
                const std::vector<dealii::Point<3>> &vertices);

    const std::vector<Node> &
    nodes() const
    {
      return all_nodes;
    }

    const std::vector<String> &
    strings() const
    {
      return all_strings;
    }

    /** Moves all nodes by @p way (m). */
    void
    move(const dealii::Tensor<1, 3> &way);

    /** Adds branchings and held ends to the leaflet's nodes; a string of the
     * @p density (kg/m^3) gives half of its mass to each end. */
    void
    add_nodes(const double density, Leaflet &leaflet);

    /** Number of the node @p number of the file among those of the leaflet,
     * after add_nodes(). */
    unsigned int
    leaflet_node_of(const long number) const;

    /**
     * The strings as chordae, after add_nodes(): of Young's modulus @p modulus
     * (Pa), pulling from @p length_factor of their length on; on the leaflet
     * they hold the nodes within @p radius (m) around the middle of the column.
     * Those on the leaflet are classed as primary, the others as secondary.
     */
    std::vector<Chorda>
    chordae(const Leaflet &leaflet,
            const std::vector<double> &nodal_mass,
            const double modulus,
            const double length_factor,
            const double radius) const;

  private:
    /** Whether a string ends on the anterior leaflet, directly or through
     * others. */
    std::vector<bool>
    strings_of_anterior(const Leaflet &leaflet) const;

    std::vector<Node> all_nodes;
    std::vector<String> all_strings;

    /** Number of each node among those of the leaflet, if it has been added. */
    std::vector<unsigned int> leaflet_node;
  };
} // namespace coapt

#endif
