#ifndef coapt_io_vtu_file_h
#define coapt_io_vtu_file_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * An unstructured grid with data in VTK's XML format, for ParaView: cells of
   * one type, numbers in single precision, compressed by zlib and appended
   * without encoding.
   */
  class VtuFile
  {
  public:
    /** VTK's numbers of cell types, with nodes in deal.II's order. */
    enum class CellType : unsigned int
    {
      line        = 3,
      triangle    = 5,
      pixel       = 8,
      tetrahedron = 10,
      voxel       = 11
    };

    /**
     * A grid with @p points (m) and cells, the node numbers of which follow
     * each other in @p connectivity: 2, 3, 4, 4 or 8 a cell.
     */
    VtuFile(const std::vector<dealii::Point<3>> &points,
            const std::vector<unsigned int> &connectivity,
            const CellType type);

    /** Adds data for each point or cell; @p values has @p n_components
     * consecutive numbers for each of them. std::logic_error if not. @{ */
    void
    add_point_data(const std::string &name,
                   const unsigned int n_components,
                   const std::vector<double> &values);
    void
    add_cell_data(const std::string &name,
                  const unsigned int n_components,
                  const std::vector<double> &values);
    /** @} */

    /** Writes the grid to @p file. Throws std::runtime_error if that fails. */
    void
    write(const std::string &file) const;

    /**
     * Writes to @p file the index of a grid that is the union of @p pieces,
     * with the same data as this one. The names of pieces are relative to the
     * folder of the file.
     */
    void
    write_index(const std::string &file,
                const std::vector<std::string> &pieces) const;

  private:
    /** A compressed array and what the XML says about it. */
    struct Array
    {
      std::string name, type;
      unsigned int n_components;
      std::string bytes;
    };

    template <typename T>
    static Array
    make_array(const std::string &name,
               const std::string &type,
               const unsigned int n_components,
               const std::vector<T> &values);

    std::size_t n_points, n_cells;
    std::vector<Array> geometry; // points, connectivity, offsets, types
    std::vector<Array> point_data, cell_data;
  };

  /** Writes a collection of files over time (.pvd) for ParaView: pairs of time
   * (s) and file name relative to the folder of @p file. */
  void
  write_collection(const std::string &file,
                   const std::vector<std::pair<double, std::string>> &entries);
} // namespace coapt

#endif
