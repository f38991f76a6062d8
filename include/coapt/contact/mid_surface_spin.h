#ifndef coapt_contact_mid_surface_spin_h
#define coapt_contact_mid_surface_spin_h

#include <coapt/contact/mid_surface.h>

#include <vector>

namespace coapt
{
  /**
   * How a mid-surface turns about its columns, and how couples act on it.
   *
   * A column and those around it, which share a quadrilateral with it, are
   * taken for point masses at their centres of mass. Their spin is that of the
   * rigid body of the same moment of momentum, and a couple accelerates them
   * like that body. So a rigid motion has its own spin, a couple does the work
   * couple times spin, and it adds no momentum and exactly its own moment. The
   * masses have a lever of the spacing of columns, not of the thickness: a
   * couple kicks nothing away.
   */
  class MidSurfaceSpin
  {
  public:
    /** @p surface must outlive this. */
    explicit MidSurfaceSpin(const MidSurface &surface);

    /** Takes positions @p X (m) and velocities @p V (m/s), both nodal triples,
     * for what is asked for from now on. */
    void
    set_state(const double *X, const double *V);

    /** Centre of mass of a column (m), where forces on it act. */
    const dealii::Point<3> &
    centre(const unsigned int column) const
    {
      return centres[column];
    }

    /** Spin of the surface at a column (rad/s). */
    const dealii::Tensor<1, 3> &
    spin(const unsigned int column);

    /** Bound of the spin that a unit impulse of a couple on the column leaves
     * (1/(kg m^2)). */
    double
    inverse_inertia(const unsigned int column);

    /** An impulse on a column (N s). */
    struct Impulse
    {
      unsigned int column;
      dealii::Tensor<1, 3> impulse;
    };

    /** The impulses on columns that make up the impulse of a @p couple (N m s)
     * on a column; valid until the next call. */
    const std::vector<Impulse> &
    impulses(const unsigned int column, const dealii::Tensor<1, 3> &couple);

  private:
    /** The columns around one, it included, as a rigid body. */
    struct Body
    {
      bool is_current = false;
      dealii::Point<3> centre;
      dealii::Tensor<2, 3> inverse_inertia;
      dealii::Tensor<1, 3> spin;
    };

    const Body &
    body(const unsigned int column);

    const MidSurface &surface;
    std::vector<std::vector<unsigned int>> around;
    std::vector<dealii::Point<3>> centres;
    std::vector<dealii::Tensor<1, 3>> velocities; // of the centres
    std::vector<Body> bodies;
    std::vector<Impulse> parts;
  };
} // namespace coapt

#endif
