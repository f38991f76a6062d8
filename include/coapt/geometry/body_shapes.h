#ifndef coapt_geometry_body_shapes_h
#define coapt_geometry_body_shapes_h

#include <coapt/geometry/simplex_mesh.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace coapt
{
  /** A body of simple shape with what its shape gives besides cells. */
  template <int dim>
  struct ShapedBody
  {
    SimplexMesh<dim> mesh;

    /** A unit vector in each cell: around the centre of a disc or ring, along
     * a strip. */
    std::vector<dealii::Tensor<1, dim>> fibre;

    /** The two faces of a strip, as simplices with normals that have no
     * negative component along x; empty for other shapes. */
    std::vector<std::array<unsigned int, dim>> lower_face, upper_face;
  };

  /** A disc of triangles in concentric rings; edges of about @p size, lengths
   * in m. Its boundary is a polygon. */
  ShapedBody<2>
  disc_body(const dealii::Point<2> &center,
            const double radius,
            const double size);

  /** A ring of triangles. */
  ShapedBody<2>
  ring_body(const dealii::Point<2> &center,
            const double inner_radius,
            const double width,
            const double size);

  /** A strip or plate; lengths in m. */
  template <int dim>
  struct StripShape
  {
    /** Ends of the middle line; in 3D at the lower z. */
    dealii::Point<2> begin, end;

    /** Vector through the thickness. */
    dealii::Tensor<1, 2> thickness;

    /** Deflection of the middle along the thickness, a parabola. */
    double bow = 0;

    /** Extent in z, in 3D. */
    double z_lower = 0, z_upper = 0;
  };

  /**
   * A strip of quadrilaterals, each cut into four triangles by its diagonals;
   * in 3D a plate of hexahedra, cut into six tetrahedra each.
   *
   * A @p quadratic one has quadratic elements on nodes at the same distances:
   * each block of two quadrilaterals (hexahedra) in every direction is cut in
   * the same way, so there are as many blocks as fit best, at least one.
   */
  template <int dim>
  ShapedBody<dim>
  strip_body(const StripShape<dim> &shape,
             const double size,
             const bool quadratic = false);

  /** Both bodies as one mesh; both of linear elements, or both of quadratic
   * ones. */
  template <int dim>
  void
  append(ShapedBody<dim> &body, const ShapedBody<dim> &other);

  /** Volume (m^3, in 2D m^2) between a face with nodes at @p X and the plane x
   * = 0, positive where the normal points along x. */
  template <int dim>
  double
  volume_behind(const std::vector<std::array<unsigned int, dim>> &face,
                const std::vector<double> &X);
} // namespace coapt

#endif
