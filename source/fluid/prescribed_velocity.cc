#include <coapt/fluid/prescribed_velocity.h>

#include <cmath>

namespace coapt
{
  template <int dim>
  void
  PrescribedVelocity<dim>::reinit(
    const std::vector<unsigned int> &nodes,
    const std::vector<dealii::Point<dim>> &positions,
    const Function &function,
    const double interval)
  {
    this->nodes     = nodes;
    this->positions = positions;
    this->function  = function;
    this->interval  = interval;
    derivative.clear();
  }



  template <int dim>
  void
  PrescribedVelocity<dim>::set_velocity(const double time,
                                        double *velocity_owned) const
  {
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const dealii::Tensor<1, dim> g = function(positions[i], time);
        for (int d = 0; d < dim; ++d)
          velocity_owned[dim * nodes[i] + d] = g[d];
      }
  }



  template <int dim>
  void
  PrescribedVelocity<dim>::set_acceleration(const double time,
                                            double *acceleration_owned) const
  {
    if (nodes.empty())
      return;
    const double index = std::floor(time / interval);
    if (derivative.empty() || index != sampled_interval)
      sample(index);
    const double s = time / interval - index;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (int d = 0; d < dim; ++d)
        {
          const auto &k                          = derivative[dim * i + d];
          acceleration_owned[dim * nodes[i] + d] = k[0] + s * (k[1] + s * k[2]);
        }
  }



  template <int dim>
  void
  PrescribedVelocity<dim>::sample(const double index) const
  {
    sampled_interval = index;
    derivative.resize(dim * nodes.size());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        std::array<dealii::Tensor<1, dim>, 4> g;
        for (int k = 0; k < 4; ++k)
          g[k] = function(positions[i], (index + k / 3.) * interval);
        // Lagrange's polynomials of thirds, differentiated
        for (int d = 0; d < dim; ++d)
          derivative[dim * i + d] = {
            {(-5.5 * g[0][d] + 9 * g[1][d] - 4.5 * g[2][d] + g[3][d]) /
               interval,
             (18 * g[0][d] - 45 * g[1][d] + 36 * g[2][d] - 9 * g[3][d]) /
               interval,
             (-13.5 * g[0][d] + 40.5 * g[1][d] - 40.5 * g[2][d] +
              13.5 * g[3][d]) /
               interval}};
      }
  }

  template class PrescribedVelocity<2>;
  template class PrescribedVelocity<3>;
} // namespace coapt
