#ifndef coapt_metrics_contact_history_h
#define coapt_metrics_contact_history_h

#include <deal.II/base/point.h>

#include <vector>

namespace coapt
{
  /** Columns of a leaflet at one time: the gap to the nearest other part of it
   * (m), the unit vector to that part (zero if there is none), and position
   * (m), velocity (m/s) and spin (rad/s) of the mid-surface. */
  struct ColumnMotion
  {
    const std::vector<double> &gap;
    const std::vector<dealii::Tensor<1, 3>> &normals;
    const std::vector<dealii::Point<3>> &points;
    const std::vector<dealii::Tensor<1, 3>> &velocities;
    const std::vector<dealii::Tensor<1, 3>> &spins;
  };

  /** Remembers when each column of a leaflet has touched another part of it for
   * the first time, and how far it has slid on that since. */
  class ContactHistory
  {
  public:
    /** Columns touch when their gap, the distance of the mid-surfaces less the
     * @p thickness, is at most @p clearance (m). */
    ContactHistory(const unsigned int n_columns,
                   const double clearance,
                   const double thickness);

    /** Takes the state at @p time (s) into account. The part that a column
     * slides on moves and turns like the column nearest to it; both sides are
     * compared half-way between them, where friction acts. */
    void
    update(const double time, const ColumnMotion &motion);

    /** First time of contact of each column (s); not a number if there was
     * none. */
    const std::vector<double> &
    first_times() const
    {
      return first;
    }

    /** Way that each column has slid while it touched (m). */
    const std::vector<double> &
    slips() const
    {
      return slip;
    }

    /** Saves or restores what has been so far. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &last_time &first &slip;
    }

  private:
    const double clearance, thickness;
    double last_time = 0;
    std::vector<double> first, slip;
  };
} // namespace coapt

#endif
