#ifndef coapt_import_segments_h
#define coapt_import_segments_h

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace coapt
{
  /** Straight segments of chordae, as a file has them. */
  struct ChordaeSegments
  {
    struct Node
    {
      dealii::Point<3> position; // m
      int vertex = -1;           // of the surface
      std::vector<unsigned int> segments;
    };

    struct Segment
    {
      std::array<long, 2> ends;
      double length, area; // m, m^2
    };

    /** Nodes by their numbers. */
    std::map<long, Node> nodes;

    std::vector<Segment> segments;
  };

  /** Reads segments; see ChordaeTree for arguments and errors. */
  ChordaeSegments
  read_segments(const std::string &file,
                const double unit,
                const std::vector<dealii::Point<3>> &vertices);
} // namespace coapt

#endif
