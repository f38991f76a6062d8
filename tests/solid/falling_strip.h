#ifndef coapt_tests_solid_falling_strip_h
#define coapt_tests_solid_falling_strip_h

#include "bricks.h"

/** A strip of leaflet thickness, clamped at one end, that a load in proportion
 * to the mass bends from rest until about its largest deflection: computed
 * here, and written down for CalculiX. */
namespace falling_strip
{
  using namespace bricks;

  constexpr double length = 8e-3, width = 4e-3, thickness = 1e-3; // m
  constexpr double mu = 5e3, bulk_factor = 4;                     // Pa, -
  constexpr double density = 1060;                                // kg/m^3
  constexpr double gravity = 30;                                  // m/s^2

  /** Isochoric neo-Hookean; of the volumetric energy CalculiX has another form,
   * with the same bulk modulus. */
  inline HolzapfelGasserOgden
  material()
  {
    HolzapfelGasserOgden law;
    law.C10         = mu / 2;
    law.K1          = 0;
    law.bulk_factor = bulk_factor;
    return law;
  }

  inline SimplexMesh<3>
  mesh()
  {
    return box({{16, 8, 2}}, [](const Point<3> &x) {
      return Point<3>(length * x[0],
                      width * (x[1] - 0.5),
                      thickness * (x[2] - 0.5));
    });
  }

  template <typename Element>
  struct Strip : Body<Element>
  {
    explicit Strip(const SimplexMesh<3> &mesh)
      : Body<Element>(mesh, material(), density, Point<3>(1, 0, 0))
    {
      for (unsigned int node = 0; node < this->points.size(); ++node)
        {
          if (this->points[node][0] < 1e-9)
            for (unsigned int d = 0; d < 3; ++d)
              this->held[3 * node + d] = true;
          else
            this->load[3 * node + 2] = -gravity * this->solid.mass()[node];
        }
    }

    /** Nodes of the free end. */
    std::vector<unsigned int>
    end() const
    {
      std::vector<unsigned int> nodes;
      for (unsigned int node = 0; node < this->points.size(); ++node)
        if (this->points[node][0] > length - 1e-9)
          nodes.push_back(node);
      return nodes;
    }

    /** Mean displacement of the free end after @p n_steps of length @p dt
     * (m). */
    Tensor<1, 3>
    end_displacement(const unsigned int n_steps, const double dt) const
    {
      std::vector<double> state = this->positions();
      state.resize(2 * state.size(), 0.);
      CentralDifferences integrator(
        [&](double, const double *X, const double *V, double *A) {
          this->acceleration(X, V, A);
        },
        0.,
        nullptr);
      integrator.start(0., state);
      for (unsigned int step = 0; step < n_steps; ++step)
        integrator.step(dt);
      const std::vector<unsigned int> nodes = end();
      Tensor<1, 3> mean;
      for (const unsigned int node : nodes)
        for (unsigned int d = 0; d < 3; ++d)
          mean[d] +=
            (state[3 * node + d] - this->points[node][d]) / nodes.size();
      return mean;
    }
  };
} // namespace falling_strip

#endif
