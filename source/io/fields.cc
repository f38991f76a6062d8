#include <deal.II/base/tensor.h>

#include <coapt/base/first_rank.h>
#include <coapt/chordae/chordae_network.h>
#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>
#include <coapt/geometry/leaflet.h>
#include <coapt/io/fields.h>
#include <coapt/io/fluid_piece.h>
#include <coapt/io/vtu_file.h>

#include <cmath>
#include <limits>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    Point<3>
    node_position(const std::vector<double> &X, const unsigned int node)
    {
      return Point<3>(X[3 * node], X[3 * node + 1], X[3 * node + 2]);
    }

    /** Deformation gradient of each cell of the leaflet, applied to its fibre
     * and normalised. */
    std::vector<double>
    current_fibre(const Leaflet &leaflet, const std::vector<double> &X)
    {
      std::vector<double> result;
      result.reserve(3 * leaflet.fibre.size());
      for (unsigned int c = 0; c < leaflet.fibre.size(); ++c)
        {
          const auto &nodes = leaflet.mesh.cells[c];
          Tensor<2, 3> reference, current;
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int d = 0; d < 3; ++d)
              {
                reference[d][j] = leaflet.mesh.points[nodes[j + 1]][d] -
                  leaflet.mesh.points[nodes[0]][d];
                current[d][j] = X[3 * nodes[j + 1] + d] - X[3 * nodes[0] + d];
              }
          Tensor<1, 3> fibre = current * (invert(reference) * leaflet.fibre[c]);
          fibre /= fibre.norm();
          for (unsigned int d = 0; d < 3; ++d)
            result.push_back(fibre[d]);
        }
      return result;
    }

    /** Gives the value of each column to all nodes of the column. */
    std::vector<double>
    column_to_nodes(const Leaflet &leaflet, const std::vector<double> &values)
    {
      std::vector<double> result(leaflet.mesh.points.size());
      for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
        for (const unsigned int node : leaflet.columns[c])
          result[node] = values[c];
      return result;
    }
  } // namespace

  FieldsWriter::FieldsWriter(const std::string &folder,
                             const MPI_Comm communicator)
    : folder(folder), communicator(communicator)
  {
  }



  void
  FieldsWriter::write_fluid(const double time,
                            const FluidGrid<3> &grid,
                            const FluidOperator<3> &fluid,
                            const double *velocity_local,
                            const double *pressure,
                            const std::vector<double> &solid_volume)
  {
    const FluidPiece<3> piece(fluid);
    std::vector<double> blood, visible_pressure;
    for (const unsigned int i : piece.cells)
      {
        const double size     = fluid.cell(i).size;
        const double fraction = 1 - solid_volume[i] / (size * size * size);
        blood.push_back(std::max(0., fraction));
        visible_pressure.push_back(
          fraction > 0.5 ? pressure[i]
                         : std::numeric_limits<double>::quiet_NaN());
      }

    VtuFile file = piece.file(velocity_local);
    file.add_cell_data("pressure", 1, visible_pressure);
    file.add_cell_data("blood_volume_fraction", 1, blood);
    file.add_cell_data("level", 1, piece.levels(grid, fluid));
    add_to_collection(
      fluid_series,
      time,
      write_distributed(file, folder, next_name(fluid_series), communicator));
  }



  void
  FieldsWriter::write_leaflet(const double time,
                              const Leaflet &leaflet,
                              const LeafletFields &fields)
  {
    const std::string name = next_name(leaflet_series) + ".vtu";
    if (is_first_rank(communicator))
      {
        const unsigned int n_nodes = leaflet.mesh.points.size();
        std::vector<Point<3>> points(n_nodes);
        std::vector<double> displacement(3 * n_nodes);
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            points[i] = node_position(fields.X, i);
            for (unsigned int d = 0; d < 3; ++d)
              displacement[3 * i + d] =
                points[i][d] - leaflet.mesh.points[i][d];
          }
        std::vector<unsigned int> connectivity;
        for (const auto &cell : leaflet.mesh.cells)
          connectivity.insert(connectivity.end(), cell.begin(), cell.end());
        std::vector<double> region;
        for (const unsigned int quad : leaflet.cell_quad)
          region.push_back(static_cast<double>(leaflet.quad_region[quad]));

        VtuFile file(points, connectivity, VtuFile::CellType::tetrahedron);
        file.add_point_data("displacement", 3, displacement);
        file.add_point_data("velocity", 3, fields.V);
        if (!fields.contact_pressure.empty())
          file.add_point_data("contact_pressure",
                              1,
                              column_to_nodes(leaflet,
                                              fields.contact_pressure));
        if (!fields.coaptation_pressure.empty())
          file.add_point_data("coaptation_pressure",
                              1,
                              column_to_nodes(leaflet,
                                              fields.coaptation_pressure));
        const auto add = [&](const std::string &field,
                             const std::vector<double> &values) {
          if (!values.empty())
            file.add_cell_data(field, 1, values);
        };
        add("von_mises", fields.cells.von_mises);
        add("max_principal_stress", fields.cells.principal_stress);
        add("max_log_strain", fields.cells.largest_strain);
        add("volume_ratio", fields.cells.volume_ratio);
        if (!leaflet.fibre.empty())
          file.add_cell_data("fibre", 3, current_fibre(leaflet, fields.X));
        file.add_cell_data("region", 1, region);
        file.write(folder + "/" + name);
      }
    add_to_collection(leaflet_series, time, name);
  }



  void
  FieldsWriter::write_chordae(const double time,
                              const ChordaeNetwork &chordae,
                              const std::vector<double> &X,
                              const std::vector<double> &V)
  {
    const std::string name = next_name(chordae_series) + ".vtu";
    if (is_first_rank(communicator))
      {
        const std::vector<Point<3>> ends = chordae.attachment_points(X.data());
        const std::vector<Point<3>> origins = chordae.origins(X.data());
        std::vector<Point<3>> points;
        std::vector<unsigned int> connectivity;
        std::vector<double> classes;
        for (unsigned int i = 0; i < ends.size(); ++i)
          {
            points.push_back(origins[i]);
            points.push_back(ends[i]);
            connectivity.push_back(2 * i);
            connectivity.push_back(2 * i + 1);
            classes.push_back(
              static_cast<double>(chordae.chordae()[i].chorda_class));
          }
        VtuFile file(points, connectivity, VtuFile::CellType::line);
        file.add_cell_data("tension",
                           1,
                           chordae.tensions(time, X.data(), V.data()));
        file.add_cell_data("class", 1, classes);
        file.write(folder + "/" + name);
      }
    add_to_collection(chordae_series, time, name);
  }



  std::string
  FieldsWriter::next_name(const Series &series)
  {
    return numbered(series.name, series.entries.size());
  }



  void
  FieldsWriter::add_to_collection(Series &series,
                                  const double time,
                                  const std::string &file) const
  {
    series.entries.emplace_back(time, file);
    if (is_first_rank(communicator))
      write_collection(folder + "/" + series.name + ".pvd", series.entries);
  }
} // namespace coapt
