#include <coapt/base/exceptions.h>
#include <coapt/geometry/valve_generator.h>

#include <filesystem>
#include <fstream>

namespace coapt
{
  using namespace dealii;

  namespace
  {
    constexpr double mm = 1e-3;

    std::ofstream
    create_file(const std::string &name)
    {
      std::ofstream out(name);
      if (!out)
        throw InputError("The file \"" + name + "\" cannot be written.");
      out.precision(9);
      return out;
    }

    /** Writes a data array of a .vtu file, entry by entry of @p values. */
    template <typename Values, typename Write>
    void
    write_array(std::ostream &out,
                const std::string &type,
                const std::string &name,
                const unsigned int n_components,
                const Values &values,
                const Write &write)
    {
      out << "<DataArray type=\"" << type << "\" Name=\"" << name
          << "\" NumberOfComponents=\"" << n_components
          << "\" format=\"ascii\">\n";
      for (const auto &value : values)
        {
          write(value);
          out << '\n';
        }
      out << "</DataArray>\n";
    }

    /** Everything up to the data: points and cells of one type. */
    template <typename Cells>
    void
    begin_vtu(std::ostream &out,
              const std::vector<Point<3>> &points,
              const Cells &cells,
              const unsigned int vtk_type)
    {
      out << "<?xml version=\"1.0\"?>\n"
          << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
             "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
          << "<Piece NumberOfPoints=\"" << points.size()
          << "\" NumberOfCells=\"" << cells.size() << "\">\n<Points>\n";
      write_array(out, "Float64", "position", 3, points, [&](const auto &p) {
        out << p;
      });
      out << "</Points>\n<Cells>\n";
      unsigned int offset = 0;
      write_array(
        out, "UInt32", "connectivity", 1, cells, [&](const auto &cell) {
          for (const unsigned int node : cell)
            out << node << ' ';
        });
      write_array(out, "UInt32", "offsets", 1, cells, [&](const auto &cell) {
        out << (offset += cell.size());
      });
      write_array(out, "UInt8", "types", 1, cells, [&](const auto &) {
        out << vtk_type;
      });
      out << "</Cells>\n";
    }

    void
    end_vtu(std::ostream &out)
    {
      out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    }

    /** Angle, fraction of the height and depth of each node. */
    std::vector<std::array<double, 3>>
    node_coordinates(const Leaflet &leaflet)
    {
      std::vector<std::array<double, 3>> result(leaflet.mesh.points.size());
      for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
        {
          const auto &nodes = leaflet.columns[c];
          for (unsigned int k = 0; k < nodes.size(); ++k)
            result[nodes[k]] = {
              {leaflet.column_coordinates[c][0] / ValveParameters::degree,
               leaflet.column_coordinates[c][1],
               k / (nodes.size() - 1.)}};
        }
      return result;
    }

    void
    write_leaflet(std::ostream &out, const Leaflet &leaflet)
    {
      begin_vtu(out, leaflet.mesh.points, leaflet.mesh.cells, 10);
      out << "<PointData>\n";
      const auto coordinates = node_coordinates(leaflet);
      const char *names[]    = {"angle_deg",
                                "height_fraction",
                                "depth_0_atrial_1_ventricular"};
      for (unsigned int d = 0; d < 3; ++d)
        write_array(out,
                    "Float64",
                    names[d],
                    1,
                    coordinates,
                    [&](const auto &x) { out << x[d]; });
      write_array(out,
                  "UInt8",
                  "held",
                  1,
                  leaflet.pinned,
                  [&](const bool held) { out << (held ? 1 : 0); });
      out << "</PointData>\n<CellData>\n";
      write_array(out,
                  "UInt8",
                  "region_0_anterior_1_posterior_2_commissure_3_root_4_septal",
                  1,
                  leaflet.cell_quad,
                  [&](const unsigned int quad) {
                    out << static_cast<unsigned int>(leaflet.quad_region[quad]);
                  });
      write_array(out,
                  "Float64",
                  "fibre",
                  3,
                  leaflet.fibre,
                  [&](const auto &f) { out << f; });
      out << "</CellData>\n";
      end_vtu(out);
    }

