#ifndef coapt_solid_materials_node_gradients_h
#define coapt_solid_materials_node_gradients_h

#include <coapt/solid/small_matrix.h>

namespace coapt
{
  /**
   * Bound of half the second derivative of the isochoric invariant I4 over
   * J^(-2/3), for displacements of unit norm: with the stretched fibre f and
   * the spatial gradient L,
   * |L f|^2 - 4/3 tr L (f . L f) + (2/9 (tr L)^2 + 1/3 tr(L L)) |f|^2.
   * @p along is the sum over the nodes of the squares of the gradients along
   * the fibre in the reference, @p spatial of the spatial gradients, @p I4 the
   * square of the fibre's stretch.
   */
  template <typename Number>
  inline Number
  fibre_curvature(const Number &along, const Number &spatial, const Number &I4)
  {
    return along + (4. / 3.) * square_root(along * spatial * I4) +
      (5. / 9.) * I4 * spatial;
  }

  /**
   * What the bounds of an element's stiffness are made of: the vectors h_a by
   * which a scalar s of the deformation gradient follows the nodal
   * displacements, ds = sum_a h_a . u_a. A term w ds^2 of the energy's second
   * derivative is then at most w sum_a |h_a|^2 for displacements of unit norm.
   */
  template <typename Number>
  struct NodeGradients
  {
    /** Of the shape functions in the current configuration (1/m). */
    Number spatial[4][3];

    /** @p gradients [node][component] are those in the reference (1/m). */
    NodeGradients(const SmallMatrix<3, Number> &cofactor,
                  const Number &J,
                  const Number (&gradients)[4][3])
    {
      const Number inverse = 1. / J;
      for (int a = 0; a < 4; ++a)
        {
          multiply(cofactor, gradients[a], spatial[a]);
          for (Number &component : spatial[a])
            component *= inverse;
        }
    }

    /** Sum of the squares of the spatial gradients. */
    Number
    square_sum() const
    {
      Number sum{};
      for (const auto &g : spatial)
        for (const Number &component : g)
          sum += component * component;
      return sum;
    }

    /**
     * The vectors h_a = J^(-2/3) (@p linear[a] - @p value/3 spatial[a]) of an
     * isochoric invariant: J^(-2/3) = @p iso times one that is quadratic in
     * the deformation gradient, which has twice this @p value and follows the
     * displacements by twice @p linear. The result is half the derivative.
     */
    void
    isochoric(const Number &iso,
              const Number &value,
              const Number (&linear)[4][3],
              Number (&h)[4][3]) const
    {
      for (int a = 0; a < 4; ++a)
        for (int i = 0; i < 3; ++i)
          h[a][i] = iso * (linear[a][i] - value / 3. * spatial[a][i]);
    }
  };

  /** Sum of the squares of all entries. */
  template <typename Number>
  inline Number
  square_sum(const Number (&h)[4][3])
  {
    Number sum{};
    for (const auto &vector : h)
      for (const Number &component : vector)
        sum += component * component;
    return sum;
  }
} // namespace coapt

#endif
