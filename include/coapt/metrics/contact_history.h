#ifndef coapt_metrics_contact_history_h
#define coapt_metrics_contact_history_h

#include <vector>

namespace coapt
{
  /** Remembers when each column of a leaflet has touched another part of it for
   * the first time. */
  class ContactHistory
  {
  public:
    /** Columns touch when their gap is at most @p clearance (m). */
    ContactHistory(const unsigned int n_columns, const double clearance);

    /** Takes the gaps (m) at @p time (s) into account. */
    void
    update(const double time, const std::vector<double> &gap);

    /** First time of contact of each column (s); not a number if there was
     * none. */
    const std::vector<double> &
    first_times() const
    {
      return first;
    }

  private:
    const double clearance;
    std::vector<double> first;
  };
} // namespace coapt

#endif
