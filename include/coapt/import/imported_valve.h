#ifndef coapt_import_imported_valve_h
#define coapt_import_imported_valve_h

#include <coapt/chordae/chorda.h>
#include <coapt/geometry/leaflet.h>
#include <coapt/geometry/valve_parameters.h>
#include <coapt/import/chordae_tree.h>
#include <coapt/import/import_parameters.h>
#include <coapt/import/surface_mesh.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * A valve from files: a mid-surface that is given a thickness, held nodes,
   * and chordae that may branch. The middle of the annulus is moved to the
   * origin; the atrium lies at larger z.
   */
  class ImportedValve
  {
  public:
    /**
     * Reads the files, which are sought from the folder @p folder of the
     * parameter file. Of @p valve, thickness, layers, prestretches, fibre rule
     * and annulus hold are used; @p density (kg/m^3) is that of chordae.
     *
     * @throws InputError if a file is not usable (read_surface_mesh(),
     * ChordaeTree), if a label of the mesh has no region, if no set of held
     * nodes is called annulus or one of its vertices lies not on the boundary,
     * and if a fibre is missing, zero or not tangential.
     */
    ImportedValve(const ImportParameters &parameters,
                  const ValveParameters &valve,
                  const double density,
                  const std::string &folder);

    /** The leaflets, and the nodes of chordae. */
    const Leaflet &
    leaflet() const
    {
      return whole;
    }

    /** The chordae, which take the @p nodal_mass (kg) of all nodes into
     * account where they hold the leaflet. */
    std::vector<Chorda>
    chordae(const std::vector<double> &nodal_mass) const;

    /** Half the extents of the annulus along x and y (m). */
    std::array<double, 2>
    semi_axes() const;

  private:
    /** The nodes of one set, as the file names them. */
    struct HeldNodes
    {
      std::set<unsigned int> vertices;
      std::set<long> chordae_nodes;
    };

    void
    read_held_nodes(const std::string &file);

    /** Middles of edges on the boundary are held if both ends are. */
    void
    hold_added_vertices();

    void
    move_annulus_to_origin();

    /** Lets the normals point away from the atrium. */
    void
    turn_to_ventricle();

    void
    set_regions();

    /** Lines along annulus and free edge, and coordinates between them. */
    void
    set_coordinates();

    void
    set_fibres(const std::string &folder);

    void
    hold_nodes();

    ImportParameters parameters;
    ValveParameters valve;
    SurfaceMesh surface;
    std::map<std::string, HeldNodes> held;
    ChordaeTree tree;
    Leaflet whole;
  };
} // namespace coapt

#endif
