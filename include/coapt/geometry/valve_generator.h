#ifndef coapt_geometry_valve_generator_h
#define coapt_geometry_valve_generator_h

#include <coapt/chordae/chorda.h>
#include <coapt/geometry/leaflet.h>
#include <coapt/geometry/valve_parameters.h>

#include <string>
#include <vector>

namespace coapt
{
  /** Point of the annulus (m) at angle @p t (rad). */
  dealii::Point<3>
  annulus_point(const ValveParameters &valve, double t);

  /** Height of the leaflet (m) at angle @p t (rad), annulus to free edge. */
  double
  leaflet_height(const ValveParameters &valve, double t);

  /**
   * Point of the open mid-surface (m) at angle @p t (rad) and fraction @p s of
   * the height; s < 0 continues the leaflet straight beyond the annulus.
   */
  dealii::Point<3>
  open_position(const ValveParameters &valve, double t, double s);

  /**
   * Point of the closed design (m) that the material point (@p t, @p s),
   * 0 <= s <= 1, is meant to reach: straight from the annulus to the top of
   * coaptation, then straight down, at the stretch ValveParameters::
   * closed_stretch. Not an equilibrium: it serves to cut chordae to length and
   * as a shape for tests.
   */
  dealii::Point<3>
  closed_position(const ValveParameters &valve, double t, double s);

  /**
   * Builds the leaflet in its open shape: columns of n_layers + 1 nodes on a
   * grid of n_circumferential by (n_root_rows + n_radial + 1) columns, column
   * number i * (n_root_rows + n_radial + 1) + j for angle i and row j; row 0
   * is the outer rim of the root, row n_root_rows the annulus line. Every
   * brick is cut into five tetrahedra in alternation, which conforms.
   *
   * With quadratic elements, each two bricks in every direction are cut into
   * six tetrahedra of ten nodes, which need all of their 27 nodes (Freudenthal
   * 1942), on the left the mirror image of those on the right, which conforms.
   *
   * "Mid-surface nodes" are the middle node of a column, or the two middle
   * ones if the number of layers is odd. Fibre and prestretch are constant in
   * a brick; F0 is the identity in the root, which is no free tissue.
   *
   * @throws InputError from ValveParameters::check(), and if the shape folds
   *   over itself so that a tetrahedron has no positive volume.
   */
  Leaflet
  generate_leaflet(const ValveParameters &valve);

  /**
   * Adds the papillary tips to the @p leaflet as held nodes, the sets
   * papillary_right and papillary_left, from which generate_chordae() then
   * lets the chordae begin.
   */
  void
  add_papillary_nodes(const ValveParameters &valve, Leaflet &leaflet);

  /**
   * Names of all chordae before any is removed: R-P1, ..., R-S1, ..., then the
   * same with L.
   */
  std::vector<std::string>
  chordae_ids(const ValveParameters &valve);

  /**
   * Builds the chordae: of each primary and secondary one the mesh column
   * nearest to its place, the nodes in the sphere of influence of radius r
   * around the middle of this column with weights proportional to
   * @p nodal_mass (kg, one entry a node) times 1 - d^2/r^2, normalised, and
   * the rest length
   *   max(f |closed - tip| / 1.02, 0.98 |open - tip|)
   * with f the factor of its class: at the closed design a chorda is then
   * stretched by 2 % for f = 1, and it is never so short that it would tear
   * at the open leaflet. A chorda at or above the commissure's angle belongs
   * to the anterior leaflet.
   *
   * @throws InputError if an id to be removed does not exist, or if a chorda
   *   is attached to nothing.
   */
  std::vector<Chorda>
  generate_chordae(const ValveParameters &valve,
                   const Leaflet &leaflet,
                   const std::vector<double> &nodal_mass);

  /**
   * Writes what has been generated, so that it can be looked at before a run:
   * valve.vtu (tetrahedra with region, fibre and held nodes), chordae.vtu
   * (straight lines from the tip to the attachment), chordae.csv and
   * columns.csv (named columns with units). Creates the folder. Call it on one
   * rank only.
   *
   * @throws InputError if a file cannot be written.
   */
  void
  write_valve_preview(const std::string &folder,
                      const Leaflet &leaflet,
                      const std::vector<Chorda> &chordae);
} // namespace coapt

#endif
