// What counts as a partner of contact: the parts of the leaflet that face a
// column, not its neighbours in the surface, whatever the exclusion distance.

#include <coapt/contact/mid_surface_contact.h>

#include "sheets.h"
#include "tests.h"

using namespace coapt;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::vector<double> exclusions = {0, 0.95e-3, 1.8e-3, 2.7e-3};

  /** A clearance of half a cell, gaps known to 3.3 mm. */
  ContactParameters
  with_exclusion(const double distance)
  {
    ContactParameters parameters;
    parameters.clearance          = 0.3e-3;
    parameters.search_margin      = 6e-3;
    parameters.exclusion_distance = distance;
    return parameters;
  }

  /** The state of contact of @p sheets, which were @p reference. */
  MidSurfaceContact::ColumnState
  state(const Sheets &reference, Sheets sheets, const double exclusion)
  {
    MidSurfaceContact contact(reference.leaflet,
                              sheets.mass,
                              Sheets::density,
                              with_exclusion(exclusion),
                              MPI_COMM_SELF);
    contact.apply_impulse(sheets.X.data(), sheets.V.data(), 1e-5);
    return contact.state();
  }

  unsigned int
  n_reported(const std::vector<double> &gaps)
  {
    unsigned int n = 0;
    for (const double gap : gaps)
      n += gap < MidSurfaceContact::no_gap;
    return n;
  }

  double
  largest_error(const std::vector<double> &gaps, const double expected)
  {
    double error = 0;
    for (const double gap : gaps)
      error = std::max(error, std::abs(gap - expected));
    return error;
  }

  using Shape = std::function<Point<3>(double, double, double)>;

  Sheets
  sheet(const Shape &shape)
  {
    Sheets sheets;
    sheets.add({{60, 20}}, shape, 1e-4, false);
    return sheets;
  }

  /** A wall around the axis whose radius (m) falls from @p top to @p bottom,
   * with a free edge of two leaflets and notches between them. */
  Sheets
  valve(const double top, const double bottom)
  {
    Sheets result = sheet([=](const double a, const double b, const double t) {
      const double radius = top + b * (bottom - top) + t,
                   height = 13e-3 + 4e-3 * std::cos(4 * M_PI * a);
      return Point<3>(radius * std::cos(2 * M_PI * a),
                      radius * std::sin(2 * M_PI * a),
                      -height * b);
    });
    // The ring is closed: its last columns are the first ones.
    const unsigned int last = 60 * 21;
    for (auto &quad : result.leaflet.quads)
      for (unsigned int &column : quad)
        column -= column >= last ? last : 0;
    return result;
  }



  /** Surfaces that nothing faces: no partner, no impulse. */
  void
  alone()
  {
    const auto none = [](const std::string &name, const Sheets &sheets) {
      unsigned int n = 0;
      for (const double exclusion : exclusions)
        n += n_reported(state(sheets, sheets, exclusion).gap);
      check(name + " has no partner", n == 0, n);
    };
    none("a flat sheet",
         sheet([](const double a, const double b, const double t) {
           return Point<3>(30e-3 * a, 10e-3 * b, t);
         }));
    none("a sheet with waves of 45 degrees",
         sheet([](const double a, const double b, const double t) {
           return Point<3>(30e-3 * a,
                           10e-3 * b,
                           t + 0.8e-3 * std::sin(2 * M_PI * 6 * a));
         }));
    none("an open valve", valve(13e-3, 9e-3));
    none("an edge that is bent by 80 degrees",
         sheet([](const double a, const double b, const double t) {
           const double s = 30e-3 * (a - 0.5), angle = M_PI * 40 / 180;
           return Point<3>(s * std::cos(angle),
                           10e-3 * b,
                           std::abs(s) * std::sin(angle) + t);
         }));
  }

  /** Two sheets 1.3 cells of 1.25 mm apart; in-plane neighbours are nearer. */
  void
  two_sheets()
  {
    const double gap = 1.3 * 1.25e-3;
    double error     = 0;
    for (const double exclusion : exclusions)
      {
        Sheets sheets, apart;
        for (const double side : {0., 1.})
          for (Sheets *s : {&sheets, &apart})
            s->add_rectangle(
              {{15, 12}},
              Point<3>(0,
                       0,
                       side * (s == &apart ? 0.1 : gap + Sheets::thickness)),
              {{10e-3, 9e-3}},
              false);
        const auto result = state(apart, sheets, exclusion);
        error             = std::max(error, largest_error(result.gap, gap));
        for (unsigned int c = 0; c < result.gap.size(); ++c)
          error = std::max(error, 1 - std::abs(result.normals[c][2]));
      }
    check("sheets 1.3 cells apart face each other", error < 1e-12, error);
  }

  /** Where the oblique sheet at 50 degrees is nearest. */
  void
  oblique_sheets()
  {
    const double angle = M_PI * 50 / 180;
    Sheets sheets, apart;
    for (Sheets *s : {&sheets, &apart})
      {
        s->add_rectangle({{20, 8}}, Point<3>(), {{20e-3, 8e-3}}, false);
        const double shift = s == &apart ? 0.1 : 0;
        s->add(
          {{20, 8}},
          [=](const double a, const double b, const double t) {
            const double x = 20e-3 * a;
            return Point<3>(x * std::cos(angle) - t * std::sin(angle),
                            8e-3 * b,
                            1.5e-3 + x * std::sin(angle) + t * std::cos(angle) +
                              shift);
          },
          160e-6,
          false);
      }
    // A column of the lower sheet at x: the nearest point of the upper one is
    // within it if x cos(angle) > 1.5 mm sin(angle), else it is its edge.
    double error   = 0;
    unsigned int n = 0;
    for (const double exclusion : exclusions)
      {
        const auto gap = state(apart, sheets, exclusion).gap;
        for (unsigned int i = 0; i <= 20; ++i)
          {
            const double x    = 1e-3 * i,
                         foot = x * std::cos(angle) - 1.5e-3 * std::sin(angle);
            const double distance = foot > 0
              ? x * std::sin(angle) + 1.5e-3 * std::cos(angle)
              : std::hypot(x, 1.5e-3);
            if (distance - Sheets::thickness > 3.2e-3)
              continue;
            ++n;
            error =
              std::max(error,
                       std::abs(gap[9 * i + 4] - distance + Sheets::thickness));
          }
      }
    check("an oblique sheet", error < 1e-12 && n >= 16, error);
  }

  /** A strip of 26 mm of which the middle is bent by half a turn. */
  Sheets
  folded_sheet(const double radius)
  {
    const double length = 26e-3, arc = std::min(M_PI * radius, 1.),
                 leg = 0.5 * (length - arc);
    return sheet([=](const double a, const double b, const double t) {
      const double s = a * length;
      if (arc == 1)
        return Point<3>(s, 10e-3 * b, t);
      if (s < leg)
        return Point<3>(s, 10e-3 * b, t);
      if (s > leg + arc)
        return Point<3>(length - s, 10e-3 * b, 2 * radius - t);
      const double angle = (s - leg) / radius;
      return Point<3>(leg + (radius - t) * std::sin(angle),
                      10e-3 * b,
                      radius - (radius - t) * std::cos(angle));
    });
  }

  /** A sheet folded over: columns of the legs report the other leg, which is
   * nearer than all that the hole of the neighbours leaves. */
  void
  fold()
  {
    const double radius = 0.8e-3, arc = M_PI * radius, length = 26e-3;
    const Sheets folded = folded_sheet(radius), flat = folded_sheet(1e6);
    double error = 0, least = 1;
    for (const double exclusion : exclusions)
      {
        const auto gap = state(flat, folded, exclusion).gap;
        for (unsigned int i = 0; i <= 60; ++i)
          if (std::abs(i / 60. - 0.5) * length > 0.5 * arc + 1.5e-3)
            error = std::max(error,
                             std::abs(gap[21 * i + 10] - 2 * radius +
                                      Sheets::thickness));
        least = std::min(least, *std::min_element(gap.begin(), gap.end()));
      }
    check("legs of a fold face each other", error < 1e-12, error);
    check("nothing in a fold is nearer than its legs",
          least > 2 * radius - Sheets::thickness - 0.05e-3, // chords of the arc
          least);
  }

  /** A free edge against a face, and two free edges in one plane. */
  void
  edges()
  {
    const double gap = 0.7e-3, distance = gap + Sheets::thickness;
    for (const bool upright : {true, false})
      {
        Sheets sheets, apart;
        for (Sheets *s : {&sheets, &apart})
          {
            const double shift = s == &apart ? 0.1 : 0;
            s->add_rectangle({{20, 10}},
                             Point<3>(-10e-3, 0, 0),
                             {{upright ? 20e-3 : 10e-3, 10e-3}},
                             false);
            s->add(
              {{10, 10}},
              [=](const double a, const double b, const double t) {
                const double way = distance + 10e-3 * a;
                return upright ? Point<3>(t, 10e-3 * b, way + shift)
                               : Point<3>(way, 10e-3 * b, t + shift);
              },
              100e-6,
              false);
          }
        double error = 0;
        for (const double exclusion : exclusions)
          {
            const auto result         = state(apart, sheets, exclusion).gap;
            const unsigned int first  = 21 * 11,
                               facing = upright ? 10 * 11 : 20 * 11;
            for (unsigned int j = 0; j <= 10; ++j)
              for (const unsigned int c : {first + j, facing + j})
                error = std::max(error, std::abs(result[c] - gap));
            error =
              std::max(error,
                       gap - *std::min_element(result.begin(), result.end()));
          }
        check(upright ? "a free edge against a face" : "edge against edge",
              error < 1e-12,
              error);
      }
  }

  /** The half turn of a fold tightens until its legs touch, and the minima of
   * the distance move past the hole of the neighbours: penetration goes on
   * without jumps. */
  void
  shutting_fold()
  {
    const Sheets flat  = folded_sheet(1e6);
    const double onset = 0.3e-3;
    std::vector<double> last;
    double jump = 0, least = 1;
    for (double radius = 1.6e-3; radius > 0.5e-3; radius -= 0.01e-3)
      {
        auto gap = state(flat, folded_sheet(radius), 1.8e-3).gap;
        least    = std::min(least, *std::min_element(gap.begin(), gap.end()));
        for (double &g : gap)
          g = std::min(g, onset);
        for (unsigned int c = 0; c < last.size(); ++c)
          jump = std::max(jump, std::abs(gap[c] - last[c]));
        last = gap;
      }
    check("contact begins without a jump in a fold",
          jump < 0.06e-3 && least < 0.1e-3,
          jump);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  alone();
  two_sheets();
  oblique_sheets();
  fold();
  edges();
  shutting_fold();
}
