#ifndef coapt_geometry_leaflet_h
#define coapt_geometry_leaflet_h

#include <coapt/geometry/simplex_mesh.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace coapt
{
  /** Parts of the valve's surface. */
  enum class Region : unsigned int
  {
    anterior   = 0,
    posterior  = 1,
    commissure = 2,
    root       = 3, // between annulus line and the outer strap
    septal     = 4  // of a tricuspid valve
  };

  /** Number of regions. */
  constexpr unsigned int n_regions = 5;

  /**
   * A leaflet: a surface thickened into solid elements. Nodes come in columns
   * through the thickness, from the atrial to the ventricular side, one column
   * for each vertex of the surface; the surface between the columns consists
   * of quadrilaterals. This holds for generated and for imported surfaces, and
   * is what contact, coupling points and metrics are built on.
   */
  struct Leaflet
  {
    /** The solid mesh (tetrahedra), reference configuration, m. Nodes of
     * chordae may follow those of the columns; they belong to no cell. */
    SimplexMesh<3> mesh;

    /** Mass (kg) of each node of chordae; those without any are held. */
    std::vector<double> chordae_mass;

    /** Nodes of each column, atrial side first, ventricular side last. All
     * columns have the same length, n_layers + 1. */
    std::vector<std::vector<unsigned int>> columns;

    /**
     * Surface quadrilaterals by column number, ordered such that
     * (c2 - c0) x (c3 - c1) points to the *ventricular* side.
     */
    std::vector<std::array<unsigned int, 4>> quads;

    /** Region of each quadrilateral. */
    std::vector<Region> quad_region;

    /** Surface quadrilateral that each cell of the mesh belongs to. */
    std::vector<unsigned int> cell_quad;

    /** Fibre direction of each cell: a unit vector, tangential. */
    std::vector<dealii::Tensor<1, 3>> fibre;

    /** Prestretch F0 of each cell (F_e = F F0), identity if there is none. */
    std::vector<dealii::Tensor<2, 3>> prestretch;

    /** Whether a node is held: its displacement is prescribed, usually zero. */
    std::vector<bool> pinned;

    /** Held nodes by name. */
    std::map<std::string, std::vector<unsigned int>> held_sets;

    /** Columns on the annulus line, in order around the valve. */
    std::vector<unsigned int> annulus_columns;

    /** Columns on the free edge, in order around the valve. */
    std::vector<unsigned int> free_edge_columns;

    /**
     * Coordinates of each column on the unrolled leaflet: angle around the
     * valve (rad, pi/2 at mid-anterior, -pi/2 at mid-posterior), and the
     * fraction of the height, 0 at the annulus, 1 at the free edge, negative
     * in the root.
     */
    std::vector<std::array<double, 2>> column_coordinates;

    /** Thickness (m). */
    double thickness = 0;
  };

  /**
   * Triangles of a mid-surface: each of the @p quads (column numbers) cut
   * along its first diagonal, which keeps the sense of rotation.
   */
  std::vector<std::array<unsigned int, 3>>
  triangulate(const std::vector<std::array<unsigned int, 4>> &quads);
} // namespace coapt

#endif
