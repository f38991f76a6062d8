#include <coapt/base/exceptions.h>
#include <coapt/base/number_table.h>
#include <coapt/laboratory/biaxial_data.h>

namespace coapt
{
  BiaxialData
  BiaxialData::from_file(const std::string &file,
                         const StressMeasure measure,
                         const std::string &unit)
  {
    const double factor     = unit == "MPa" ? 1e6 : unit == "kPa" ? 1e3 : 1;
    const NumberTable table = NumberTable::from_file(
      file, {"protocol", "stretch1", "stretch2", "stress1", "stress2"});
    BiaxialData data;
    data.measure = measure;
    bool loaded  = false;
    for (unsigned int i = 0; i < table.rows.size(); ++i)
      {
        const auto &v = table.rows[i].values;
        if (!(v[1] > 0 && v[2] > 0))
          throw InputError(table.place(i) + ": the stretches are " +
                           std::to_string(v[1]) + " and " +
                           std::to_string(v[2]) + ", both must be positive");
        data.points.push_back({table.whole_number(i, 0),
                               {{v[1], v[2]}},
                               {{factor * v[3], factor * v[4]}}});
        loaded = loaded || v[3] != 0 || v[4] != 0;
      }
    if (!loaded)
      throw InputError(file + ": all stresses are zero");
    return data;
  }
} // namespace coapt
