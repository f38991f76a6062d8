#ifndef coapt_coupled_sub_grid_film_h
#define coapt_coupled_sub_grid_film_h

#include <coapt/contact/mid_surface_contact.h>
#include <coapt/coupled/film_parameters.h>
#include <coapt/coupled/pressure_sink.h>
#include <coapt/geometry/leaflet.h>
#include <coapt/immersion/coupling_points.h>

#include <mpi.h>

#include <vector>

namespace coapt
{
  /**
   * The film of fluid between two parts of a leaflet that nearly touch, where
   * it is thinner than the fluid's cells. Such a film drains within
   * milliseconds; trapped in cells, it would hold the leaflets apart and carry
   * the load in the place of contact. So, where the gap is below one or two
   * cells,
   *
   * - the half of the leaflet that faces the film is released from the fluid
   *   along the direction to its partner (CouplingPoints::set_release), while
   *   tangential coupling and the other half keep the seal;
   * - the cells between the two mid-surfaces drain to the atrial pressure,
   *   p' = -phi r rho c^2 p with the rate r, and fill again when the pressure
   *   reverses. phi rises from 0 to 1 with the fraction of the cell that lies
   *   there, from 0.25 to 0.75, and with the distance from the free edge up to
   *   half a cell, so that the sink does not draw from the ventricle;
   * - cells near the ventricular pressure p_v, in which films have drained
   *   whole volumes already, are fed by the ventricle and hold no trapped
   *   fluid: once two to four volumes have drained, or would have done so, phi
   *   falls to zero while p/p_v rises from 0.35 to 0.7.
   *
   * Where surfaces are further apart than the largest width, nothing is
   * changed at all.
   */
  class SubGridFilm : public PressureSink
  {
  public:
    /** The film of @p leaflet in cells of at least the size @p cell_size (m)
     * around it, of a fluid with the bulk modulus rho c^2 (Pa). */
    SubGridFilm(const Leaflet &leaflet,
                const FilmParameters &parameters,
                const double cell_size,
                const double bulk_modulus,
                CouplingPoints<3> &points,
                const FluidOperator<3> &fluid,
                MPI_Comm communicator);

    /**
     * Finds the films at the nodal positions @p X (m) from gaps and normals of
     * the columns, books what has drained since the last update in the
     * @p duration (s), and releases coupling points. From now on there is the
     * @p ventricular_pressure (Pa). Due every few steps, and when the cells of
     * the fluid are new. Collective.
     */
    void
    update(const double *X,
           const MidSurfaceContact::ColumnState &contact,
           const double duration,
           const double ventricular_pressure);

    void
    add_rate(const double *pressure, double *pressure_rate) override;

    double
    power(const double *pressure) const override;

    /** Volume (m^3) that has drained so far, less what has come back; the same
     * on all ranks. */
    double
    drained_volume() const
    {
      return volume;
    }

    /** What the films remember. */
    struct History
    {
      std::vector<double> turnover; // of the films of columns
      double volume = 0;            // that has drained, m^3

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &turnover &volume;
      }
    };

    /** What has drained since the last update() is not in it. */
    History
    history() const
    {
      return {turnover, volume};
    }

    /** Goes on from an earlier run's @p history; update() is due then. */
    void
    restore(const History &history)
    {
      turnover = history.turnover;
      volume   = history.volume;
    }

  private:
    /** A column in a film. */
    struct Station
    {
      double weight   = 0;    // of the treatment, 0 to 1
      double drainage = 0;    // the same, for drainage
      double turnover = 0;    // volumes that have drained
      double gap      = 0;    // m
      bool atrial     = true; // which side faces the film
      dealii::Tensor<1, 3> normal;
    };

    /** A draining cell of this rank. */
    struct Cell
    {
      unsigned int number;
      double volume;       // of the cell, m^3
      double in_film  = 0; // fraction of the cell in films
      double turnover = 0; // this times that of the columns
      double draining = 0; // fraction that drains while there is trapped fluid
      double trapped  = 0; // part that may still be trapped

      /** Sums over the evaluations of the pressure, and of its part that lets
       * fluid drain (Pa). */
      double pressures = 0;
      double drained   = 0;
    };

    /** A coupling point in a draining cell. */
    struct Source
    {
      unsigned int point;
      unsigned int entry; // in the list of cells
    };

    void
    measure_edge_distances(const Leaflet &leaflet);

    /** Books what has drained since the last update, and how much the columns'
     * films would have drained if nothing had been closed. */
    void
    book(const double duration);

    void
    find_stations(const double *X,
                  const MidSurfaceContact::ColumnState &contact);

    double
    edge_distance_with_partner(const unsigned int column,
                               const unsigned int partner) const;

    void
    find_draining_cells(const std::vector<dealii::Point<3>> &positions);

    /** Fraction of a cell that drains at this @p pressure (Pa). */
    double
    open_part(const Cell &cell, const double pressure) const;

    /** The station of a coupling point, interpolated. */
    Station
    station_at(const SamplePoint<3> &point) const;

    const Leaflet &leaflet;
    const FilmParameters parameters;
    const double cell_size;
    const double bulk_modulus;
    CouplingPoints<3> &points;
    const FluidOperator<3> &fluid;
    const MPI_Comm communicator;

    std::vector<std::array<unsigned int, 3>> triangles;
    std::vector<unsigned int> column_of_node;
    std::vector<double> edge_distance; // of columns from the free edge, m
    std::vector<Station> stations;
    std::vector<double> turnover; // volumes that films of columns have drained
    double comparison = 0; // what pressures of films are compared with, Pa
    std::vector<Cell> cells;
    std::vector<Source> sources;
    unsigned int evaluations = 0;
    double volume            = 0;
  };
} // namespace coapt

#endif
