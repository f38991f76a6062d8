#include <coapt/base/exceptions.h>
#include <coapt/base/number_table.h>
#include <coapt/laboratory/biaxial_protocol.h>

#include <algorithm>

namespace coapt
{
  BiaxialProtocol
  BiaxialProtocol::from_file(const std::string &file)
  {
    const auto names = NumberTable::column_names(file);
    BiaxialProtocol result;
    result.has_tensions =
      std::find(names.begin(), names.end(), "tension1_N_per_m") != names.end();
    const NumberTable table = result.has_tensions
      ? NumberTable::from_file(
          file, {"protocol", "tension1_N_per_m", "tension2_N_per_m"})
      : NumberTable::from_file(file, {"protocol", "stretch1", "stretch2"});
    for (unsigned int i = 0; i < table.rows.size(); ++i)
      {
        const auto &v = table.rows[i].values;
        if (!result.has_tensions && !(v[1] > 0 && v[2] > 0))
          throw InputError(table.place(i) + ": the stretches are " +
                           std::to_string(v[1]) + " and " +
                           std::to_string(v[2]) + ", both must be positive");
        result.states.push_back(
          {table.whole_number(i, 0), {{v[1], v[2]}}, table.place(i)});
      }
    return result;
  }
} // namespace coapt
