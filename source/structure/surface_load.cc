#include <deal.II/numerics/rtree.h>

#include <coapt/base/csv_table.h>
#include <coapt/base/exceptions.h>
#include <coapt/base/units.h>
#include <coapt/structure/surface_load.h>

#include <algorithm>
#include <stdexcept>

namespace coapt
{
  using dealii::Point;
  using dealii::Tensor;

  SurfaceLoadFile::SurfaceLoadFile(const std::string &file,
                                   const std::vector<Point<3>> &points,
                                   const bool continues)
    : points(points)
  {
    table.open(file, continues);
    table.stream().precision(6);
  }



  void
  SurfaceLoadFile::write(const double time,
                         const std::vector<Tensor<1, 3>> &traction)
  {
    std::ostream &stream = table.stream();
    if (table.size() == 0)
      stream << "time_s,point,x_mm,y_mm,z_mm,tx_Pa,ty_Pa,tz_Pa\n";
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        stream << time << ',' << i;
        for (unsigned int d = 0; d < 3; ++d)
          stream << ',' << points[i][d] / units::millimetre;
        for (unsigned int d = 0; d < 3; ++d)
          stream << ',' << traction[i][d];
        stream << '\n';
      }
    table.flush();
  }



  namespace
  {
    /** The content of a file of loads. */
    struct Record
    {
      std::vector<double> times;
      std::vector<Point<3>> points;
      std::vector<std::vector<Tensor<1, 3>>> traction; // by time and point
    };

    Record
    read(const std::string &file)
    {
      const CsvTable table(file);
      const auto time  = table.numbers("time_s");
      const auto point = table.numbers("point");
      std::array<std::vector<double>, 3> x, t;
      for (unsigned int d = 0; d < 3; ++d)
        {
          const std::string axis(1, "xyz"[d]);
          x[d] = table.numbers(axis + "_mm");
          t[d] = table.numbers("t" + axis + "_Pa");
        }

      Record record;
      for (unsigned int i = 0; i < table.n_rows(); ++i)
        {
          if (i == 0 || time[i] > time[i - 1])
            {
              record.times.push_back(time[i]);
              record.traction.emplace_back();
            }
          std::vector<Tensor<1, 3>> &now = record.traction.back();
          if (time[i] != record.times.back() || point[i] != now.size())
            throw InputError(table.place(i) +
                             ": times must increase, and at each time the "
                             "points must be 0, 1, 2 and so on");
          now.push_back(Point<3>(t[0][i], t[1][i], t[2][i]));
          if (record.times.size() == 1)
            record.points.push_back(units::millimetre *
                                    Point<3>(x[0][i], x[1][i], x[2][i]));
          if (now.size() > record.points.size())
            throw InputError(table.place(i) +
                             ": the first time has fewer points");
        }
      for (unsigned int k = 0; k < record.times.size(); ++k)
        if (record.traction[k].size() != record.points.size())
          throw InputError(file + ": at " + std::to_string(record.times[k]) +
                           " s there are " +
                           std::to_string(record.traction[k].size()) +
                           " points, at first there are " +
                           std::to_string(record.points.size()));
      return record;
    }

    /** The points that a column takes its load from, and their weights. */
    std::vector<std::pair<unsigned int, double>>
    neighbours(const dealii::RTree<std::pair<Point<3>, unsigned int>> &tree,
               const Point<3> &x,
               const std::string &file)
    {
      std::vector<std::pair<Point<3>, unsigned int>> nearest;
      tree.query(boost::geometry::index::nearest(x, 4),
                 std::back_inserter(nearest));
      std::vector<std::pair<unsigned int, double>> result;
      double sum = 0, least = 1;
      for (const auto &[point, number] : nearest)
        {
          const double distance = x.distance(point);
          // What coincides but for the digits of the file outweighs the rest.
          const double weight = 1 / std::max(distance * distance, 1e-16);
          result.emplace_back(number, weight);
          sum += weight;
          least = std::min(least, distance);
        }
      if (least > 4 * units::millimetre)
        throw InputError(file +
                         ": no point is within 4 mm of the leaflet at (" +
                         std::to_string(x[0] / units::millimetre) + ", " +
                         std::to_string(x[1] / units::millimetre) + ", " +
                         std::to_string(x[2] / units::millimetre) +
                         ") mm; it belongs to another valve");
      for (auto &entry : result)
        entry.second /= sum;
      return result;
    }
  } // namespace



  RecordedLoad::RecordedLoad(const std::string &file,
                             const Leaflet &leaflet,
                             const std::vector<Point<3>> &points,
                             const std::vector<double> &area,
                             const std::vector<double> &nodal_mass)
    : leaflet(leaflet), share(nodal_mass)
  {
    const Record record = read(file);
    times               = record.times;
    force.assign(times.size(), std::vector<Tensor<1, 3>>(points.size()));

    std::vector<std::pair<Point<3>, unsigned int>> numbered;
    for (unsigned int i = 0; i < record.points.size(); ++i)
      numbered.emplace_back(record.points[i], i);
    const auto tree = dealii::pack_rtree(numbered);
    for (unsigned int c = 0; c < points.size(); ++c)
      {
        for (const auto &[number, weight] : neighbours(tree, points[c], file))
          for (unsigned int k = 0; k < times.size(); ++k)
            force[k][c] += area[c] * weight * record.traction[k][number];
        double mass = 0;
        for (const unsigned int node : leaflet.columns[c])
          mass += nodal_mass[node];
        for (const unsigned int node : leaflet.columns[c])
          share[node] /= mass;
      }
  }



  void
  RecordedLoad::add_forces(const double t,
                           double *F,
                           const unsigned int rank,
                           const unsigned int n_ranks) const
  {
    const unsigned int after =
      std::upper_bound(times.begin(), times.end(), t) - times.begin();
    const unsigned int i = after > 0 ? after - 1 : 0;
    const unsigned int j = std::min<unsigned int>(after, times.size() - 1);
    const double s       = i == j ? 0. : (t - times[i]) / (times[j] - times[i]);
    for (unsigned int c = rank; c < leaflet.columns.size(); c += n_ranks)
      {
        const Tensor<1, 3> sum = (1 - s) * force[i][c] + s * force[j][c];
        for (const unsigned int node : leaflet.columns[c])
          for (unsigned int d = 0; d < 3; ++d)
            F[3 * node + d] += share[node] * sum[d];
      }
  }
} // namespace coapt
