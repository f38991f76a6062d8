// Loads on a leaflet without fluid, and the files that hold them.

#include <coapt/base/csv_table.h>
#include <coapt/geometry/valve_generator.h>
#include <coapt/structure/pressure_load.h>
#include <coapt/structure/surface_load.h>

#include <filesystem>
#include <fstream>

#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::string file = "loads_test.csv";

  Leaflet
  small_leaflet()
  {
    ValveParameters valve;
    valve.n_circumferential = 24;
    valve.n_radial          = 4;
    return generate_leaflet(valve);
  }

  std::vector<double>
  positions(const Leaflet &leaflet)
  {
    std::vector<double> X;
    for (const auto &x : leaflet.mesh.points)
      X.insert(X.end(), {x[0], x[1], x[2]});
    return X;
  }

  Tensor<1, 3>
  total(const std::vector<double> &F)
  {
    Tensor<1, 3> sum;
    for (unsigned int i = 0; i < F.size(); ++i)
      sum[i % 3] += F[i];
    return sum;
  }

  /** Volume below the loaded face, as a cone to the origin. */
  double
  volume(const Leaflet &leaflet, const std::vector<double> &X)
  {
    std::vector<std::array<unsigned int, 4>> quads;
    for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
      if (leaflet.quad_region[q] != Region::root)
        quads.push_back(leaflet.quads[q]);
    double sum = 0;
    for (const auto &columns : triangulate(quads))
      {
        Point<3> x[3];
        for (unsigned int v = 0; v < 3; ++v)
          for (unsigned int d = 0; d < 3; ++d)
            x[v][d] = X[3 * leaflet.columns[columns[v]].back() + d];
        sum += x[0] * cross_product_3d(x[1], x[2]) / 6;
      }
    return sum;
  }

  /** Away from the edge of the face, the work of the pressure is the volume
   * that is displaced. */
  void
  pressure_work(const Leaflet &leaflet)
  {
    const PressureLoad load(leaflet);
    std::vector<double> X = positions(leaflet), F(X.size(), 0.), way(X.size());
    for (unsigned int c = 0; c < leaflet.columns.size(); ++c)
      {
        const double s = leaflet.column_coordinates[c][1];
        const double w = s > 0.1 && s < 0.9;
        for (unsigned int d = 0; d < 3; ++d)
          way[3 * leaflet.columns[c].back() + d] =
            w * 1e-7 * std::sin(1. + 3 * c + 5 * d);
      }
    load.add_forces(2e3, X.data(), F.data(), 0, 1);
    double work = 0;
    auto ahead = X, behind = X;
    for (unsigned int i = 0; i < X.size(); ++i)
      {
        work += 2 * F[i] * way[i];
        ahead[i] += way[i];
        behind[i] -= way[i];
      }
    check_relative("work of the pressure",
                   work,
                   -2e3 * (volume(leaflet, ahead) - volume(leaflet, behind)),
                   1e-6);

    std::vector<double> parts(X.size(), 0.);
    load.add_forces(2e3, X.data(), parts.data(), 0, 2);
    load.add_forces(2e3, X.data(), parts.data(), 1, 2);
    double difference = 0;
    for (unsigned int i = 0; i < F.size(); ++i)
      difference = std::max(difference, std::abs(F[i] - parts[i]));
    check("pressure, divided among ranks", difference < 1e-12, difference);
    // It pushes from outside to the axis, and up.
    check("pressure pushes towards the atrium", total(F)[2] > 0, total(F)[2]);
  }

  /** A load that is written on one mesh and read on another. */
  void
  record(const Leaflet &leaflet)
  {
    std::vector<Point<3>> points;
    const Tensor<1, 3> t = Point<3>(100, -200, 300);
    for (const auto &column : leaflet.columns)
      points.push_back(leaflet.mesh.points[column[1]]);
    {
      SurfaceLoadFile writer(file, points);
      writer.write(1e-3, std::vector<Tensor<1, 3>>(points.size()));
      writer.write(3e-3, std::vector<Tensor<1, 3>>(points.size(), t));
    }
    ValveParameters finer;
    finer.n_circumferential = 40;
    finer.n_radial          = 6;
    const Leaflet other     = generate_leaflet(finer);
    std::vector<Point<3>> others;
    for (const auto &column : other.columns)
      others.push_back(other.mesh.points[column[1]]);
    std::vector<double> mass(other.mesh.points.size());
    for (unsigned int i = 0; i < mass.size(); ++i)
      mass[i] = 1. + i % 3;
    const RecordedLoad load(
      file, other, others, std::vector<double>(others.size(), 1e-6), mass);

    for (const double time : {0., 2e-3, 5e-3})
      {
        std::vector<double> F(3 * mass.size(), 0.);
        load.add_forces(time, F.data(), 0, 2);
        load.add_forces(time, F.data(), 1, 2);
        const double share = std::min(1., std::max(0., time / 2e-3 - 0.5));
        const Tensor<1, 3> expected = share * 1e-6 * others.size() * t;
        check("recorded load at " + std::to_string(1e3 * time) + " ms",
              (total(F) - expected).norm() < 1e-9,
              total(F)[0]);
      }
  }

  void
  refused(const Leaflet &leaflet)
  {
    const auto answer = [&](const std::string &text) {
      std::ofstream(file) << text;
      return error_of([&]() {
        RecordedLoad(file,
                     leaflet,
                     std::vector<Point<3>>(leaflet.columns.size()),
                     std::vector<double>(leaflet.columns.size(), 1.),
                     std::vector<double>(leaflet.mesh.points.size(), 1.));
      });
    };
    const auto says = [](const std::string &what, const std::string &text) {
      return what.find(text) != std::string::npos;
    };
    const std::string header =
      "time_s,point,x_mm,y_mm,z_mm,tx_Pa,ty_Pa,tz_Pa\n";
    check("empty file", says(answer(""), "no row below a header"));
    check("column that is missing",
          says(answer("time_s,point\n1,2\n"), "column x_mm is missing"));
    check("short row", says(answer(header + "0,0,1\n"), "line 2: 3 entries"));
    check("text for a number",
          says(answer(header + "0,0,0,0,0,one,0,0\n"),
               "line 2, column tx_Pa: 'one' is not a finite number"));
    check("points out of order",
          says(answer(header + "0,1,0,0,0,0,0,0\n"), "points must be 0, 1, 2"));
    check("other number of points",
          says(answer(header +
                      "0,0,0,0,0,0,0,0\n0,1,0,0,0,0,0,0\n"
                      "1,0,0,0,0,0,0,0\n"),
               "there are 1 points, at first there are 2"));
    check("another valve",
          says(answer(header + "0,0,50,0,0,0,0,0\n"), "another valve"));
    std::filesystem::remove(file);
    check("file that is missing",
          says(error_of([]() { CsvTable table(file); }), "cannot be read"));
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Leaflet leaflet = small_leaflet();
  pressure_work(leaflet);
  record(leaflet);
  refused(leaflet);
}
