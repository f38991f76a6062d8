// A sheet slides over the free edge of another one, off it and back.

#include <coapt/contact/mid_surface_contact.h>

#include "sheets.h"
#include "tests.h"

#include <algorithm>
#include <memory>

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double length = 4e-3; // of the upper sheet
  constexpr double depth  = 50e-6;
  constexpr double move   = 0.01e-3; // of one step

  /** The upper sheet begins with its leading edge flush with that of the lower
   * one, which is wider, and is drawn along x at a constant height. */
  struct SlidingSheet
  {
    explicit SlidingSheet(const double friction)
    {
      ContactParameters parameters;
      parameters.clearance = 0.3e-3;
      parameters.damping   = 0;
      parameters.friction  = friction;
      sheets.add_rectangle({{20, 16}},
                           Point<3>(-8e-3, 0, 0),
                           {{8e-3, 6e-3}},
                           true);
      upper = sheets.mass.size();
      sheets.add_rectangle({{9, 7}},
                           Point<3>(-length, 1e-3, 5e-3),
                           {{length, 3.7e-3}},
                           false);
      contact = std::make_unique<MidSurfaceContact>(sheets.leaflet,
                                                    sheets.mass,
                                                    Sheets::density,
                                                    parameters,
                                                    MPI_COMM_WORLD);
      for (unsigned int n = upper; n < sheets.mass.size(); ++n)
        sheets.X[3 * n + 2] -=
          5e-3 - Sheets::thickness - parameters.clearance + depth;
      start = sheets.X;
    }

    /** Force (N) on the upper sheet after the @p way (m) past the edge, as it
     * comes from the way @p before. */
    Tensor<1, 3>
    force(const double before, const double way)
    {
      const double dt = 1e-6;
      std::fill(sheets.V.begin(), sheets.V.end(), 0.);
      for (unsigned int n = upper; n < sheets.mass.size(); ++n)
        {
          sheets.X[3 * n] = start[3 * n] + way;
          sheets.V[3 * n] = (way - before) / dt;
        }
      const auto velocities = sheets.V;
      contact->apply_impulse(sheets.X.data(), sheets.V.data(), dt);
      Tensor<1, 3> sum;
      for (unsigned int n = upper; n < sheets.mass.size(); ++n)
        for (unsigned int d = 0; d < 3; ++d)
          sum[d] +=
            sheets.mass[n] * (sheets.V[3 * n + d] - velocities[3 * n + d]) / dt;
      return sum;
    }

    Sheets sheets;
    unsigned int upper; // first node
    std::unique_ptr<MidSurfaceContact> contact;
    std::vector<double> start;
  };

  void
  slide_off(const double friction)
  {
    SlidingSheet sheet(friction);
    const unsigned int n = std::lround(1.2 * length / move);
    std::vector<Tensor<1, 3>> out, back;
    for (unsigned int i = 0; i <= n; ++i)
      out.push_back(sheet.force(move * (i - 1.), move * i));
    for (unsigned int i = 0; i <= n; ++i)
      back.push_back(sheet.force(move * (n + 1. - i), move * (n - i)));
    std::reverse(back.begin(), back.end());

    double jump = 0, other = 0, drag = 0, off_line = 0;
    const double full = out[0][2];
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double overlap = std::max(0., 1 - i * move / length);
        off_line = std::max(off_line, std::abs(out[i][2] / full - overlap));
        other    = std::max(other, std::abs(out[i][2] - back[i][2]) / full);
        for (const auto *way : {&out, &back})
          {
            drag = std::max(drag, std::abs((*way)[i][0]) / full);
            if (i > 0)
              jump = std::max(jump,
                              std::abs((*way)[i][2] - (*way)[i - 1][2]) / full);
          }
      }
    const std::string name = friction > 0 ? ", with friction" : "";
    check("sheet is carried" + name, full > 0, full);
    check("force falls with the overlap" + name, off_line < 0.005, off_line);
    check("to zero" + name, out.back().norm() == 0, out.back().norm());
    check("without jumps" + name, jump < 0.005, jump);
    check("it is the same on the way back" + name, other < 1e-8, other);
    check("the edge does not hook" + name, drag < friction + 1e-6, drag);
  }
  /** Force (N) on a sheet whose free edge comes to the @p distance (m) from
   * another, pinned one: upright above its middle, or in the same plane. */
  Tensor<1, 3>
  force_on_edge(const bool upright, const double distance)
  {
    const double h = 0.5e-3, side = 4e-3;
    Sheets sheets;
    sheets.add_rectangle({{8, 8}}, Point<3>(), {{side, side}}, true);
    const unsigned int upper = sheets.mass.size();
    // far away at first, as neighbours do not touch
    sheets.add(
      {{8, 8}},
      [=](const double a, const double b, const double t) {
        return upright
          ? Point<3>(side / 2 + t, 0.1 * h + side * a, 9e-3 + side * b)
          : Point<3>(side + 9e-3 + side * b, 0.1 * h + side * a, t);
      },
      side * side,
      false);
    ContactParameters parameters;
    parameters.clearance = 0.3e-3;
    parameters.damping   = 0;
    MidSurfaceContact contact(
      sheets.leaflet, sheets.mass, Sheets::density, parameters, MPI_COMM_WORLD);
    for (unsigned int n = upper; n < sheets.mass.size(); ++n)
      sheets.X[3 * n + (upright ? 2 : 0)] += distance - 9e-3;
    const double dt = 1e-6;
    contact.apply_impulse(sheets.X.data(), sheets.V.data(), dt);
    Tensor<1, 3> sum;
    for (unsigned int n = upper; n < sheets.mass.size(); ++n)
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += sheets.mass[n] * sheets.V[3 * n + d] / dt;
    return sum;
  }

  void
  push_edge(const bool upright)
  {
    const std::string name = upright ? "upright" : "in the plane";
    const unsigned int d   = upright ? 2 : 0;
    const double onset     = Sheets::thickness + 0.3e-3;
    double last            = 0;
    bool grows             = true;
    double aside           = 0;
    for (unsigned int i = 0; i < 20; ++i)
      {
        const Tensor<1, 3> force = force_on_edge(upright, onset - i * 20e-6);
        grows = grows && (force[d] > last || (last == 0 && i < 15));
        last  = force[d];
        aside = std::max(aside, std::abs(force[upright ? 0 : 2]));
      }
    check("an edge " + name + " is pushed back, the more the nearer",
          grows && last > 0,
          last);
    // the two triangles of a quadrilateral are no mirror images
    check("but not aside, " + name, aside < 1e-2 * last, aside / last);
    check("not from beyond the clearance, " + name,
          force_on_edge(upright, onset + 1e-6).norm() == 0);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  slide_off(0);
  slide_off(0.2);
  push_edge(true);
  push_edge(false);
}
