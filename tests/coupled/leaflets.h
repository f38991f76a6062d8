#ifndef coapt_tests_coupled_leaflets_h
#define coapt_tests_coupled_leaflets_h

#include <coapt/contact/facet_contact.h>

#include <limits>

#include "coupled_case.h"

/** Two elastic leaflets with chordae in a plane channel, under a pressure at
 * its upper x end that rises and may be reversed. */
struct Leaflets
{
  double cell        = 1e-3; // of the fluid, m
  double element     = 0.5e-3;
  double length      = 40e-3; // of the channel
  double height      = 20e-3; // of the channel
  double thickness   = 1e-3;
  double sound_speed = 50;
  double impedance   = 15900; // of both ends, Pa s/m
  double clearance   = 1.25;  // of contact, in cells
  double viscosity   = 0;     // of the solid, Pa s

  double pressure = 16e3;
  double ramp     = 20e-3; // s
  double reversal = 1;     // time at which the pressure begins to fall, s
  double reversed = -1e3;  // pressure 10 ms later

  // of the lower leaflet and of the upper one
  std::array<double, 2> root   = {{13.1e-3, 13.1e-3}};
  std::array<double, 2> extent = {{12e-3, 12e-3}};
  std::array<double, 2> angle  = {{38., 38.}}; // with the wall, degrees

  /** Pressure at the ventricular end. */
  double
  driving_pressure(const double t) const
  {
    const double fall = smooth_ramp(t - reversal, 10e-3);
    return pressure * smooth_ramp(t, ramp) * (1 - fall) + reversed * fall;
  }

  /** The leaflets as images of two unit squares, the upper one with the second
   * coordinate from 2 to 3; the first coordinate is through the thickness, with
   * the facing sides at 0 and 1. */
  Block<2>
  block() const
  {
    Block<2> both;
    for (const int b : {0, 1})
      {
        const double a     = angle[b] * M_PI / 180;
        const Block<2> one = make_block<2>(
          {{static_cast<unsigned int>(std::lround(thickness / element)),
            static_cast<unsigned int>(std::lround(extent[b] / element))}},
          [&](const dealii::Point<2> &r) {
            const double side = (b == 0 ? r[0] - 0.5 : 0.5 - r[0]) * thickness;
            const double s    = r[1] * extent[b];
            // the root lies along the wall
            const double flat = std::max(0., 1 - 6 * r[1]);
            const double x    = root[b] + s * std::cos(a) +
              side * ((1 - flat) * std::sin(a) + flat / std::sin(a));
            const double y = s * std::sin(a) - (1 - flat) * side * std::cos(a);
            return dealii::Point<2>(x, b == 0 ? y : height - y);
          });
        const unsigned int shift = both.mesh.points.size();
        for (auto cell : one.mesh.cells)
          {
            for (unsigned int &node : cell)
              node += shift;
            both.mesh.cells.push_back(cell);
          }
        both.mesh.points.insert(both.mesh.points.end(),
                                one.mesh.points.begin(),
                                one.mesh.points.end());
        for (const auto &r : one.unit)
          both.unit.emplace_back(r[0], r[1] + 2 * b);
      }
    return both;
  }

  CoupledSetup<2>
  setup() const
  {
    CoupledSetup<2> s;
    const Leaflets leaflets = *this;
    s.upper                 = dealii::Point<2>(length, height);
    s.cells           = {{static_cast<unsigned int>(std::lround(length / cell)),
                          static_cast<unsigned int>(std::lround(height / cell))}};
    s.boundaries.type = {{coapt::FluidBoundary::pressure_end,
                          coapt::FluidBoundary::pressure_end,
                          coapt::FluidBoundary::no_slip,
                          coapt::FluidBoundary::no_slip}};
    s.boundaries.pressure[0] = [](double) { return 0.; };
    s.boundaries.pressure[1] = [=](const double t) {
      return leaflets.driving_pressure(t);
    };
    s.boundaries.impedance[0] = s.boundaries.impedance[1] = impedance;
    s.fluid.sound_speed                                   = sound_speed;
    s.block                                               = block();
    s.pinned  = s.block.nodes_where([](const dealii::Point<2> &r) {
      return std::abs(r[1]) < 1e-9 || std::abs(r[1] - 2) < 1e-9;
    });
    s.spacing = 0.5 * cell;

    s.solid.material           = "neo-Hookean";
    s.solid.viscosity          = viscosity;
    s.solid.neo_hookean.mu     = 500e3;
    s.solid.neo_hookean.lambda = 2.5e6;
    return s;
  }
};

/** The leaflets in their fluid, with chordae and contact. */
class LeafletsCase
{
public:
  explicit LeafletsCase(const Leaflets &leaflets)
    : leaflets(leaflets)
    , coupled(leaflets.setup())
    , contact(coupled.block.mesh,
              coapt::outer_facets(coupled.block.mesh),
              coupled.solid.mass(),
              leaflets.setup().pinned,
              contact_law(leaflets),
              0.5 * leaflets.thickness,
              MPI_COMM_WORLD)
  {
    for (const int b : {0, 1})
      {
        line[b] = middle_nodes(b);
        add_chorda(b, 1., 5e-3, 9e-3);
        add_chorda(b, 0.7, 1.8e-3, 7.6e-3);
      }
    coupled.system.add_load(
      [this](double, const double *X, const double *V, double *F) {
        add_tensions(X, V, F);
      });
    coupled.system.set_impulse(
      [this](const double *X, double *V, const double dt) {
        impulse += dt * contact.apply_impulse(X, V, dt).normal_force;
      });
  }

