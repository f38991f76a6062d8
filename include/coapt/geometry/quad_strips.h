#ifndef coapt_geometry_quad_strips_h
#define coapt_geometry_quad_strips_h

#include <array>
#include <vector>

namespace coapt
{
  /**
   * A strip of quadrilaterals (also called a chord): each is entered through
   * one edge and left through the opposite one. It ends at the boundary of the
   * surface or closes.
   */
  struct QuadStrip
  {
    /** One quadrilateral of the strip. */
    struct Crossing
    {
      unsigned int quad;

      /** 0 if the strip runs along the edge of vertices 0 and 1 and that of 3
       * and 2, and 1 if it runs along that of 1 and 2 and that of 0 and 3. */
      unsigned int direction;

      /** Whether it runs from vertex 1 to 0, or from 2 to 1. */
      bool is_reversed;
    };

    std::vector<Crossing> crossings;
    bool is_closed = false;
  };

  /**
   * All strips of a surface of @p quads (vertex numbers, going round). Each
   * quadrilateral is in one strip of each direction; a strip may cross itself.
   * An edge of more than two quadrilaterals counts as boundary.
   */
  std::vector<QuadStrip>
  quad_strips(const std::vector<std::array<unsigned int, 4>> &quads);
} // namespace coapt

#endif
