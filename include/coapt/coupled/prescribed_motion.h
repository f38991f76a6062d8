#ifndef coapt_coupled_prescribed_motion_h
#define coapt_coupled_prescribed_motion_h

#include <coapt/coupled/displacement_history.h>
#include <coapt/geometry/leaflet.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace coapt
{
  /** Motion of what is held: subsection "Motion". */
  struct MotionParameters
  {
    /** File with the displacements; without one, nothing held moves. */
    std::string file;

    /** Declares the subsection. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads it. */
    void
    parse_parameters(dealii::ParameterHandler &prm);
  };

  /**
   * Displacements over time of held nodes: of the annulus, of papillary tips.
   *
   * They come from a CSV file with the columns node, time_s, ux_mm, uy_mm,
   * uz_mm. An entry of "node" is the name of a set of held nodes, such as
   * "annulus", or the number of a column of the leaflet, all held nodes of
   * which move. The rows of an entry have increasing times; those of different
   * entries may alternate.
   */
  class PrescribedMotion
  {
  public:
    /** Nothing moves. */
    PrescribedMotion() = default;

    /**
     * @throws InputError with file and line if the file is no such table, if a
     * set or a column does not exist or is not held, if a node is named twice,
     * if times do not increase, or if an entry does not start from zero at
     * time zero.
     */
    PrescribedMotion(const std::string &file, const Leaflet &leaflet);

    /** Numbers of the nodes that move. */
    const std::vector<unsigned int> &
    nodes() const
    {
      return moving;
    }

    /** Sets the positions @p X (m), and unless it is a null pointer, velocities
     * @p V (m/s), of the nodes that move at time @p t (s). */
    void
    apply(const double t, double *X, double *V) const;

  private:
    /** Nodes that have a displacement in common. */
    struct Group
    {
      DisplacementHistory history;
      std::vector<unsigned int> nodes;
    };

    std::vector<Group> groups;
    std::vector<unsigned int> moving;
    std::vector<dealii::Point<3>> reference; // of all nodes
  };
} // namespace coapt

#endif