  /** A step; the flow is that out of the atrial end, integrated. */
  void
  step(const double dt)
  {
    coupled.step(dt);
    outflow += dt * coupled.flow(0);
  }

  double
  time() const
  {
    return coupled.integrator.time();
  }

  std::vector<double>
  positions() const
  {
    return coupled.system.solid_positions(coupled.y.data());
  }

  /** Position of the tip of a leaflet. */
  dealii::Point<2>
  tip(const unsigned int b) const
  {
    return middle(positions(), line[b].back());
  }

  /** Volume that has passed the leaflets since the start: what has left through
   * the atrial end less what they have swept. */
  double
  passed_volume() const
  {
    return outflow + area_behind(positions()) -
      area_behind(as_array(coupled.block.mesh.points));
  }

  /** Smallest distance between both surfaces. */
  double
  smallest_gap() const
  {
    const auto X    = positions();
    double smallest = std::numeric_limits<double>::max();
    for (const int b : {0, 1})
      for (const auto &node : line[b])
        for (unsigned int i = 0; i + 1 < line[1 - b].size(); ++i)
          {
            const auto p = middle(X, node), a = middle(X, line[1 - b][i]);
            const auto edge = middle(X, line[1 - b][i + 1]) - a;
            const double s =
              std::min(1., std::max(0., (p - a) * edge / edge.norm_square()));
            smallest = std::min(smallest, (p - a - s * edge).norm());
          }
    return smallest - leaflets.thickness;
  }

  Leaflets leaflets;
  CoupledCase<2> coupled;
  double impulse = 0; // of contact, since the start, N s
  double outflow = 0; // since the start, m^2

private:
  using Pair = std::array<unsigned int, 2>; // of nodes, one on each side

  struct Chorda
  {
    unsigned int node;
    dealii::Point<2> muscle;
    double length;
  };

  static coapt::ContactParameters
  contact_law(const Leaflets &leaflets)
  {
    coapt::ContactParameters law;
    law.clearance     = leaflets.clearance * leaflets.cell;
    law.max_stiffness = std::numeric_limits<double>::max();
    law.search_margin = leaflets.cell;
    return law;
  }

  /** Nodes on both sides from the root of a leaflet to its tip. */
  std::vector<Pair>
  middle_nodes(const unsigned int b) const
  {
    std::vector<Pair> result;
    for (unsigned int n = 0; n < coupled.block.unit.size(); ++n)
      {
        const auto &r = coupled.block.unit[n];
        if (r[1] < 2. * b || r[1] > 2. * b + 1.5)
          continue;
        if (r[0] == 0)
          result.push_back({{n, n}});
        else if (r[0] == 1)
          result.back()[1] = n;
      }
    return result;
  }

  static dealii::Point<2>
  middle(const std::vector<double> &X, const Pair &nodes)
  {
    dealii::Point<2> x;
    for (const unsigned int n : nodes)
      x += 0.5 * dealii::Tensor<1, 2>({X[2 * n], X[2 * n + 1]});
    return x;
  }

  /** A chorda that is taut when the node at @p s of the length is that far from
   * the root along the channel and from the wall. */
  void
  add_chorda(const unsigned int b,
             const double s,
             const double along,
             const double across)
  {
    const auto from_wall = [&](const double y) {
      return b == 0 ? y : leaflets.height - y;
    };
    const double root = leaflets.root[b];
    const dealii::Point<2> muscle(root + 22e-3, from_wall(6e-3));
    const dealii::Point<2> taut(root + along, from_wall(across));
    const unsigned int i = std::lround(s * (line[b].size() - 1));
    chordae.push_back(
      {line[b][i][b == 0 ? 1 : 0], muscle, (taut - muscle).norm()});
  }

  /** Springs that only pull, with a dash-pot against their own vibration. */
  void
  add_tensions(const double *X, const double *V, double *F) const
  {
    const double stiffness = 4e5;
    for (const Chorda &chorda : chordae)
      {
        const unsigned int n = chorda.node;
        const dealii::Tensor<1, 2> way(
          {chorda.muscle[0] - X[2 * n], chorda.muscle[1] - X[2 * n + 1]});
        const double distance = way.norm();
        if (distance < chorda.length)
          continue;
        const double rate =
          -(way[0] * V[2 * n] + way[1] * V[2 * n + 1]) / distance;
        const double tension = stiffness * (distance - chorda.length) +
          0.1 * std::sqrt(stiffness * coupled.solid.mass()[n]) * rate;
        for (int d = 0; d < 2; ++d)
          F[2 * n + d] += std::max(0., tension) * way[d] / distance;
      }
  }

  /** Area between x = 0 and the leaflets, whose tips are joined. */
  double
  area_behind(const std::vector<double> &X) const
  {
    std::vector<dealii::Point<2>> way;
    for (const Pair &nodes : line[0])
      way.push_back(middle(X, nodes));
    for (auto nodes = line[1].rbegin(); nodes != line[1].rend(); ++nodes)
      way.push_back(middle(X, *nodes));
    double area = 0;
    for (unsigned int i = 0; i + 1 < way.size(); ++i)
      area += 0.5 * (way[i][0] + way[i + 1][0]) * (way[i + 1][1] - way[i][1]);
    return area;
  }

  coapt::FacetContact<2> contact;
  std::array<std::vector<Pair>, 2> line;
  std::vector<Chorda> chordae;
};

#endif
