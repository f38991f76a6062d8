// calculix DECK TIME: a strip that falls from rest, computed with our explicit
// solid on one rank until TIME (s) and written to the input file DECK of
// CalculiX: the same mesh, forces of the nodes, supports and steps. Prints one
// line a figure. tools/compare_calculix runs both.

#include <deal.II/base/timer.h>

#include <fstream>
#include <iomanip>
#include <iostream>

#include "../solid/falling_strip.h"

using namespace falling_strip;

namespace
{
  /** CalculiX takes no longer steps than by its own rule for the mesh at rest:
   * 0.784 of the time of a pressure wave through a ninth of the smallest height
   * of a tetrahedron. A tenth below that, lest it choose another. */
  double
  step_for_calculix(const SimplexMesh<3> &mesh)
  {
    const auto &x = mesh.points;
    double height = length;
    for (const auto &cell : mesh.cells)
      for (unsigned int a = 0; a < 4; ++a)
        {
          const auto origin = x[cell[(a + 1) % 4]];
          const auto area   = cross_product_3d(x[cell[(a + 2) % 4]] - origin,
                                             x[cell[(a + 3) % 4]] - origin);
          height =
            std::min(height,
                     std::abs((x[cell[a]] - origin) * area) / area.norm());
        }
    const double speed =
      std::sqrt((material().bulk_modulus() + 4. / 3 * mu) / density);
    return 0.9 * 0.784 * height / 9 / speed;
  }



  /** Units are N, m, s. Loads act at their full size from the start of the only
   * step on. Of a number, CalculiX reads twenty characters. */
  void
  write_deck(std::ostream &deck,
             const SimplexMesh<3> &mesh,
             const Strip<bricks::Linear> &strip,
             const unsigned int n_steps,
             const double step)
  {
    deck << std::setprecision(12) << "*NODE, NSET=ALL\n";
    for (unsigned int node = 0; node < strip.points.size(); ++node)
      deck << node + 1 << ", " << strip.points[node][0] << ", "
           << strip.points[node][1] << ", " << strip.points[node][2] << "\n";
    deck << "*ELEMENT, ELSET=STRIP, TYPE=C3D4\n";
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        deck << cell + 1;
        for (const unsigned int node : mesh.cells[cell])
          deck << ", " << node + 1;
        deck << "\n";
      }
    deck << "*NSET, NSET=END\n";
    for (const unsigned int node : strip.end())
      deck << node + 1 << ",\n";

    // C10 (I1 - 3) + (J - 1)^2 / D1.
    deck << "*MATERIAL, NAME=TISSUE\n*HYPERELASTIC, NEO HOOKE\n"
         << mu / 2 << ", " << 2 / material().bulk_modulus() << "\n*DENSITY\n"
         << density << "\n*SOLID SECTION, ELSET=STRIP, MATERIAL=TISSUE\n";

    // No numerical damping. The last two numbers are bounds of the step; it
    // takes the largest.
    deck << "*AMPLITUDE, NAME=AT_ONCE\n0., 1., 1., 1.\n*STEP, NLGEOM, INC="
         << 2 * n_steps << "\n*DYNAMIC, EXPLICIT, ALPHA=0.\n"
         << step << ", " << n_steps * step << ", 1.e-12, " << step
         << "\n*BOUNDARY\n";
    for (unsigned int i = 0; i < strip.held.size(); ++i)
      if (strip.held[i])
        deck << i / 3 + 1 << ", " << i % 3 + 1 << ", " << i % 3 + 1 << "\n";
    deck << "*CLOAD, AMPLITUDE=AT_ONCE\n";
    for (unsigned int i = 0; i < strip.load.size(); ++i)
      if (strip.load[i] != 0)
        deck << i / 3 + 1 << ", " << i % 3 + 1 << ", " << strip.load[i] << "\n";
    deck << "*NODE PRINT, NSET=END, FREQUENCY=" << 2 * n_steps
         << "\nU\n*END STEP\n";
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  if (argc != 3)
    {
      std::cerr << "Usage: calculix DECK TIME" << std::endl;
      return 2;
    }
  const double end_time     = std::stod(argv[2]);
  const SimplexMesh<3> mesh = falling_strip::mesh();
  const Strip<bricks::Linear> strip(mesh);
  const unsigned int n_steps = std::ceil(end_time / step_for_calculix(mesh));
  const double step          = end_time / n_steps;
  std::ofstream deck(argv[1]);
  write_deck(deck, mesh, strip, n_steps, step);

  dealii::Timer timer;
  const Tensor<1, 3> displacement = strip.end_displacement(n_steps, step);
  timer.stop();
  std::cout << "elements " << mesh.cells.size() << "\nsteps " << n_steps
            << "\nstep_s " << step << "\nx_mm " << 1e3 * displacement[0]
            << "\nz_mm " << 1e3 * displacement[2] << "\nwall_s "
            << timer.wall_time() << "\ncpu_s " << timer.cpu_time()
            << "\nlongest_step_s "
            << 2 / strip.solid.max_frequency(strip.positions().data())
            << std::endl;
  return 0;
}
