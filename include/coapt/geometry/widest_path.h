#ifndef coapt_geometry_widest_path_h
#define coapt_geometry_widest_path_h

#include <deal.II/base/point.h>

#include <mpi.h>

#include <array>
#include <functional>
#include <vector>

namespace coapt
{
  /** The tightest place of the widest path through a valve. */
  struct WidestPath
  {
    /** Clear width there (m); 0 if the valve is shut, and the largest width
     * looked for if it is wider than that. */
    double width = 0;

    /** Where it is (m). */
    dealii::Point<3> position;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &width &position;
    }
  };

  /**
   * The widest path from below to above the leaflets: of all paths the one
   * whose least clearance (distance to the mid-surface minus half the
   * thickness) is largest. A flood fill on a grid that always proceeds at the
   * place of largest clearance. Unlike a projection along z it sees oblique
   * gaps. The wall only bounds the paths: beside it, a slit of width w counts
   * as 2 w.
   *
   * Between two sheets a grid point is rarely in the middle. It therefore
   * counts with the mean of its distances to both, if the middle is within
   * half a grid spacing: slits between parallel sheets come out exactly
   * whatever the grid.
   *
   * @param points,triangles the mid-surface (m, deformed).
   * @param thickness of the leaflet (m).
   * @param inside whether a point is in the lumen.
   * @param lower,upper the box that is searched: its lower z below, its upper
   *   z above all leaflets (else what is beyond is not seen).
   * @param spacing of the grid (m), reduced to 0.3 of the thickness if
   *   necessary.
   * @param largest_width widths (m) beyond this are not told apart; distances
   *   are computed in a band of (thickness + largest_width)/2 only.
   * @param communicator of ranks that call this with the same arguments and
   *   share the work.
   * @throws InputError if the box is empty or no point of its lower end is
   *   inside.
   */
  WidestPath
  widest_path(const std::vector<dealii::Point<3>> &points,
              const std::vector<std::array<unsigned int, 3>> &triangles,
              double thickness,
              const std::function<bool(const dealii::Point<3> &)> &inside,
              const dealii::Point<3> &lower,
              const dealii::Point<3> &upper,
              double spacing        = 0.25e-3,
              double largest_width  = 2e-3,
              MPI_Comm communicator = MPI_COMM_SELF);
} // namespace coapt

#endif
