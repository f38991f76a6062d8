#ifndef coapt_contact_mid_surface_spin_h
#define coapt_contact_mid_surface_spin_h

#include <coapt/contact/mid_surface.h>

#include <vector>

namespace coapt
{
  /**
   * How a mid-surface turns about its columns, and how couples act on it.
   *
   * A quadrilateral with the diagonals a and b, which change at the rates a'
   * and b', and n = a x b has the spin
   *
   *   ((b' n) a - (a' n) b + (a' b - b' a) n/2) / n^2,
   *
   * that of a rigid motion if it moves like that. The spin at a column is the
   * mean of those of the quadrilaterals around it. It is linear in the
   * velocities of their corners, and a couple acts on these by the transpose:
   * its power is couple times spin, it adds no momentum and exactly its own
   * moment. The corners have a lever of the spacing of columns, not of the
   * thickness: a couple kicks nothing away.
   *
   * Only what is asked for is computed, once a step.
   */
  class MidSurfaceSpin
  {
  public:
    /** @p surface must outlive this. */
    explicit MidSurfaceSpin(const MidSurface &surface);

    /** Takes the columns' @p points (m) and the nodal velocities @p V (m/s)
     * for what is asked for from now on. Both must stay as they are. */
    void
    set_state(const std::vector<dealii::Point<3>> &points, const double *V);

    /** Velocity of a column (m/s). */
    const dealii::Tensor<1, 3> &
    velocity(const unsigned int column);

    /** Spin of the surface at a column (rad/s). */
    const dealii::Tensor<1, 3> &
    spin(const unsigned int column);

    /** Estimate of the spin that a unit impulse of a couple on the column
     * leaves there, in any direction (1/(kg m^2)): the trace of this relation
     * if its quadrilaterals answered each for itself. */
    double
    inverse_inertia(const unsigned int column);

    /** Impulse of a @p couple (N m s) on a column; they add up until they are
     * fetched. */
    void
    add_couple(const unsigned int column, const dealii::Tensor<1, 3> &couple);

    /** An impulse on a column (N s). */
    struct Impulse
    {
      unsigned int column;
      dealii::Tensor<1, 3> impulse;
    };

    /** The impulses on columns that make up all couples since the last call, in
     * no order and several a column; valid until the next call. */
    const std::vector<Impulse> &
    fetch_impulses();

  private:
    /** @p step is that in which the rest was computed. */
    struct ColumnState
    {
      unsigned int step = 0;
      dealii::Tensor<1, 3> velocity;
    };

    struct Rotation
    {
      unsigned int step = 0;
      dealii::Tensor<1, 3> spin;
      double inverse_inertia = 0;
    };

    /** A quadrilateral. */
    struct Quad
    {
      Rotation rotation;
      dealii::Tensor<1, 3> a, b; // diagonals
      dealii::Tensor<1, 3> n;    // their product by its square; may be zero
      dealii::Tensor<1, 3> couple;
      bool has_couple = false;
    };

    const Rotation &
    rotation(const unsigned int column);

    const Quad &
    current_quad(const unsigned int q);

    const MidSurface &surface;
    const std::vector<std::array<unsigned int, 4>> &corners;

    const std::vector<dealii::Point<3>> *points = nullptr;
    const double *V                             = nullptr;
    unsigned int step                           = 0;

    std::vector<ColumnState> columns;
    std::vector<Rotation> rotations; // of columns
    std::vector<Quad> quads;
    std::vector<unsigned int> with_couple;
    std::vector<Impulse> parts;
  };
} // namespace coapt

#endif
