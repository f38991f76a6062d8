#include <coapt/base/exceptions.h>
#include <coapt/io/vtu_file.h>

#include <zlib.h>

#include <cstdint>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace coapt
{
  namespace
  {
    std::size_t
    nodes_per_cell(const VtuFile::CellType type)
    {
      switch (type)
        {
          case VtuFile::CellType::line:
            return 2;
          case VtuFile::CellType::triangle:
            return 3;
          case VtuFile::CellType::pixel:
          case VtuFile::CellType::tetrahedron:
            return 4;
          default:
            return 8;
        }
    }

    /** A single zlib block with the header that VTK expects: number of
     * blocks, size of a block, of the last block, and compressed size. */
    std::string
    compressed(const void *data, const std::size_t size)
    {
      uLongf length = compressBound(size);
      std::string block(length, '\0');
      if (compress2(reinterpret_cast<Bytef *>(&block[0]),
                    &length,
                    static_cast<const Bytef *>(data),
                    size,
                    Z_BEST_SPEED) != Z_OK)
        throw std::runtime_error("zlib cannot compress the fields");
      block.resize(length);

      const std::uint64_t header[4]  = {1, size, size, length};
      const std::uint64_t nothing[3] = {0, 0, 0};
      if (size == 0)
        return std::string(reinterpret_cast<const char *>(nothing),
                           sizeof(nothing));
      return std::string(reinterpret_cast<const char *>(header),
                         sizeof(header)) +
        block;
    }

    void
    finish(std::ofstream &stream, const std::string &file)
    {
      stream.close();
      if (!stream)
        throw std::runtime_error(file + ": writing failed; is the disk full?");
    }

    const char *const file_attributes =
      "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\"";
  } // namespace

  template <typename T>
  VtuFile::Array
  VtuFile::make_array(const std::string &name,
                      const std::string &type,
                      const unsigned int n_components,
                      const std::vector<T> &values)
  {
    return {name,
            type,
            n_components,
            compressed(values.data(), values.size() * sizeof(T))};
  }



  VtuFile::VtuFile(const std::vector<dealii::Point<3>> &points,
                   const std::vector<unsigned int> &connectivity,
                   const CellType type)
    : n_points(points.size())
    , n_cells(connectivity.size() / nodes_per_cell(type))
  {
    std::vector<float> positions;
    positions.reserve(3 * n_points);
    for (const auto &point : points)
      for (unsigned int d = 0; d < 3; ++d)
        positions.push_back(point[d]);
    std::vector<std::uint32_t> offsets(n_cells);
    for (std::size_t i = 0; i < n_cells; ++i)
      offsets[i] = (i + 1) * nodes_per_cell(type);
    const std::vector<std::uint8_t> types(n_cells,
                                          static_cast<std::uint8_t>(type));

    geometry = {make_array("position", "Float32", 3, positions),
                make_array("connectivity", "UInt32", 1, connectivity),
                make_array("offsets", "UInt32", 1, offsets),
                make_array("types", "UInt8", 1, types)};
  }



  void
  VtuFile::add_point_data(const std::string &name,
                          const unsigned int n_components,
                          const std::vector<double> &values)
  {
    if (values.size() != n_components * n_points)
      throw std::logic_error(name + ": size does not fit the points");
    const std::vector<float> single(values.begin(), values.end());
    point_data.push_back(make_array(name, "Float32", n_components, single));
  }



  void
  VtuFile::add_cell_data(const std::string &name,
                         const unsigned int n_components,
                         const std::vector<double> &values)
  {
    if (values.size() != n_components * n_cells)
      throw std::logic_error(name + ": size does not fit the cells");
    const std::vector<float> single(values.begin(), values.end());
    cell_data.push_back(make_array(name, "Float32", n_components, single));
  }



  void
  VtuFile::write(const std::string &file) const
  {
    std::ofstream stream(file, std::ios::binary);
    std::size_t offset = 0;
    const auto declare = [&](const Array &array) {
      stream << "<DataArray type=\"" << array.type << "\" Name=\"" << array.name
             << "\" NumberOfComponents=\"" << array.n_components
             << "\" format=\"appended\" offset=\"" << offset << "\"/>\n";
      offset += array.bytes.size();
    };

    stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
           << file_attributes
           << ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << n_points
           << "\" NumberOfCells=\"" << n_cells << "\">\n<Points>\n";
    declare(geometry[0]);
    stream << "</Points>\n<Cells>\n";
    for (unsigned int i = 1; i < geometry.size(); ++i)
      declare(geometry[i]);
    stream << "</Cells>\n<PointData>\n";
    for (const Array &array : point_data)
      declare(array);
    stream << "</PointData>\n<CellData>\n";
    for (const Array &array : cell_data)
      declare(array);
    stream << "</CellData>\n</Piece>\n</UnstructuredGrid>\n"
           << "<AppendedData encoding=\"raw\">\n_";
    for (const auto *arrays : {&geometry, &point_data, &cell_data})
      for (const Array &array : *arrays)
        stream << array.bytes;
    stream << "\n</AppendedData>\n</VTKFile>\n";
    finish(stream, file);
  }



  void
  VtuFile::write_index(const std::string &file,
                       const std::vector<std::string> &pieces) const
  {
    std::ofstream stream(file);
    const auto declare = [&](const Array &array) {
      stream << "<PDataArray type=\"" << array.type << "\" Name=\""
             << array.name << "\" NumberOfComponents=\"" << array.n_components
             << "\"/>\n";
    };

    stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" "
           << file_attributes
           << ">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n";
    declare(geometry[0]);
    stream << "</PPoints>\n<PPointData>\n";
    for (const Array &array : point_data)
      declare(array);
    stream << "</PPointData>\n<PCellData>\n";
    for (const Array &array : cell_data)
      declare(array);
    stream << "</PCellData>\n";
    for (const std::string &piece : pieces)
      stream << "<Piece Source=\"" << piece << "\"/>\n";
    stream << "</PUnstructuredGrid>\n</VTKFile>\n";
    finish(stream, file);
  }



  void
  write_collection(const std::string &file,
                   const std::vector<std::pair<double, std::string>> &entries)
  {
    std::ofstream stream(file);
    stream << std::setprecision(12)
           << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
              "version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto &entry : entries)
      stream << "<DataSet timestep=\"" << entry.first << "\" part=\"0\" file=\""
             << entry.second << "\"/>\n";
    stream << "</Collection>\n</VTKFile>\n";
    finish(stream, file);
  }
} // namespace coapt
