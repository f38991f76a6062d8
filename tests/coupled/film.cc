// The film between two sheets: what it releases and drains, and what it leaves
// alone.

#include <coapt/coupled/sub_grid_film.h>
#include <coapt/fluid/fluid_grid.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "../contact/sheets.h"
#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const double h = 1e-3, density = 1060, sound_speed = 50, ventricular = 1e4;

  /** Cuts the layers of all quadrilaterals into tetrahedra along diagonals. */
  void
  add_tetrahedra(Leaflet &leaflet)
  {
    for (unsigned int q = 0; q < leaflet.quads.size(); ++q)
      for (unsigned int l = 0; l < 2; ++l)
        {
          std::array<unsigned int, 8> v;
          for (unsigned int i = 0; i < 4; ++i)
            for (unsigned int k = 0; k < 2; ++k)
              v[i + 4 * k] = leaflet.columns[leaflet.quads[q][i]][l + 1 - k];
          for (const auto &t : {std::array<unsigned int, 4>{{0, 1, 2, 6}},
                                {{0, 2, 3, 6}},
                                {{0, 3, 7, 6}},
                                {{0, 7, 4, 6}},
                                {{0, 4, 5, 6}},
                                {{0, 5, 1, 6}}})
            {
              leaflet.mesh.cells.push_back(
                {{v[t[1]], v[t[0]], v[t[2]], v[t[3]]}});
              leaflet.cell_quad.push_back(q);
            }
        }
  }

  /**
   * Two sheets of 8 x 8 mm in a box of fluid, one above the other. The edge
   * at x = -4 mm is the free one.
   */
  struct Film
  {
    explicit Film(const FilmParameters &parameters = FilmParameters())
    {
      for (const double side : {-1., 1.})
        {
          const unsigned int first = sheets.leaflet.columns.size();
          // Each of them has its first side towards the other.
          sheets.add(
            {{8, 8}},
            [=](const double a, const double b, const double t) {
              return Point<3>(8e-3 * (a - 0.5),
                              8e-3 * (b - 0.5) * -side,
                              0.1 * side - side * t);
            },
            64e-6,
            false);
          for (unsigned int j = 0; j <= 8; ++j)
            sheets.leaflet.free_edge_columns.push_back(first +
                                                       (side < 0 ? j : 8 - j));
        }
      add_tetrahedra(sheets.leaflet);
      // It must see gaps that are too wide for a film, as well.
      ContactParameters seen;
      seen.search_margin   = 5 * h;
      seen.search_interval = 1;
      contact              = std::make_unique<MidSurfaceContact>(
        sheets.leaflet, sheets.mass, density, seen, MPI_COMM_WORLD);
      grid = std::make_unique<FluidGrid<3>>(MPI_COMM_WORLD,
                                            Point<3>(-8e-3, -8e-3, -4e-3),
                                            Point<3>(8e-3, 8e-3, 4e-3),
                                            std::array<unsigned int, 3>{
                                              {16, 16, 8}});
      FluidParameters fluid_parameters;
      FluidBoundaries<3> boundaries;
      boundaries.type.fill(FluidBoundary::no_slip);
      fluid = std::make_unique<FluidOperator<3>>(
        fluid_parameters,
        boundaries,
        std::function<double(const Point<3> &)>());
      fluid->reinit(*grid);
      points = std::make_unique<CouplingPoints<3>>(
        sheets.leaflet.mesh,
        leaflet_lattice(sheets.leaflet, 0.5 * h, 1.),
        MPI_COMM_WORLD);
      film = std::make_unique<SubGridFilm>(sheets.leaflet,
                                           parameters,
                                           h,
                                           density * sound_speed * sound_speed,
                                           *points,
                                           *fluid,
                                           MPI_COMM_WORLD);
      pressure.assign(fluid->n_owned_cells(), 0.);
    }

    /** Puts the sheets @p gap apart, the film's middle at the height @p middle,
     * and has the film found. */
    void
    set_gap(const double gap, const double duration, const double middle = 0)
    {
      for (unsigned int n = 0; n < sheets.mass.size(); ++n)
        {
          const double side   = n < sheets.mass.size() / 2 ? -1 : 1;
          sheets.X[3 * n + 2] = sheets.leaflet.mesh.points[n][2] -
            side * (0.1 - 0.5 * (gap + Sheets::thickness)) + middle;
        }
      std::vector<double> V(sheets.X.size(), 0.);
      contact->apply_impulse(sheets.X.data(), V.data(), 1e-9);
      film->update(sheets.X.data(), contact->state(), duration, ventricular);
      multiplier.clear();
      points->distribute(*fluid, sheets.X.data(), multiplier);
    }

    /** Rate at which fluid drains from cells at the pressure @p p (m^3/s). */
    double
    drainage(const double p)
    {
      return drainage([=](const Point<3> &) { return p; });
    }

    /** The same, given the pressure at the middle of each cell. */
    double
    drainage(const std::function<double(const Point<3> &)> &p)
    {
      for (unsigned int c = 0; c < pressure.size(); ++c)
        {
          Point<3> middle = fluid->cell(c).lower;
          for (unsigned int d = 0; d < 3; ++d)
            middle[d] += 0.5 * fluid->cell(c).size;
          pressure[c] = p(middle);
        }
      std::vector<double> rate(pressure.size(), 0.);
      film->add_rate(pressure.data(), rate.data());
      double sum = 0;
      for (unsigned int c = 0; c < rate.size(); ++c)
        sum -= rate[c] * std::pow(fluid->cell(c).size, 3) /
          (density * sound_speed * sound_speed);
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }

    /** Force (N) of the upper sheet on the fluid when it moves downwards or,
     * with @p axis 0, sideways. */
    double
    force_on_fluid(const unsigned int axis)
    {
      std::vector<double> u(3 * fluid->n_local_nodes(), 0.), f(u);
      std::vector<double> V(sheets.X.size(), 0.), F(V), rate(multiplier.size());
      for (unsigned int n = sheets.mass.size() / 2; n < sheets.mass.size(); ++n)
        V[3 * n + axis] = -1;
      points->add_forces({1e13, 2e8, 1e5},
                         u.data(),
                         V.data(),
                         multiplier.data(),
                         f.data(),
                         F.data(),
                         rate.data());
      double sum = 0;
      for (unsigned int i = axis; i < F.size(); i += 3)
        sum += F[i];
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }

    Sheets sheets;
    std::unique_ptr<MidSurfaceContact> contact;
    std::unique_ptr<FluidGrid<3>> grid;
    std::unique_ptr<FluidOperator<3>> fluid;
    std::unique_ptr<CouplingPoints<3>> points;
    std::unique_ptr<SubGridFilm> film;
    std::vector<double> multiplier, pressure;
  };

  void
  wide_gaps()
  {
    Film film;
    film.set_gap(5e-3, 0.);
    const double down = film.force_on_fluid(2);
    film.set_gap(2.01 * h, 1e-6);
    check("contact sees a gap of 2.01 cells",
          std::abs(film.contact->state().gap[40] - 2.01 * h) < 1e-9,
          film.contact->state().gap[40]);
    check("a gap of 2.01 cells does not drain", film.drainage(1e4) == 0);
    check("a gap of 2.01 cells couples fully",
          std::abs(film.force_on_fluid(2) / down - 1) < 1e-12);
    film.set_gap(1.99 * h, 1e-6);
    check("a gap of 1.99 cells couples nearly fully",
          std::abs(film.force_on_fluid(2) / down - 1) < 0.01,
          film.force_on_fluid(2) / down);
    film.set_gap(1.75 * h, 1e-6);
    check("one between 1.5 and 2 cells is freed in part",
          std::abs(film.force_on_fluid(2) / down - 0.75) < 0.01,
          film.force_on_fluid(2) / down);
    film.set_gap(0.5 * h, 1e-6);
    check("a film frees the half that faces it",
          std::abs(film.force_on_fluid(2) / down - 0.5) < 0.01,
          film.force_on_fluid(2) / down);
    check_relative("tangential coupling stays",
                   film.force_on_fluid(0),
                   down,
                   1e-9);
  }

  void
  draining()
  {
    FilmParameters parameters;
    const double p = 1e4, gap = 0.5 * h;
    Film film(parameters);
    film.set_gap(gap, 0.);
    // Both halves and the film, 1.5 cells, are three quarters of two layers of
    // cells, which drain; nothing at the edge, all a column from it.
    const double rate = film.drainage(p), area = 8e-3 * 7.5e-3;
    check_relative("layers within the film by three quarters drain",
                   rate / (parameters.drainage * p),
                   2 * h * area,
                   0.07);
    check("fluid comes back when the pressure reverses",
          std::abs(film.drainage(-p) / rate + 1) < 1e-12);
    check_relative("power = pressure times flow",
                   dealii::Utilities::MPI::sum(
                     film.film->power(film.pressure.data()), MPI_COMM_WORLD),
                   p * rate,
                   1e-9);
    film.set_gap(gap, 0.); // forgets what has been evaluated
    const double duration = 1e-5;
    const double flow     = film.drainage(p);
    film.set_gap(gap, duration);
    check_relative("booked volume",
                   film.film->drained_volume(),
                   duration * flow,
                   1e-9);
    // 0.35, 1 and 0.15 of three layers, by points that are half a cell apart.
    film.set_gap(gap, 0., 0.4 * h);
    check_relative("one within it by a third drains by a fifth",
                   film.drainage(p) / (parameters.drainage * p),
                   1.2 * h * area,
                   0.12);
  }

  /** A film at the ventricular pressure stops to drain after a few of its
   * volumes, one at a tenth of it never; after opening it drains again. */
  void
  fed_films()
  {
    const double gap = 0.5 * h, duration = 1e-3;
    for (const double p : {ventricular, 0.1 * ventricular})
      {
        const bool fed = p == ventricular;
        Film film;
        film.set_gap(gap, 0.);
        const double first = film.drainage(p);
        // a fed film could drain 12 volumes, the other one too
        for (unsigned int i = 0; i < (fed ? 40 : 400); ++i)
          {
            film.set_gap(gap, duration);
            film.drainage(p);
          }
        const double last   = film.drainage(p);
        const double volume = 2 * h * 8e-3 * 7.5e-3;
        if (fed)
          {
            check("a film that the ventricle feeds stops to drain",
                  last == 0,
                  last / first);
            const double drained = film.film->drained_volume() / volume;
            check("it has drained two to four volumes",
                  drained > 2 && drained < 4,
                  drained);
            check_relative("what stays at a low pressure drains all the same",
                           film.drainage(0.1 * p),
                           0.1 * first,
                           1e-9);
            check_relative("and fluid comes back when the pressure reverses",
                           film.drainage(-p),
                           -first,
                           1e-9);
            film.set_gap(2 * h, duration);
            film.set_gap(gap, 0.);
            check_relative("it drains anew when it has been open",
                           film.drainage(p),
                           first,
                           1e-9);
          }
        else
          check_relative("a film at a low pressure drains on",
                         last,
                         first,
                         1e-9);
      }
  }

  /** Of columns that span cells at the ventricular pressure and others that
   * have drained, those cells stop to drain, and the others do not. */
  void
  fed_cells()
  {
    const double gap = 0.5 * h, duration = 1e-3, low = 0.02 * ventricular;
    const auto fed  = [](const Point<3> &x) { return x[2] < 0; };
    const auto flow = [&](Film &film) {
      return film.drainage(
        [&](const Point<3> &x) { return fed(x) ? ventricular : low; });
    };
    Film film;
    film.set_gap(gap, 0.);
    const double first = flow(film);
    check_relative("all drain at first",
                   first,
                   film.drainage(0.51 * ventricular),
                   1e-9);
    for (unsigned int i = 0; i < 60; ++i)
      {
        film.set_gap(gap, duration);
        flow(film);
      }
    check_relative("then only those that are not fed",
                   flow(film),
                   first * low / (ventricular + low),
                   1e-9);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  wide_gaps();
  draining();
  fed_films();
  fed_cells();
}
