#ifndef coapt_immersion_wall_offset_h
#define coapt_immersion_wall_offset_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>

namespace coapt
{
  /**
   * Depth below a wall, in fluid cells, at which a coupling point must lie for
   * the flow along the wall to come to rest at the wall itself.
   *
   * @p wall is the place of the wall in units of cells, whose faces are at the
   * whole numbers, and @p normal its unit normal towards the fluid.
   *
   * Velocities are interpolated linearly and forces are spread by the adjoint.
   * A force F per area at the height s in a cell (0 to 1) acts on the nodes
   * below and above with 1-s and s. With fluid at rest below and the shear rate
   * F/mu above, rest at s makes the node below run backwards, and the profile
   * of the flow above comes to zero not at s but at e = s + s(1-s). A wall at e
   * so needs its points at s = 1 - sqrt(1-e), which is up to a quarter of a
   * cell deeper. The depth is continuous from cell to cell, and without it a
   * wall that moves by d is felt to move by 2(1-s)d: nothing at one end of a
   * cell and twice as far at the other.
   *
   * Along an oblique wall points and nodes meet in all ways, and what counts is
   * the mean: with X and Y independent places under the kernel,
   * E|X-Y|/2, which for hats in all directions is 0.23 cells. Between the two
   * the fourth powers of the normal's components lead over.
   */
  template <int dim>
  double
  wall_offset(const dealii::Point<dim> &wall,
              const dealii::Tensor<1, dim> &normal)
  {
    const double oblique = 0.23;
    double aligned = 0, fourth_powers = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double fraction = wall[d] - std::floor(wall[d]);
        const double e        = normal[d] > 0 ? fraction : 1 - fraction;
        const double square   = normal[d] * normal[d];
        aligned += square * (e - 1 + std::sqrt(1 - e));
        fourth_powers += square * square;
      }
    const double share = (dim * fourth_powers - 1) / (dim - 1);
    return share * aligned + (1 - share) * oblique;
  }
} // namespace coapt

#endif
