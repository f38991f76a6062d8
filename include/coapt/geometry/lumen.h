#ifndef coapt_geometry_lumen_h
#define coapt_geometry_lumen_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

namespace coapt
{
  /** The space that blood fills. SI here, mm in the parameter file. */
  struct LumenParameters
  {
    /** How far the wall stands inside of the annulus line: the leaflet's root
     * is buried by that much (plus half a thickness on the ventricular side),
     * which is what seals it. */
    double inset = 0.75e-3;

    /** Lengths below and above the annulus plane z = 0. */
    double ventricular_length = 35e-3;
    double atrial_length      = 15e-3;

    /** How far the box of the fluid mesh reaches beyond the annulus. */
    double margin = 2e-3;

    /** Declares the entries of the subsection "Lumen". */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads them. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

  /**
   * The annulus outline, an ellipse, extruded along z ("fitted tube",
   * Khaledian 2023). Both ends are open: they are ends of the box, not walls.
   */
  class FittedTube
  {
  public:
    /**
     * @param semi_axis_x,semi_axis_y of the annulus (m); those of the wall are
     *   shorter by the inset.
     * @throws InputError if the inset leaves no lumen.
     */
    FittedTube(const LumenParameters &parameters,
               double semi_axis_x,
               double semi_axis_y);

    /** Distance to the wall (m), exact, negative in the lumen. Does not depend
     * on z. */
    double
    signed_distance(const dealii::Point<3> &p) const;

    /** Whether @p p is in the lumen: the sign only, and much cheaper. */
    bool
    inside(const dealii::Point<3> &p) const;

    /** Lower and upper corner of the box that contains the lumen, the annulus
     * and a margin sideways, and ends with the lumen in z. */
    dealii::Point<3>
    lower() const;
    dealii::Point<3>
    upper() const;

    /** Semi-axes of the wall (m). */
    double
    semi_axis_x() const;
    double
    semi_axis_y() const;

  private:
    double a, b;
    dealii::Point<3> corners[2];
  };
} // namespace coapt

#endif
