#ifndef coapt_tests_structure_integrator_h
#define coapt_tests_structure_integrator_h

#include <coapt/structure/structure_system.h>
#include <coapt/time/central_differences.h>

/** Central differences that advance the @p system, which must live as long. */
inline coapt::CentralDifferences
integrator_of(coapt::StructureSystem &system)
{
  return coapt::CentralDifferences(
    [&](const double t, const double *X, const double *V, double *A) {
      system.acceleration(t, X, V, A);
    },
    system.mass_damping,
    [&](const double t, double *X, double *V, const double dt) {
      system.move_held_nodes(t, X, V, dt);
      system.finish_step(X, V, dt);
    });
}

#endif
