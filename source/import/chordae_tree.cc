#include <coapt/base/exceptions.h>
#include <coapt/chordae/attachment.h>
#include <coapt/import/chordae_tree.h>
#include <coapt/import/segments.h>

#include <cmath>
#include <sstream>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    /** Throws if ends of segments hang free, or held numbers do not exist. */
    void
    check_ends(const ChordaeSegments &segments,
               const std::set<long> &held,
               const std::string &file)
    {
      for (const long number : held)
        {
          const auto node = segments.nodes.find(number);
          if (node == segments.nodes.end())
            throw InputError(file + ": there is no node " +
                             std::to_string(number) + ", which is to be held");
          if (node->second.vertex >= 0)
            throw InputError(file + ": node " + std::to_string(number) +
                             " is to be held, but attached to vertex " +
                             std::to_string(node->second.vertex));
        }
      std::ostringstream list;
      unsigned int n_bad = 0;
      for (const auto &[number, node] : segments.nodes)
        if (node.segments.size() == 1 && node.vertex < 0 &&
            held.count(number) == 0 && ++n_bad <= 10)
          list << (n_bad > 1 ? "; " : "") << number << " at ("
               << 1e3 * node.position << ") mm";
      if (n_bad > 0)
        throw InputError(file + ": " + std::to_string(n_bad) +
                         " nodes are attached to nothing: they end one "
                         "segment, but have no vertex and are not held: " +
                         list.str() + (n_bad > 10 ? "; ..." : ""));
    }
  } // namespace



  ChordaeTree::ChordaeTree(const std::string &file,
                           const double unit,
                           const std::set<long> &held,
                           const std::vector<Point<3>> &vertices)
  {
    const ChordaeSegments segments = read_segments(file, unit, vertices);
    check_ends(segments, held, file);
    std::map<long, unsigned int> remaining;
    for (const auto &[number, node] : segments.nodes)
      if (node.segments.size() != 2 || node.vertex >= 0 ||
          held.count(number) > 0)
        {
          remaining[number] = all_nodes.size();
          all_nodes.push_back(
            {number, node.position, node.vertex, held.count(number) > 0});
        }

    std::vector<bool> is_used(segments.segments.size(), false);
    for (const auto &[number, start] : remaining)
      for (const unsigned int first : segments.nodes.at(number).segments)
        {
          if (is_used[first])
            continue;
          double length = 0, compliance = 0;
          long at        = number;
          unsigned int s = first;
          while (true)
            {
              const auto &segment = segments.segments[s];
              is_used[s]          = true;
              length += segment.length;
              compliance += segment.length / segment.area;
              at = segment.ends[segment.ends[0] == at ? 1 : 0];
              if (remaining.count(at) > 0)
                break;
              const auto &both = segments.nodes.at(at).segments;
              s                = both[both[0] == s ? 1 : 0];
            }
          if (at != number) // a loop would pull on nothing
            all_strings.push_back(
              {{{start, remaining[at]}}, length, length / compliance});
        }
  }



  void
  ChordaeTree::move(const dealii::Tensor<1, 3> &way)
  {
    for (Node &node : all_nodes)
      node.position += way;
  }



  unsigned int
  ChordaeTree::leaflet_node_of(const long number) const
  {
    for (unsigned int i = 0; i < all_nodes.size(); ++i)
      if (all_nodes[i].number == number)
        return leaflet_node[i];
    return dealii::numbers::invalid_unsigned_int;
  }



  void
  ChordaeTree::add_nodes(const double density, Leaflet &leaflet)
  {
    std::vector<double> mass(all_nodes.size(), 0.);
    for (const String &string : all_strings)
      for (const unsigned int end : string.ends)
        if (!all_nodes[end].is_held)
          mass[end] += 0.5 * density * string.area * string.length;
    leaflet_node.assign(all_nodes.size(),
                        dealii::numbers::invalid_unsigned_int);
    for (unsigned int i = 0; i < all_nodes.size(); ++i)
      {
        if (all_nodes[i].vertex >= 0)
          continue;
        leaflet_node[i] = leaflet.mesh.points.size();
        leaflet.mesh.points.push_back(all_nodes[i].position);
        leaflet.pinned.push_back(all_nodes[i].is_held);
        leaflet.chordae_mass.push_back(mass[i]);
      }
  }



  std::vector<bool>
  ChordaeTree::strings_of_anterior(const Leaflet &leaflet) const
  {
    std::vector<bool> is_anterior(leaflet.columns.size(), false);
    for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
      if (leaflet.quad_region[q] == Region::anterior)
        for (const unsigned int column : leaflet.quads[q])
          is_anterior[column] = true;

    std::vector<bool> node(all_nodes.size(), false);
    for (unsigned int i = 0; i < all_nodes.size(); ++i)
      node[i] = all_nodes[i].vertex >= 0 && is_anterior[all_nodes[i].vertex];
    const auto joins = [&](const unsigned int i) {
      return all_nodes[i].vertex < 0 && !all_nodes[i].is_held;
    };
    for (bool changes = true; changes;)
      {
        changes = false;
        for (const String &string : all_strings)
          for (unsigned int e = 0; e < 2; ++e)
            if (node[string.ends[e]] && !node[string.ends[1 - e]] &&
                joins(string.ends[1 - e]))
              changes = node[string.ends[1 - e]] = true;
      }
    std::vector<bool> result;
    for (const String &string : all_strings)
      result.push_back(node[string.ends[0]] || node[string.ends[1]]);
    return result;
  }



  std::vector<Chorda>
  ChordaeTree::chordae(const Leaflet &leaflet,
                       const std::vector<double> &nodal_mass,
                       const double modulus,
                       const double length_factor,
                       const double radius) const
  {
    const unsigned int n_tissue =
      leaflet.mesh.points.size() - leaflet.chordae_mass.size();
    const std::vector<Point<3>> tissue(leaflet.mesh.points.begin(),
                                       leaflet.mesh.points.begin() + n_tissue);
    const auto middle = [&](const int vertex) {
      const auto &column = leaflet.columns[vertex];
      return column[column.size() / 2];
    };
    const std::vector<bool> is_anterior = strings_of_anterior(leaflet);
    std::vector<Chorda> result;
    for (unsigned int i = 0; i < all_strings.size(); ++i)
      {
        const String &string = all_strings[i];
        // The end on the leaflet, if there is one, is the one attached.
        const unsigned int attached =
          all_nodes[string.ends[0]].vertex >= 0 ? 0 : 1;
        const unsigned int at   = string.ends[attached],
                           from = string.ends[1 - attached];
        const Node &end = all_nodes[at], &origin = all_nodes[from];
        Chorda chorda;
        chorda.id =
          std::to_string(origin.number) + "-" + std::to_string(end.number);
        chorda.diameter = std::sqrt(string.area / dealii::numbers::PI_4);
        chorda.modulus  = modulus;
        chorda.tip      = origin.position;
        chorda.origin_node =
          origin.vertex >= 0 ? middle(origin.vertex) : leaflet_node[from];
        if (end.vertex >= 0)
          {
            chorda.chorda_class = is_anterior[i]
              ? ChordaClass::anterior_primary
              : ChordaClass::posterior_primary;
            attach(chorda,
                   tissue,
                   nodal_mass,
                   tissue[leaflet.columns[end.vertex].front()] +
                     0.5 *
                       (tissue[leaflet.columns[end.vertex].back()] -
                        tissue[leaflet.columns[end.vertex].front()]),
                   radius);
          }
        else
          {
            chorda.chorda_class = is_anterior[i]
              ? ChordaClass::anterior_secondary
              : ChordaClass::posterior_secondary;
            chorda.nodes        = {leaflet_node[at]};
            chorda.weights      = {1.};
          }
        // The mean of the nodes that are held is not quite the vertex.
        Point<3> held;
        for (unsigned int k = 0; k < chorda.nodes.size(); ++k)
          held += chorda.weights[k] * leaflet.mesh.points[chorda.nodes[k]];
        chorda.open_length = origin.position.distance(held);
        chorda.rest_length = length_factor *
          (string.length + chorda.open_length -
           origin.position.distance(end.position));
        result.push_back(chorda);
      }
    return result;
  }
} // namespace coapt
