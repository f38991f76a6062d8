#include <coapt/metrics/contact_history.h>

#include <cmath>
#include <limits>

namespace coapt
{
  ContactHistory::ContactHistory(const unsigned int n_columns,
                                 const double clearance)
    : clearance(clearance)
    , first(n_columns, std::numeric_limits<double>::quiet_NaN())
  {
  }



  void
  ContactHistory::update(const double time, const std::vector<double> &gap)
  {
    for (unsigned int c = 0; c < gap.size(); ++c)
      if (std::isnan(first[c]) && gap[c] <= clearance)
        first[c] = time;
  }
} // namespace coapt
