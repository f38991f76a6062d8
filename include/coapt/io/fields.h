#ifndef coapt_io_fields_h
#define coapt_io_fields_h

#include <coapt/solid/cell_results.h>

#include <deal.II/base/point.h>

#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  class ChordaeNetwork;
  template <int dim>
  class FluidGrid;
  template <int dim>
  class FluidOperator;
  struct Leaflet;

  /** What is shown on the leaflet. Nodal triples are [3 * node + component].
   * Vectors that are empty are left out of the file. */
  struct LeafletFields
  {
    /** Positions (m) and velocities (m/s) of all nodes. */
    std::vector<double> X, V;

    /** Stress and strain of each cell. */
    CellResults cells;

    /** Contact pressure, and total traction of coaptation (contact and film),
     * for each column (Pa). */
    std::vector<double> contact_pressure, coaptation_pressure;
  };

  /**
   * Writes the fields of a run for ParaView: a file fields/NAME_NUMBER.vtu or
   * .pvtu at each time, and a collection fields/NAME.pvd of all times so far,
   * for the names fluid, leaflet and chordae. Positions are the current ones,
   * so that the three lie on each other.
   */
  class FieldsWriter
  {
  public:
    /** Writes into the existing folder @p folder. */
    FieldsWriter(const std::string &folder, const MPI_Comm communicator);

    /**
     * Fluid at @p time (s) in the lumen: velocity (nodes; m/s), pressure
     * (cells; Pa; not a number where more than half of the cell is solid, for
     * it has no meaning there), blood_volume_fraction and level. Takes local
     * velocities, pressures, and the volume of solid in each owned cell
     * (m^3). Collective.
     */
    void
    write_fluid(const double time,
                const FluidGrid<3> &grid,
                const FluidOperator<3> &fluid,
                const double *velocity_local,
                const double *pressure,
                const std::vector<double> &solid_volume);

    /** Leaflet at @p time (s): displacement, velocity and pressures on nodes;
     * stress, strain, current fibre direction and region on cells. */
    void
    write_leaflet(const double time,
                  const Leaflet &leaflet,
                  const LeafletFields &fields);

    /** Chordae at @p time (s) as lines from the tip to the attachment, with
     * tension (N) and class. */
    void
    write_chordae(const double time,
                  const ChordaeNetwork &chordae,
                  const std::vector<double> &X,
                  const std::vector<double> &V);

    /** Saves or restores which files there are. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &fluid_series &leaflet_series &chordae_series;
    }

  private:
    /** Files of one name that have been written. */
    struct Series
    {
      std::string name;
      std::vector<std::pair<double, std::string>> entries;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &entries;
      }
    };

    /** "NAME_NUMBER" of the file to be written now. */
    static std::string
    next_name(const Series &series);

    /** Adds @p file to the collection. */
    void
    add_to_collection(Series &series,
                      const double time,
                      const std::string &file) const;

    const std::string folder;
    const MPI_Comm communicator;
    Series fluid_series{"fluid", {}};
    Series leaflet_series{"leaflet", {}};
    Series chordae_series{"chordae", {}};
  };
} // namespace coapt

#endif
