#ifndef coapt_coupled_valve_structure_h
#define coapt_coupled_valve_structure_h

#include <coapt/base/time_table.h>
#include <coapt/chordae/chordae_network.h>
#include <coapt/contact/mid_surface_contact.h>
#include <coapt/coupled/model_parameters.h>
#include <coapt/geometry/leaflet.h>
#include <coapt/geometry/lumen.h>
#include <coapt/import/imported_valve.h>
#include <coapt/solid/solid_operator.h>

#include <functional>
#include <memory>
#include <vector>

namespace coapt
{
  /**
   * The solid half of a valve, generated or imported: leaflets, chordae,
   * contact, and the pressure that drives them. It is what a valve in blood and
   * one without fluid have in common.
   */
  class ValveStructure
  {
  public:
    /** Throws InputError. Collective. */
    ValveStructure(const ModelParameters &parameters, MPI_Comm communicator);

    /** Positions of all nodes in the reference, in groups of three (m). */
    std::vector<double>
    reference_positions() const;

    /** Volume of the leaflet at rest (m^3). */
    double
    leaflet_volume() const;

    /** Longest step (s) for which the largest contact stiffness is stable. */
    double
    contact_step_limit() const;

    /** Mean of the nodal values @p nodal (groups of three) through the
     * thickness of each column, by the trapezoidal rule. */
    std::vector<dealii::Point<3>>
    mid_surface(const std::vector<double> &nodal) const;

    const ModelParameters parameters;
    const MPI_Comm communicator;
    const TimeTable ventricular_pressure;

    /** The valve from files, if that is where it comes from. */
    const std::unique_ptr<const ImportedValve> imported;

    const FittedTube lumen;
    const Leaflet leaflet;

    /** Triangles of the mid-surface, by columns. */
    const std::vector<std::array<unsigned int, 3>> surface;

    std::unique_ptr<SolidOperator<3>> solid;
    std::unique_ptr<ChordaeNetwork> chordae;
    std::unique_ptr<MidSurfaceContact> contact;

    /** Of the nodes that are held. */
    const PrescribedMotion motion;

    /** What the last contact did. */
    MidSurfaceContact::Result last_contact;
  };
} // namespace coapt

#endif
