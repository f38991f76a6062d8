#include <coapt/coupled/valve_structure.h>
#include <coapt/geometry/cell_normals.h>
#include <coapt/geometry/valve_generator.h>

#include <cmath>

namespace coapt
{
  using dealii::Point;

  namespace
  {
    std::unique_ptr<const ImportedValve>
    import_valve(const ModelParameters &parameters)
    {
      if (!parameters.import.is_wanted)
        return nullptr;
      return std::make_unique<ImportedValve>(parameters.import,
                                             parameters.valve,
                                             parameters.solid.density,
                                             parameters.folder);
    }

    FittedTube
    make_lumen(const ModelParameters &parameters, const ImportedValve *imported)
    {
      const std::array<double, 2> axes = imported != nullptr
        ? imported->semi_axes()
        : std::array<double, 2>{{parameters.valve.annulus_semi_axis_x,
                                 parameters.valve.annulus_semi_axis_y}};
      return FittedTube(parameters.lumen, axes[0], axes[1]);
    }

    Leaflet
    make_leaflet(const ModelParameters &parameters,
                 const ImportedValve *imported)
    {
      if (imported != nullptr)
        return imported->leaflet();
      Leaflet leaflet = generate_leaflet(parameters.valve);
      if (!parameters.motion.file.empty())
        add_papillary_nodes(parameters.valve, leaflet);
      return leaflet;
    }

    std::vector<Chorda>
    make_chordae(const ModelParameters &parameters,
                 const ImportedValve *imported,
                 const Leaflet &leaflet,
                 const std::vector<double> &nodal_mass)
    {
      return imported != nullptr
        ? imported->chordae(nodal_mass)
        : generate_chordae(parameters.valve, leaflet, nodal_mass);
    }

    /** Those of the file, with a search that sees all films. */
    ContactParameters
    contact_parameters(const ModelParameters &parameters)
    {
      ContactParameters result = parameters.contact;
      // Gaps are known up to the clearance plus half of the margin.
      if (parameters.film.drains)
        result.search_margin = std::max(result.search_margin,
                                        2 *
                                          (parameters.film.largest_width *
                                             parameters.mesh.finest_cell() -
                                           result.clearance));
      return result;
    }

    PrescribedMotion
    make_motion(const ModelParameters &parameters, const Leaflet &leaflet)
    {
      if (parameters.motion.file.empty())
        return {};
      return {find_input_file(parameters.motion.file, parameters.folder),
              leaflet};
    }
  } // namespace



  ValveStructure::ValveStructure(const ModelParameters &parameters,
                                 MPI_Comm communicator)
    : parameters(parameters)
    , communicator(communicator)
    , ventricular_pressure(TimeTable::from_file(
        find_input_file(parameters.ends.pressure_table, parameters.folder),
        parameters.ends.pressure_unit))
    , imported(import_valve(parameters))
    , lumen(make_lumen(parameters, imported.get()))
    , leaflet(make_leaflet(parameters, imported.get()))
    , surface(triangulate(leaflet.quads))
    , solid(std::make_unique<SolidOperator<3>>(leaflet.mesh,
                                               parameters.solid,
                                               leaflet.fibre,
                                               leaflet.prestretch,
                                               communicator,
                                               cell_normals(leaflet),
                                               leaflet.chordae_mass))
    , chordae(std::make_unique<ChordaeNetwork>(
        make_chordae(parameters, imported.get(), leaflet, solid->mass()),
        solid->mass(),
        parameters.chordae.ramp_time,
        parameters.chordae.damping_ratio))
    , contact(
        std::make_unique<MidSurfaceContact>(leaflet,
                                            solid->mass(),
                                            parameters.solid.density,
                                            contact_parameters(parameters),
                                            communicator))
    , motion(make_motion(parameters, leaflet))
  {
  }



  std::vector<double>
  ValveStructure::reference_positions() const
  {
    std::vector<double> X;
    for (const Point<3> &x : leaflet.mesh.points)
      X.insert(X.end(), {x[0], x[1], x[2]});
    return X;
  }



  double
  ValveStructure::leaflet_volume() const
  {
    double volume = 0;
    for (const double cell : solid->cell_volumes())
      volume += cell;
    return volume;
  }



  double
  ValveStructure::contact_step_limit() const
  {
    return std::sqrt(parameters.contact.stiffness_factor *
                     parameters.solid.density * parameters.valve.thickness /
                     parameters.contact.max_stiffness);
  }



  std::vector<Point<3>>
  ValveStructure::mid_surface(const std::vector<double> &nodal) const
  {
    std::vector<Point<3>> result(leaflet.columns.size());
    for (unsigned int c = 0; c < result.size(); ++c)
      {
        const std::vector<unsigned int> &column = leaflet.columns[c];
        for (unsigned int k = 0; k < column.size(); ++k)
          {
            const double weight =
              ((k == 0 || k + 1 == column.size()) ? 0.5 : 1.) /
              (column.size() - 1);
            for (unsigned int d = 0; d < 3; ++d)
              result[c][d] += weight * nodal[3 * column[k] + d];
          }
      }
    return result;
  }
} // namespace coapt
