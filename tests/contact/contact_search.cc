// The search of contact on a folded, moving surface, on any number of ranks.

#include <coapt/contact/mid_surface_contact.h>
#include <coapt/geometry/triangle.h>

#include "sheets.h"
#include "tests.h"

#include <algorithm>
#include <memory>
#include <numeric>

using namespace coapt;
using dealii::Point;

namespace
{
  const double folded_length = 30e-3;

  /** A strip that is flat at phase 0 and rolled up to a spiral at phase 1, so
   * that parts touch that are far from each other along the strip. */
  Point<3>
  spiral(const double a, const double b, const double t, const double phase)
  {
    const double pitch  = phase * 1.3e-3 / (2 * M_PI);
    const double angle  = 2 * M_PI * 1.7 * phase * a;
    const double radius = 2.5e-3 + pitch * angle + t;
    const double wave   = 0.3e-3 * phase * std::sin(17 * b + 5 * a);
    if (phase == 0)
      return Point<3>(folded_length * a, 8e-3 * b, t);
    return Point<3>((radius + wave) * std::cos(angle),
                    8e-3 * b,
                    (radius + wave) * std::sin(angle));
  }

  Sheets
  strip()
  {
    Sheets sheets;
    sheets.add(
      {{40, 9}},
      [](const double a, const double b, const double t) {
        return spiral(a, b, t, 0);
      },
      folded_length * 8e-3,
      false);
    return sheets;
  }

  /** Positions of the nodes of strip() at a phase. */
  std::vector<double>
  positions(const double phase)
  {
    std::vector<double> X;
    for (unsigned int i = 0; i <= 40; ++i)
      for (unsigned int j = 0; j <= 9; ++j)
        for (unsigned int l = 0; l < 3; ++l)
          {
            const Point<3> p =
              spiral(i / 40., j / 9., (1. - l) * 0.5e-3, phase);
            X.insert(X.end(), {p[0], p[1], p[2]});
          }
    return X;
  }

  double
  distance(const Point<3> &p,
           const std::vector<Point<3>> &points,
           const std::array<unsigned int, 3> &triangle)
  {
    double weights[3];
    return p.distance(closest_point_on_triangle(p,
                                                points[triangle[0]],
                                                points[triangle[1]],
                                                points[triangle[2]],
                                                weights));
  }

  /** The columns of strip() anywhere in a box: triangles of all shapes and
   * sizes that cross each other. */
  std::vector<double>
  random_positions(const double side)
  {
    std::vector<double> X;
    for (unsigned int column = 0; column < 41 * 10; ++column)
      {
        Point<3> p;
        for (unsigned int d = 0; d < 3; ++d)
          p[d] = side * std::rand() / RAND_MAX;
        for (unsigned int l = 0; l < 3; ++l)
          X.insert(X.end(), {p[0], p[1], p[2] + (1. - l) * 0.5e-3});
      }
    return X;
  }

  /** Candidates at positions @p X against all triangles, one by one: none in
   * the radius is missing, no neighbour is among them, and the bounds hold. */
  void
  candidates(const std::string &what, const std::vector<double> &X)
  {
    const Sheets sheets = strip();
    const MidSurface surface(sheets.leaflet, sheets.mass);
    std::vector<Point<3>> reference(surface.n_columns()), points(reference);
    surface.positions(sheets.X.data(), reference);
    surface.positions(X.data(), points);

    std::vector<unsigned int> columns(surface.n_columns());
    std::iota(columns.begin(), columns.end(), 0);
    const double exclusion = 2e-3;
    const auto &triangles  = surface.triangles();

    CandidateSearch search(reference, triangles, exclusion, columns);
    for (const double radius : {0.9e-3, 2.2e-3, 20e-3})
      {
        search.find(points, radius);
        unsigned int wrong = 0, found = 0;
        for (const unsigned int c : columns)
          {
            std::vector<bool> is_candidate(triangles.size(), false);
            for (const auto &candidate : search.candidates(c))
              {
                const auto &triangle = triangles[candidate.triangle];
                is_candidate[candidate.triangle] = true;
                wrong +=
                  distance(reference[c], reference, triangle) <= exclusion;
                wrong += candidate.least_distance >
                  distance(points[c], points, triangle);
              }
            for (unsigned int t = 0; t < triangles.size(); ++t)
              if (distance(points[c], points, triangles[t]) <= radius &&
                  distance(reference[c], reference, triangles[t]) > exclusion)
                {
                  ++found;
                  wrong += !is_candidate[t];
                }
          }
        check("search finds what brute force finds" + what + ", radius " +
                std::to_string(std::lround(1e4 * radius)) + "e-4 m",
              wrong == 0 && found > 100,
              wrong);
      }
  }

