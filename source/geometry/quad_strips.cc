#include <coapt/geometry/quad_strips.h>

#include <algorithm>
#include <map>
#include <utility>

namespace coapt
{
  namespace
  {
    using Crossing = QuadStrip::Crossing;

    /** An edge of a quadrilateral, from its vertex of that number to the next.
     */
    struct Side
    {
      unsigned int quad, edge;
    };

    class StripFinder
    {
    public:
      explicit StripFinder(
        const std::vector<std::array<unsigned int, 4>> &quads)
        : quads(quads), is_taken(quads.size(), {{false, false}})
      {
        for (unsigned int q = 0; q < quads.size(); ++q)
          for (unsigned int edge = 0; edge < 4; ++edge)
            sides[vertices({q, edge})].push_back({q, edge});
      }

      std::vector<QuadStrip>
      find()
      {
        std::vector<QuadStrip> strips;
        for (unsigned int q = 0; q < quads.size(); ++q)
          for (unsigned int direction = 0; direction < 2; ++direction)
            if (!is_taken[q][direction])
              strips.push_back(strip_through({q, direction, false}));
        return strips;
      }

    private:
      std::pair<unsigned int, unsigned int>
      vertices(const Side &side) const
      {
        return std::minmax(quads[side.quad][side.edge],
                           quads[side.quad][(side.edge + 1) % 4]);
      }

      /** The side through which a crossing leaves its quadrilateral. */
      static Side
      exit(const Crossing &crossing)
      {
        const unsigned int end = crossing.direction == 0 ? 1 : 2;
        return {crossing.quad, crossing.is_reversed ? (end + 2) % 4 : end};
      }

      static Crossing
      entered_by(const Side &side)
      {
        return {side.quad,
                side.edge % 2 == 1 ? 0u : 1u,
                side.edge == 1 || side.edge == 2};
      }

      static Crossing
      turned(const Crossing &crossing)
      {
        return {crossing.quad, crossing.direction, !crossing.is_reversed};
      }

      /** Appends what follows on @p first and is in no strip yet. Returns
       * whether it ends at a quadrilateral instead of at the boundary. */
      bool
      follow(const Crossing &first, std::vector<Crossing> &crossings)
      {
        Crossing last = first;
        while (true)
          {
            const Side side        = exit(last);
            const auto &neighbours = sides.at(vertices(side));
            if (neighbours.size() != 2)
              return false;
            last = entered_by(neighbours[neighbours[0].quad == side.quad &&
                                         neighbours[0].edge == side.edge]);
            if (is_taken[last.quad][last.direction])
              return true;
            is_taken[last.quad][last.direction] = true;
            crossings.push_back(last);
          }
      }

      QuadStrip
      strip_through(const Crossing &start)
      {
        is_taken[start.quad][start.direction] = true;
        QuadStrip strip;
        std::vector<Crossing> after, before;
        strip.is_closed = follow(start, after);
        if (!strip.is_closed)
          follow(turned(start), before);
        for (auto crossing = before.rbegin(); crossing != before.rend();
             ++crossing)
          strip.crossings.push_back(turned(*crossing));
        strip.crossings.push_back(start);
        strip.crossings.insert(strip.crossings.end(),
                               after.begin(),
                               after.end());
        return strip;
      }

      const std::vector<std::array<unsigned int, 4>> &quads;
      std::map<std::pair<unsigned int, unsigned int>, std::vector<Side>> sides;
      std::vector<std::array<bool, 2>> is_taken;
    };
  } // namespace



  std::vector<QuadStrip>
  quad_strips(const std::vector<std::array<unsigned int, 4>> &quads)
  {
    return StripFinder(quads).find();
  }
} // namespace coapt
