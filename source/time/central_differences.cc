#include <coapt/time/central_differences.h>

namespace coapt
{
  CentralDifferences::CentralDifferences(const Acceleration &acceleration,
                                         const double mass_damping,
                                         const PostStep &post_step)
    : acceleration(acceleration)
    , mass_damping(mass_damping)
    , post_step(post_step)
  {
  }



  void
  CentralDifferences::start(const double t, std::vector<double> &state)
  {
    this->state  = &state;
    current_time = t;
    last_step    = 0;
    A.assign(state.size() / 2, 0.);
  }



  void
  CentralDifferences::step(const double dt)
  {
    double *X = state->data();
    double *V = X + A.size();
    acceleration(current_time, X, V, A.data());
    const double h = 0.5 * (last_step + dt);
    const double keep =
      (1 - 0.5 * mass_damping * h) / (1 + 0.5 * mass_damping * h);
    const double add = h / (1 + 0.5 * mass_damping * h);
    for (unsigned int i = 0; i < A.size(); ++i)
      {
        V[i] = keep * V[i] + add * A[i];
        X[i] += dt * V[i];
      }
    current_time += dt;
    last_step = dt;
    ++steps;
    if (post_step)
      post_step(current_time, X, V, dt);
  }
} // namespace coapt