  /** Whether no triangle that has all the corners of which the closest point
   * on @p triangle is made is nearer to @p p than that: all are asked. */
  bool
  faces(const Point<3> &p,
        const std::vector<Point<3>> &points,
        const std::vector<std::array<unsigned int, 3>> &triangles,
        const std::array<unsigned int, 3> &triangle)
  {
    double weights[3];
    const Point<3> closest = closest_point_on_triangle(p,
                                                       points[triangle[0]],
                                                       points[triangle[1]],
                                                       points[triangle[2]],
                                                       weights);
    const double reach     = p.distance(closest);
    for (const auto &other : triangles)
      {
        bool shares = true;
        for (unsigned int v = 0; v < 3; ++v)
          shares = shares &&
            (weights[v] == 0 ||
             std::count(other.begin(), other.end(), triangle[v]) == 1);
        if (shares && distance(p, points, other) < reach * (1 - 1e-12))
          return false;
      }
    return true;
  }

  /** Gaps while the strip rolls up, with candidates that are renewed only now
   * and then, against brute force at every step. */
  void
  gaps_while_moving()
  {
    Sheets sheets = strip();
    const MidSurface surface(sheets.leaflet, sheets.mass);
    std::vector<Point<3>> reference(surface.n_columns()), points(reference);
    surface.positions(sheets.X.data(), reference);
    ContactParameters parameters;
    parameters.search_interval = 1;
    MidSurfaceContact contact(
      sheets.leaflet, sheets.mass, Sheets::density, parameters, MPI_COMM_WORLD);
    const double exclusion =
      parameters.exclusion_distance + parameters.clearance;
    const double range = parameters.clearance + 0.5 * parameters.search_margin;

    double error      = 0;
    unsigned int near = 0;
    for (unsigned int step = 0; step <= 60; ++step)
      {
        const auto X = positions(0.7 + 0.3 * std::sin(0.07 * step));
        std::fill(sheets.V.begin(), sheets.V.end(), 0.);
        const auto result =
          contact.apply_impulse(X.data(), sheets.V.data(), 1e-5);
        if (step % 5 != 0)
          continue;
        surface.positions(X.data(), points);
        double least = MidSurfaceContact::no_gap;
        for (unsigned int c = 0; c < points.size(); ++c)
          {
            double nearest = 1;
            for (const auto &triangle : surface.triangles())
              if (distance(reference[c], reference, triangle) > exclusion &&
                  distance(points[c], points, triangle) < nearest &&
                  faces(points[c], points, surface.triangles(), triangle))
                nearest = distance(points[c], points, triangle);
            const double gap = nearest - Sheets::thickness <= range
              ? nearest - Sheets::thickness
              : MidSurfaceContact::no_gap;
            near += gap < range;
            error = std::max(error, std::abs(gap - contact.state().gap[c]));
            least = std::min(least, gap);
          }
        error = std::max(error, std::abs(least - result.min_gap));
      }
    check("gaps while moving", error < 1e-12 && near > 500, error);
  }

  /** Whatever the interval of the search, the same columns touch, with the same
   * forces: on the strip, and on one whose columns have been shaken at random,
   * both in motion. (Of triangles that share the nearest point any may be the
   * partner.) */
  void
  intervals()
  {
    for (const bool random : {false, true})
      {
        const Sheets sheets = strip();
        std::vector<std::unique_ptr<MidSurfaceContact>> contacts;
        for (const unsigned int interval : {1, 4, 10})
          {
            ContactParameters parameters;
            parameters.search_interval = interval;
            contacts.push_back(
              std::make_unique<MidSurfaceContact>(sheets.leaflet,
                                                  sheets.mass,
                                                  Sheets::density,
                                                  parameters,
                                                  MPI_COMM_WORLD));
          }
        const double clearance = ContactParameters().clearance;
        const auto noise       = random_positions(random ? 0.8e-3 : 0.);
        unsigned int different = 0, touching = 0, changes = 0, last = 0;
        double error = 0;
        for (unsigned int step = 0; step < 200; ++step)
          {
            auto X = positions(0.7 + 0.3 * std::sin(0.02 * step));
            for (unsigned int i = 0; random && i < X.size(); ++i)
              X[i] += std::cos(0.05 * step) * noise[i];
            std::vector<std::vector<double>> V(3, sheets.V);
            unsigned int pairs[3];
            for (unsigned int i = 0; i < 3; ++i)
              pairs[i] =
                contacts[i]->apply_impulse(X.data(), V[i].data(), 1e-6).pairs;
            double largest = 0;
            for (const double v : V[0])
              largest = std::max(largest, std::abs(v));
            for (unsigned int i = 1; i < 3; ++i)
              {
                const auto &one = contacts[0]->state().gap,
                           &two = contacts[i]->state().gap;
                different += pairs[i] != pairs[0];
                for (unsigned int j = 0; j < V[0].size(); ++j)
                  error =
                    std::max(error, std::abs(V[i][j] - V[0][j]) / largest);
                for (unsigned int c = 0; c < one.size(); ++c)
                  if (one[c] < clearance || two[c] < clearance)
                    different += std::abs(one[c] - two[c]) > 1e-12;
              }
            touching += pairs[0];
            changes += pairs[0] != last;
            last = pairs[0];
          }
        const std::string name = random ? " on a random surface" : "";
        check("same pairs with intervals of 1, 4 and 10" + name,
              different == 0 && touching > 10000 && changes > 100,
              different);
        check("same velocities" + name, error < 1e-9, error);
      }
  }

