#ifndef coapt_structure_surface_load_h
#define coapt_structure_surface_load_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <coapt/base/growing_file.h>
#include <coapt/geometry/leaflet.h>

#include <string>
#include <vector>

namespace coapt
{
  /**
   * Writes the load on points of the mid-surface over time, for a run without
   * fluid: a CSV with the columns time_s, point, x_mm, y_mm, z_mm (reference),
   * tx_Pa, ty_Pa, tz_Pa (force over the reference area).
   */
  class SurfaceLoadFile
  {
  public:
    /** Writes into @p file about the @p points (m); if it @p continues an
     * earlier run, at the end of its file.
     * @throws std::runtime_error if it cannot. */
    SurfaceLoadFile(const std::string &file,
                    const std::vector<dealii::Point<3>> &points,
                    const bool continues = false);

    /** Adds the tractions (Pa) of all points at @p time (s). */
    void
    write(const double time, const std::vector<dealii::Tensor<1, 3>> &traction);

    /** The file, to save or restore how far it has come. */
    GrowingFile &
    file()
    {
      return table;
    }

  private:
    const std::vector<dealii::Point<3>> points;
    GrowingFile table;
  };



  /**
   * The load that such a file holds, for another mesh of the same leaflet:
   * each of its columns takes the mean of the four nearest points, weighted by
   * the inverse square of the distance, or the traction of a point that
   * coincides with it; over time, it is linear between the file's times and
   * held beyond them. The forces keep their direction.
   */
  class RecordedLoad
  {
  public:
    /**
     * @p points are those of the leaflet's columns on its mid-surface, @p area
     * their reference areas (m^2), and @p nodal_mass distributes the force of a
     * column among its nodes.
     *
     * @throws InputError with file and line if the file is no such load, or
     * if its points are farther than 4 mm from a column.
     */
    RecordedLoad(const std::string &file,
                 const Leaflet &leaflet,
                 const std::vector<dealii::Point<3>> &points,
                 const std::vector<double> &area,
                 const std::vector<double> &nodal_mass);

    /** Adds to @p F (N) the forces at time @p t (s), every @p n_ranks -th
     * column from @p rank on. */
    void
    add_forces(const double t,
               double *F,
               const unsigned int rank,
               const unsigned int n_ranks) const;

  private:
    const Leaflet &leaflet;
    std::vector<double> times;

    /** Force of each column (N), by time. */
    std::vector<std::vector<dealii::Tensor<1, 3>>> force;

    /** Share of each node in the force of its column. */
    std::vector<double> share;
  };
} // namespace coapt

#endif
