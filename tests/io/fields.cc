// Fields for ParaView, read back: a refined fluid box with a round lumen, a
// stretched tetrahedron as leaflet, and one chorda.
#include <coapt/chordae/chordae_network.h>
#include <coapt/fluid/fluid_grid.h>
#include <coapt/fluid/fluid_operator.h>
#include <coapt/geometry/leaflet.h>
#include <coapt/io/fields.h>

#include "tests.h"
#include "vtu_reader.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

const MPI_Comm comm = MPI_COMM_WORLD;

double
distance_to_wall(const Point<3> &p)
{
  return std::hypot(p[0] - 0.5, p[1] - 0.5) - 0.4;
}

void
check_fluid()
{
  FluidGrid<3> grid(comm, Point<3>(), Point<3>(1, 1, 1), {{4, 4, 4}});
  grid.refine_to([](const Point<3> &center, const double) {
    return center[2] < 0.25 ? 1u : 0u;
  });
  FluidBoundaries<3> boundaries;
  boundaries.type.fill(FluidBoundary::slip);
  FluidOperator<3> fluid(FluidParameters(), boundaries, distance_to_wall);
  fluid.reinit(grid);

  // pressure = z of the cell's center, velocity = number of the component
  std::vector<double> velocity(3 * fluid.n_local_nodes());
  for (unsigned int i = 0; i < velocity.size(); ++i)
    velocity[i] = i % 3;
  std::vector<double> pressure(fluid.n_owned_cells()),
    solid_volume(fluid.n_owned_cells());
  double expected_volume = 0;
  unsigned int n_solid   = 0;
  for (unsigned int i = 0; i < fluid.n_owned_cells(); ++i)
    {
      const auto &cell    = fluid.cell(i);
      const double volume = std::pow(cell.size, 3);
      pressure[i]         = cell.lower[2] + cell.size / 2;
      const bool is_solid = pressure[i] > 0.75;
      solid_volume[i]     = (is_solid ? 0.8 : 0.25) * volume;
      expected_volume += fluid.is_active_cell(i) ? volume : 0;
      n_solid += fluid.is_active_cell(i) && is_solid ? 1 : 0;
    }

  FieldsWriter writer(".", comm);
  for (const double time : {0., 0.005})
    writer.write_fluid(
      time, grid, fluid, velocity.data(), pressure.data(), solid_volume);

  const int rank = dealii::Utilities::MPI::this_mpi_process(comm);
  const VtuReader file("fluid_00001." + std::to_string(rank) + ".vtu");
  const auto points       = file.array<float>("position");
  const auto connectivity = file.array<std::uint32_t>("connectivity");
  const auto u            = file.array<float>("velocity");
  const auto p            = file.array<float>("pressure");
  const auto blood        = file.array<float>("blood_volume_fraction");
  const auto level        = file.array<float>("level");
  double volume = 0, error = 0;
  unsigned int masked = 0;
  for (unsigned int i = 0; i < level.size(); ++i)
    {
      const auto position = [&](const unsigned int corner, const unsigned d) {
        return points[3 * connectivity[8 * i + corner] + d];
      };
      const double size = position(7, 2) - position(0, 2);
      volume += std::pow(size, 3);
      error = std::max(error, std::abs(size - 0.25 / (1 + level[i])));
      if (std::isnan(p[i]))
        ++masked;
      else
        error =
          std::max({error,
                    std::abs(p[i] - (position(7, 2) + position(0, 2)) / 2.),
                    std::abs(blood[i] - 0.75)});
    }
  for (unsigned int i = 0; i < u.size(); ++i)
    error = std::max(error, std::abs(u[i] - double(i % 3)));
  check("only cells in the lumen",
        std::abs(volume - expected_volume) < 1e-6,
        volume - expected_volume);
  check("pressure is masked in the solid", masked == n_solid, masked);
  check("fields of the fluid", error < 1e-6, error);
  check("as many vectors as points", u.size() == points.size());

  std::ifstream index("fluid_00001.pvtu"), collection("fluid.pvd");
  const std::string index_text(std::istreambuf_iterator<char>(index), {});
  const std::string times(std::istreambuf_iterator<char>(collection), {});
  const std::string last_piece = "fluid_00001." +
    std::to_string(dealii::Utilities::MPI::n_mpi_processes(comm) - 1) + ".vtu";
  MPI_Barrier(comm);
  if (rank == 0)
    std::cout << "index names all pieces: "
              << (index_text.find(last_piece) != std::string::npos)
              << "\ncollection names both times: "
              << (times.find("fluid_00000.pvtu") != std::string::npos &&
                  times.find("timestep=\"0.005\"") != std::string::npos)
              << std::endl;
}

Leaflet
one_tetrahedron()
{
  Leaflet leaflet;
  leaflet.mesh.points = {Point<3>(0, 0, 0),
                         Point<3>(1, 0, 0),
                         Point<3>(0, 1, 0),
                         Point<3>(0, 0, 1)};
  leaflet.mesh.cells  = {{{0, 1, 2, 3}}};
  leaflet.columns     = {{0, 1}, {2, 3}};
  leaflet.quad_region = {Region::posterior};
  leaflet.cell_quad   = {0};
  leaflet.fibre       = {Tensor<1, 3>({std::sqrt(0.5), std::sqrt(0.5), 0.})};
  return leaflet;
}

void
check_leaflet_and_chordae()
{
  // stretched threefold along x
  const Leaflet leaflet = one_tetrahedron();
  LeafletFields fields;
  for (const auto &point : leaflet.mesh.points)
    for (unsigned int d = 0; d < 3; ++d)
      fields.X.push_back((d == 0 ? 3 : 1) * point[d]);
  fields.V                = std::vector<double>(12, 2.);
  fields.cells.von_mises  = {1e5};
  fields.contact_pressure = {10., 20.};
  FieldsWriter writer(".", comm);
  writer.write_leaflet(0., leaflet, fields);

  Chorda chorda;
  chorda.diameter = chorda.modulus = chorda.rest_length = 1.;
  chorda.tip                                            = Point<3>(0, 0, -2);
  chorda.nodes                                          = {0};
  chorda.weights                                        = {1.};
  const ChordaeNetwork chordae({chorda}, std::vector<double>(4, 1.), 0., 0.2);
  writer.write_chordae(0., chordae, fields.X, std::vector<double>(12, 0.));

  MPI_Barrier(comm);
  const VtuReader file("leaflet_00000.vtu");
  const auto fibre = file.array<float>("fibre");
  check("fibre turns with the cell",
        std::abs(fibre[0] - 3 / std::sqrt(10.)) < 1e-6 &&
          std::abs(fibre[1] - 1 / std::sqrt(10.)) < 1e-6,
        fibre[0]);
  check("displacement", file.array<float>("displacement")[3] == 2);
  check("velocity", file.array<float>("velocity")[11] == 2);
  check("stress", file.array<float>("von_mises")[0] == 1e5f);
  check("region", file.array<float>("region")[0] == 1);
  check("contact pressure on all nodes of a column",
        file.array<float>("contact_pressure") ==
          std::vector<float>({10, 10, 20, 20}));
  check("absent fields are left out",
        file.array<float>("max_log_strain").empty());

  const VtuReader lines("chordae_00000.vtu");
  check("tension of the chorda",
        std::abs(lines.array<float>("tension")[0] - std::acos(-1.) / 4) < 1e-6,
        lines.array<float>("tension")[0]);
  check("ends of the chorda",
        lines.array<float>("position") ==
          std::vector<float>({0, 0, -2, 0, 0, 0}));
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_fluid();
  check_leaflet_and_chordae();
}
