#ifndef coapt_geometry_coupling_lattice_h
#define coapt_geometry_coupling_lattice_h

#include <coapt/geometry/leaflet.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace coapt
{
  /** A material point of a solid, with the volume that it stands for. */
  template <int dim>
  struct SamplePoint
  {
    /** Cell of the mesh, and barycentric coordinates (in [0,1], of sum one)
     * in the order of its nodes. */
    unsigned int cell = 0;
    std::array<double, dim + 1> barycentric{};

    /** Reference volume (m^3; m^2 in 2D). */
    double volume = 0;

    /** Unit normal of the surface that the point lies on, in the reference,
     * towards the fluid; zero for points that couple a volume. */
    dealii::Tensor<1, dim> outwards;

    /** Surface quadrilateral of a leaflet; invalid for other meshes. */
    unsigned int quad = dealii::numbers::invalid_unsigned_int;

    /** Place in the thickness of a leaflet: 0 atrial, 1 ventricular. */
    double depth = 0.5;
  };

  /**
   * A lattice of points that fills a leaflet: lines across each strip of
   * quadrilaterals, at equal distances over the whole strip, and points where
   * the lines of two strips cross, no further apart than @p spacing /
   * @p stretch in the reference and so than @p spacing (m) under an in-plane
   * stretch up to @p stretch; times max(@p min_layers, ceil(thickness /
   * @p spacing)) layers. Since numbers are rounded once a strip and not once a
   * quadrilateral, the elements hardly matter. The volumes add up to that of
   * the mesh. Points are ordered by quadrilateral.
   */
  std::vector<SamplePoint<3>>
  leaflet_lattice(const Leaflet &leaflet,
                  double spacing,
                  double stretch          = 1.35,
                  unsigned int min_layers = 2);

  /** Points of two densities for the same solid. */
  template <int dim>
  struct NestedLattice
  {
    /** The dense points, then those that stand for a group of them each: at
     * their centre, with their volume. */
    std::vector<SamplePoint<dim>> points;

    /** For each dense point, the number of the one that stands for its group.
     */
    std::vector<unsigned int> stand_in;
  };

  /**
   * leaflet_lattice(), and points for fluid cells twice as large: one for each
   * group of up to 2 x 2 lines of a quadrilateral (an odd one at the end of u
   * or v, so not symmetric) and two layers of the same half of the thickness
   * (of one layer if fewer than @p min_layers would stay).
   */
  NestedLattice<3>
  nested_leaflet_lattice(const Leaflet &leaflet,
                         double spacing,
                         double stretch          = 1.35,
                         unsigned int min_layers = 2);

  /**
   * Points that fill any mesh: each simplex is cut into n^dim parts of equal
   * volume (n such that its longest edge / n <= @p spacing) as Freudenthal
   * (1942) cuts a cube, with a point at the centroid of each.
   */
  template <int dim>
  std::vector<SamplePoint<dim>>
  simplex_lattice(const SimplexMesh<dim> &mesh, double spacing);

  /** How far (m) points of simplex_lattice() in neighbouring parts can be from
   * each other, at most, when the nodes of the mesh are at @p positions: 2/3 of
   * the longest edge of a part in two dimensions, 1/2 in three. */
  template <int dim>
  double
  deformed_spacing(const SimplexMesh<dim> &mesh,
                   double spacing,
                   const std::vector<dealii::Point<dim>> &positions);

  /**
   * Points on the surface of any mesh, for a body that is several fluid cells
   * thick: none nearer to another than @p spacing (m), and none of the surface
   * further away from all than that. In two dimensions they follow each curve
   * of the boundary in equal steps (boundary_curves()), and lie the same above
   * and below the axis of a body along x: points that do not, bend the flow.
   * Each stands for the part of the surface that is nearest to it, with a layer
   * of @p depth (m) below it, and knows the normal of the surface.
   *
   * Where a body's interior is coupled, too, the fluid's nodes around it are
   * all fixed, whatever the place of the surface between them; a surface with
   * about one point in each cell leaves the velocity across it linear, and the
   * flow feels displacements far below a cell (compare the spacing of markers
   * in Uhlmann 2005, section 3).
   */
  template <int dim>
  std::vector<SamplePoint<dim>>
  surface_lattice(const SimplexMesh<dim> &mesh, double spacing, double depth);

  /** Throws InputError unless the @p spacing (m) of points is positive. */
  void
  check_point_spacing(double spacing);
} // namespace coapt

#endif