    Point<3>
    attachment(const Leaflet &leaflet, const Chorda &chorda)
    {
      Point<3> p;
      for (unsigned int n = 0; n < chorda.nodes.size(); ++n)
        p += chorda.weights[n] * leaflet.mesh.points[chorda.nodes[n]];
      return p;
    }

    const char *
    class_name(const ChordaClass chorda_class)
    {
      constexpr const char *names[] = {"anterior_primary",
                                       "anterior_secondary",
                                       "posterior_primary",
                                       "posterior_secondary"};
      return names[static_cast<unsigned int>(chorda_class)];
    }

    void
    write_chordae(std::ostream &out,
                  const Leaflet &leaflet,
                  const std::vector<Chorda> &chordae)
    {
      std::vector<Point<3>> points;
      std::vector<std::array<unsigned int, 2>> lines;
      for (const Chorda &chorda : chordae)
        {
          const unsigned int n = points.size();
          lines.push_back({{n, n + 1}});
          points.push_back(chorda.tip);
          points.push_back(attachment(leaflet, chorda));
        }
      begin_vtu(out, points, lines, 3);
      out << "<CellData>\n";
      write_array(out, "UInt8", "class", 1, chordae, [&](const Chorda &chorda) {
        out << static_cast<unsigned int>(chorda.chorda_class);
      });
      write_array(out,
                  "Float64",
                  "rest_length_mm",
                  1,
                  chordae,
                  [&](const Chorda &chorda) {
                    out << chorda.rest_length / mm;
                  });
      out << "</CellData>\n";
      end_vtu(out);
    }

    void
    write_chordae_table(std::ostream &out,
                        const Leaflet &leaflet,
                        const std::vector<Chorda> &chordae)
    {
      out << "id,class,diameter_mm,modulus_MPa,rest_length_mm,open_length_mm,"
             "tip_x_mm,tip_y_mm,tip_z_mm,attachment_x_mm,attachment_y_mm,"
             "attachment_z_mm,nodes\n";
      for (const Chorda &chorda : chordae)
        {
          out << chorda.id << ',' << class_name(chorda.chorda_class) << ','
              << chorda.diameter / mm << ',' << chorda.modulus / 1e6 << ','
              << chorda.rest_length / mm << ',' << chorda.open_length / mm;
          for (const Point<3> &p : {chorda.tip, attachment(leaflet, chorda)})
            for (unsigned int d = 0; d < 3; ++d)
              out << ',' << p[d] / mm;
          out << ',' << chorda.nodes.size() << '\n';
        }
    }

    void
    write_column_table(std::ostream &out, const Leaflet &leaflet)
    {
      out << "column,angle_deg,height_fraction,atrial_x_mm,atrial_y_mm,"
             "atrial_z_mm,ventricular_x_mm,ventricular_y_mm,"
             "ventricular_z_mm\n";
      for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
        {
          const auto &place = leaflet.column_coordinates[c];
          const auto &nodes = leaflet.columns[c];
          out << c << ',' << place[0] / ValveParameters::degree << ','
              << place[1];
          for (const unsigned int node : {nodes.front(), nodes.back()})
            for (unsigned int d = 0; d < 3; ++d)
              out << ',' << leaflet.mesh.points[node][d] / mm;
          out << '\n';
        }
    }

    void
    close(std::ofstream &out, const std::string &name)
    {
      out.close();
      if (!out)
        throw InputError("The file \"" + name +
                         "\" cannot be written completely.");
    }
  } // namespace



  void
  write_valve_preview(const std::string &folder,
                      const Leaflet &leaflet,
                      const std::vector<Chorda> &chordae)
  {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw InputError("The folder \"" + folder +
                       "\" cannot be created: " + error.message() + ".");
    const auto write = [&](const std::string &name, const auto &content) {
      const std::string path = folder + "/" + name;
      std::ofstream out      = create_file(path);
      content(out);
      close(out, path);
    };
    write("valve.vtu", [&](std::ostream &out) { write_leaflet(out, leaflet); });
    write("chordae.vtu",
          [&](std::ostream &out) { write_chordae(out, leaflet, chordae); });
    write("chordae.csv", [&](std::ostream &out) {
      write_chordae_table(out, leaflet, chordae);
    });
    write("columns.csv",
          [&](std::ostream &out) { write_column_table(out, leaflet); });
  }
} // namespace coapt
