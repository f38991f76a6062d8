#include <deal.II/base/numbers.h>

#include <coapt/base/csv_table.h>
#include <coapt/base/exceptions.h>
#include <coapt/base/units.h>
#include <coapt/import/segments.h>

#include <cmath>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** The columns of one end of all segments. */
    struct End
    {
      End(const CsvTable &table, const std::string &which)
        : node(table.numbers("node" + which))
        , vertex(table.numbers("vertex" + which))
        , x{{table.numbers("x" + which),
             table.numbers("y" + which),
             table.numbers("z" + which)}}
      {
      }

      std::vector<double> node, vertex;
      std::array<std::vector<double>, 3> x;
    };

    /** Enters an end in the list of nodes. */
    void
    add_node(const End &end,
             const unsigned int row,
             const double unit,
             const std::vector<Point<3>> &vertices,
             const std::string &place,
             ChordaeSegments &result)
    {
      const Point<3> x(unit * end.x[0][row],
                       unit * end.x[1][row],
                       unit * end.x[2][row]);
      const double vertex = end.vertex[row];
      if (vertex != std::floor(vertex) || vertex < -1 ||
          vertex >= vertices.size())
        throw InputError(place + ": there is no vertex " +
                         std::to_string(vertex) + "; allowed are 0 to " +
                         std::to_string(vertices.size() - 1) +
                         " and -1 for none");
      if (vertex >= 0 && x.distance(vertices[vertex]) > 2 * units::millimetre)
        throw InputError(
          place + ": the end is " +
          std::to_string(x.distance(vertices[vertex]) / units::millimetre) +
          " mm away from vertex " + std::to_string(int(vertex)) +
          "; allowed are 2 mm");
      if (end.node[row] != std::floor(end.node[row]) ||
          std::abs(end.node[row]) >= 1e9)
        throw InputError(place + ": node " + std::to_string(end.node[row]) +
                         " is not a whole number of less than ten digits");
      const auto [node, is_new] =
        result.nodes.try_emplace(std::lround(end.node[row]));
      if (is_new)
        {
          node->second.position = x;
          node->second.vertex   = vertex;
        }
      else if (node->second.position.distance(x) > 1e-6 ||
               node->second.vertex != vertex)
        throw InputError(place + ": node " + std::to_string(node->first) +
                         " has another position or vertex before");
      node->second.segments.push_back(result.segments.size());
    }
  } // namespace



  ChordaeSegments
  read_segments(const std::string &file,
                const double unit,
                const std::vector<Point<3>> &vertices)
  {
    const CsvTable table(file);
    const End ends[2]    = {End(table, "1"), End(table, "2")};
    const auto diameters = table.numbers("diameter_mm");
    ChordaeSegments result;
    for (unsigned int i = 0; i < table.n_rows(); ++i)
      {
        for (const End &end : ends)
          add_node(end, i, unit, vertices, table.place(i), result);
        ChordaeSegments::Segment segment;
        for (unsigned int e = 0; e < 2; ++e)
          segment.ends[e] = std::lround(ends[e].node[i]);
        segment.length = result.nodes[segment.ends[0]].position.distance(
          result.nodes[segment.ends[1]].position);
        const double diameter = diameters[i] * units::millimetre;
        segment.area          = dealii::numbers::PI_4 * diameter * diameter;
        if (!(segment.length > 0 && diameter > 0))
          throw InputError(table.place(i) + ": length " +
                           std::to_string(segment.length * 1e3) +
                           " mm, diameter " + std::to_string(diameter * 1e3) +
                           " mm; both must be positive");
        result.segments.push_back(segment);
      }
    return result;
  }
} // namespace coapt
