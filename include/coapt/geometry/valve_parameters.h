#ifndef coapt_geometry_valve_parameters_h
#define coapt_geometry_valve_parameters_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace coapt
{
  /** How the leaflet is held at the annulus. */
  enum class AnnulusHold
  {
    /** Mid-surface nodes of the annulus line and of the root's outer rim. */
    straps,
    /** Mid-surface nodes of the annulus line only. */
    hinge,
    /** All nodes of the annulus line and of the root. */
    clamped
  };

  /** Direction of the fibres. */
  enum class FibreRule
  {
    /** Tangential and parallel to the annulus plane (horizontal). */
    parallel,
    /** Along the rows of the mesh, from commissure to commissure. */
    circumferential
  };

  /**
   * Shape, mesh and chordae of the generic mitral valve: a conical skirt on a
   * saddle-shaped annulus (after Hammer et al. 2011), hanging open. The frame
   * is the valve's: x from commissure to commissure, y towards the anterior
   * side, the ventricle at negative z. An angle t around the valve is 90
   * degrees at mid-anterior and -90 at mid-posterior. The valve is symmetric
   * to x = 0; what is given for one side is given for x > 0 ("right").
   *
   * All members are in SI units (m, rad, Pa); the parameter file has mm,
   * degrees and MPa.
   */
  struct ValveParameters
  {
    /** One degree in radians. */
    static constexpr double degree = dealii::numbers::PI / 180;

    /** Annulus: x = a cos t, y = b sin t, z = -(height/2) cos 2t. */
    double annulus_semi_axis_x = 17.5e-3;
    double annulus_semi_axis_y = 14e-3;
    double saddle_height       = 5e-3;

    /** Heights of the leaflet at mid-anterior, mid-posterior, commissures, and
     * the exponents of the profile between them. */
    double anterior_height    = 17.5e-3;
    double posterior_height   = 12.5e-3;
    double commissure_height  = 11.5e-3;
    double anterior_exponent  = 1.5;
    double posterior_exponent = 2.2;

    /** Angle of the right commissure (the left one mirrors it), and half the
     * extent of the part that is labelled commissure. */
    double commissure_angle      = 25 * degree;
    double commissure_half_width = 7.5 * degree;

    /** Inclination from -z towards the axis. */
    double anterior_cone_angle   = 20 * degree;
    double posterior_cone_angle  = 35 * degree;
    double commissure_cone_angle = 20 * degree;

    double thickness = 1e-3;

    /** Stretches of F0; one is none. */
    double circumferential_prestretch = 1.10;
    double radial_prestretch          = 1.15;

    /** Whether the tetrahedra have ten nodes (P2) in place of four (P1). The
     * nodes are the same: each two bricks in every direction make one. */
    bool quadratic = true;

    /** Bricks of neighbouring nodes around, along the height, and through the
     * thickness. */
    unsigned int n_circumferential = 88;
    unsigned int n_radial          = 12;
    unsigned int n_layers          = 2;

    /** Strip beyond the annulus line that is buried in the wall. */
    double root_length       = 1.25e-3;
    unsigned int n_root_rows = 2;

    AnnulusHold annulus_hold = AnnulusHold::straps;
    FibreRule fibre_rule     = FibreRule::parallel;

    /** Closed design (the shape from which the chordae are cut to length):
     * depth of the top of coaptation in the middle, its y there, its drop
     * below the commissures, its extent as a fraction of the distance between
     * the commissures, and the radial stretch. */
    double coaptation_depth      = 6e-3;
    double coaptation_y          = -3e-3;
    double coaptation_end_drop   = 1e-3;
    double coaptation_half_width = 0.9;
    double closed_stretch        = 1.2;

    /** Right papillary tip; the left one mirrors it. */
    dealii::Point<3> papillary_tip = dealii::Point<3>(11e-3, -5e-3, -30e-3);

    /** Primary chordae of the right side: angles at the free edge. */
    std::vector<double> primary_angles = {78 * degree,
                                          58 * degree,
                                          42 * degree,
                                          25 * degree,
                                          -15 * degree,
                                          -42 * degree,
                                          -75 * degree};

    /** Secondary chordae of the right side: angles, and fractions of the
     * height. */
    std::vector<double> secondary_angles  = {84 * degree,
                                             64 * degree,
                                             -55 * degree};
    std::vector<double> secondary_heights = {0.45, 0.45, 0.5};

    double primary_diameter   = 0.6e-3;
    double secondary_diameter = 1.0e-3;
    double chordae_modulus    = 40e6;

    /** Factors on the rest lengths that the closed design gives. */
    double primary_length_factor   = 0.97;
    double secondary_length_factor = 1.04;

    /** Radius of the sphere of influence of an attachment. */
    double influence_radius = 1.25e-3;

    /** Ids of chordae that are left out. */
    std::vector<std::string> removed_chordae;

    /** Declares the entries of the subsections "Valve" and "Chordae". */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads these entries. They are for a generated valve to check(): an
     * imported one uses a few of them only. */
    void
    parse_parameters(dealii::ParameterHandler &prm);

    /**
     * Checks what a bound on a single entry cannot.
     * @throws InputError if the number of elements around the valve is odd
     *   (tetrahedra would not conform at the seam) or, with quadratic
     *   elements, that in any other direction is odd or that around it no
     *   multiple of eight, if a size is not positive,
     *   or if the lists of the secondary chordae differ in length.
     */
    void
    check() const;
  };
} // namespace coapt

#endif
