#ifndef coapt_chordae_chorda_h
#define coapt_chordae_chorda_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <string>
#include <vector>

namespace coapt
{
  /** Which leaflet a chorda holds, and where. */
  enum class ChordaClass : unsigned int
  {
    anterior_primary    = 0,
    anterior_secondary  = 1,
    posterior_primary   = 2,
    posterior_secondary = 3
  };

  /**
   * A tension-only string from a papillary tip to the leaflet, where it acts
   * on all nodes within a sphere of influence (a ball joint). In a tree of
   * chordae either end may be a node of its own.
   */
  struct Chorda
  {
    /** Name by which a parameter file removes it, e.g. "R-P3". */
    std::string id;

    ChordaClass chorda_class = ChordaClass::anterior_primary;

    /** Diameter (m) and Young's modulus (Pa). */
    double diameter = 0;
    double modulus  = 0;

    /** Length at which tension begins (m); open length in the reference. */
    double rest_length = 0;
    double open_length = 0;

    /** Papillary tip (m) in the reference. */
    dealii::Point<3> tip;

    /** Node that the tip is, if it can move. */
    unsigned int origin_node = dealii::numbers::invalid_unsigned_int;

    /** Nodes in the sphere of influence, and their weights, of sum one. */
    std::vector<unsigned int> nodes;
    std::vector<double> weights;
  };
} // namespace coapt

#endif