  /** With as many elements within the radius, a column has as many
   * candidates, and as many triangles are looked at, however many columns there
   * are. */
  void
  cost()
  {
    std::vector<double> candidates_per_column, visited_per_column;
    for (const unsigned int n : {20u, 40u, 80u})
      {
        Sheets sheets;
        for (const double side : {-1., 1.})
          sheets.add_rectangle({{n, n}},
                               Point<3>(0, 0, side * 0.5 * 20e-3 / n),
                               {{20e-3, 20e-3}},
                               false);
        const MidSurface surface(sheets.leaflet, sheets.mass);
        std::vector<Point<3>> points(surface.n_columns());
        surface.positions(sheets.X.data(), points);
        std::vector<unsigned int> columns(points.size());
        std::iota(columns.begin(), columns.end(), 0);
        CandidateSearch search(points,
                               surface.triangles(),
                               0.1 * 20e-3 / n,
                               columns);
        search.find(points, 2.5 * 20e-3 / n);
        double sum = 0;
        for (const unsigned int c : columns)
          sum += search.candidates(c).size();
        candidates_per_column.push_back(sum / columns.size());
        visited_per_column.push_back(double(search.n_visited()) /
                                     columns.size());
      }
    // Columns at the rim have fewer; their share halves each time.
    const auto growth = [&](const std::vector<double> &per_column,
                            const unsigned int i) {
      return per_column[i + 1] / per_column[i] - 1;
    };
    check("candidates of a column do not grow with their number",
          growth(candidates_per_column, 1) < 0.06 &&
            growth(candidates_per_column, 1) <
              0.55 * growth(candidates_per_column, 0),
          growth(candidates_per_column, 1));
    check("neither do triangles that are looked at",
          growth(visited_per_column, 1) < 0.1,
          growth(visited_per_column, 1));
    check("of which a fifth are candidates",
          candidates_per_column[2] > 0.2 * visited_per_column[2],
          candidates_per_column[2] / visited_per_column[2]);
  }

  /** The velocities must not depend on the number of ranks: the communicator
   * of one rank is the reference. */
  void
  ranks()
  {
    std::vector<Sheets> sheets(2, strip());
    MidSurfaceContact alone(sheets[0].leaflet,
                            sheets[0].mass,
                            Sheets::density,
                            ContactParameters(),
                            MPI_COMM_SELF);
    MidSurfaceContact together(sheets[1].leaflet,
                               sheets[1].mass,
                               Sheets::density,
                               ContactParameters(),
                               MPI_COMM_WORLD);
    double error = 0, largest = 0;
    unsigned int pairs = 0;
    for (unsigned int step = 0; step < 20; ++step)
      {
        const auto X = positions(0.9 + 0.005 * step);
        const auto a = alone.apply_impulse(X.data(), sheets[0].V.data(), 1e-6);
        const auto b =
          together.apply_impulse(X.data(), sheets[1].V.data(), 1e-6);
        pairs += a.pairs == b.pairs ? a.pairs : 0;
        for (unsigned int i = 0; i < X.size(); ++i)
          {
            error = std::max(error, std::abs(sheets[0].V[i] - sheets[1].V[i]));
            largest = std::max(largest, std::abs(sheets[0].V[i]));
          }
      }
    check("same velocities on any number of ranks",
          pairs > 1000 && error < 1e-12 * largest,
          error / largest);

    const auto &V = sheets[1].V;
    auto lowest(V), highest(V);
    const int n = V.size();
    MPI_Allreduce(
      V.data(), lowest.data(), n, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    MPI_Allreduce(
      V.data(), highest.data(), n, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    check("velocities replicated to the bit", lowest == highest);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  candidates("", positions(1));
  candidates(" on a random surface", random_positions(25e-3));
  gaps_while_moving();
  intervals();
  cost();
  ranks();
}
