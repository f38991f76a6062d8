#ifndef coapt_import_surface_mesh_h
#define coapt_import_surface_mesh_h

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * A surface of quadrilaterals. Neighbours go round in the same sense.
   */
  struct SurfaceMesh
  {
    /** Positions of the vertices (m), those of the file first. */
    std::vector<dealii::Point<3>> points;

    /** Corners of each quadrilateral. */
    std::vector<std::array<unsigned int, 4>> quads;

    /** Physical label of each quadrilateral, and number of the element of the
     * file that it is, or is a part of. @{ */
    std::vector<int> labels;
    std::vector<unsigned int> elements;
    /** @} */

    /** Number of elements and vertices of the file. @{ */
    unsigned int n_elements = 0;
    unsigned int n_vertices = 0;
    /** @} */

    /** Ends of the edge that each vertex beyond those of the file is the
     * middle of; the same number twice for the middle of an element. */
    std::vector<std::array<unsigned int, 2>> added_vertices;
  };

  /** Edges that belong to one quadrilateral only. */
  std::vector<std::array<unsigned int, 2>>
  boundary_edges(const std::vector<std::array<unsigned int, 4>> &quads);

  /**
   * Reads a surface in Gmsh's format 2.2 (ASCII); lengths are multiplied by
   * @p unit. If there are triangles, each is cut into three quadrilaterals
   * around its centre, and each quadrilateral then into four, so that they
   * fit. The sense of rotation is made the same all over the surface.
   *
   * @throws InputError if the file cannot be read or holds something else, if a
   * vertex belongs to no element (their number is told), if an edge belongs to
   * more than two elements, or if the surface has one side only.
   */
  SurfaceMesh
  read_surface_mesh(const std::string &file, const double unit);
} // namespace coapt

#endif
