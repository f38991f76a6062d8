#ifndef coapt_laboratory_sheet_h
#define coapt_laboratory_sheet_h

#include <coapt/geometry/simplex_mesh.h>

#include <array>
#include <vector>

namespace coapt
{
  /**
   * A square sheet of tetrahedra between 0 and its side in x and y, and between
   * 0 and its thickness in z. The sides at zero glide along the planes of
   * coordinates, as does the face z = 0: this leaves a homogeneous deformation
   * free and excludes rigid motion.
   */
  struct Sheet
  {
    /** Lengths in m; @p n_elements boxes along each side and @p n_layers
     * across, each of six tetrahedra (Kuhn). */
    Sheet(const double side,
          const double thickness,
          const unsigned int n_elements,
          const unsigned int n_layers);

    /** Area (m^2) of a side. */
    double
    side_area() const
    {
      return side * thickness;
    }

    double side, thickness;
    SimplexMesh<3> mesh;

    /** Nodes on the planes where coordinate 0, 1 or 2 is zero. */
    std::array<std::vector<unsigned int>, 3> held;

    /** Nodes on the two sides that are pulled. */
    std::array<std::vector<unsigned int>, 2> pulled;

    /** Part of the side's area (m^2) that each of these nodes stands for. */
    std::array<std::vector<double>, 2> pulled_area;
  };
} // namespace coapt

#endif
