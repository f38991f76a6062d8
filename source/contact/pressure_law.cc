#include <coapt/base/exceptions.h>
#include <coapt/contact/pressure_law.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt
{
  PressureLaw::PressureLaw(const ContactParameters &parameters)
  {
    switch (parameters.law)
      {
        case ContactLaw::linear:
          pieces.push_back({0., std::numeric_limits<double>::infinity()});
          break;
        case ContactLaw::exponential:
          add_exponential(parameters);
          break;
        case ContactLaw::table:
          add_table(parameters);
          break;
      }
  }



  // Up to overlap by half of the clearance; from there on it goes straight.
  void
  PressureLaw::add_exponential(const ContactParameters &parameters)
  {
    if (!(parameters.clearance > 0))
      throw InputError("Contact: Law exponential needs a Clearance above zero");
    const auto pressure = [&](const double s) {
      return parameters.pressure_at_touch * s * std::expm1(s) / std::expm1(1.);
    };
    const unsigned int n = 48;
    const double ds      = 1.5 / n;
    for (unsigned int i = 0; i < n; ++i)
      pieces.push_back({i * ds * parameters.clearance,
                        (pressure((i + 1) * ds) - pressure(i * ds)) /
                          (ds * parameters.clearance)});
  }



  void
  PressureLaw::add_table(const ContactParameters &parameters)
  {
    const auto &table = parameters.table;
    for (unsigned int i = 0; i + 1 < table.size(); ++i)
      pieces.push_back({table[0].gap - table[i].gap,
                        (table[i + 1].pressure - table[i].pressure) /
                          (table[i].gap - table[i + 1].gap)});
  }



  PressureLaw::Value
  PressureLaw::operator()(const double penetration,
                          const double largest_slope) const
  {
    Value value;
    for (unsigned int i = 0; i < pieces.size() && penetration > pieces[i].begin;
         ++i)
      {
        const double end =
          i + 1 < pieces.size() ? pieces[i + 1].begin : penetration;
        value.slope = std::min(pieces[i].slope, largest_slope);
        value.pressure +=
          value.slope * (std::min(penetration, end) - pieces[i].begin);
      }
    return value;
  }
} // namespace coapt
